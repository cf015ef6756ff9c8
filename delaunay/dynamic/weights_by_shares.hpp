// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/delaunay/location.hpp"
#include "leonhard/kernel/point.hpp"

/// Convex combinations from lengths, areas or volumes, in the plane and in space: in floating point where that will do,
/// else in rational numbers.
namespace leonhard::delaunay {

[[nodiscard]] inline double rounded(double x) { return x; }
[[nodiscard]] inline double rounded(const mpq_class& x) { return x.get_d(); }

[[nodiscard]] inline double sum_of_magnitudes(Vec2 v) { return std::abs(v.x) + std::abs(v.y); }
[[nodiscard]] inline double sum_of_magnitudes(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Divide shares by their sum.
template <class Number>
void divide_by_sum(const std::vector<Number>& shares, std::vector<VertexWeight>& weights) {
  Number sum = 0;
  for (const Number& share : shares) sum += share;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Number part = shares[i] / sum;
    weights[i].weight = rounded(part);
  }
}

/// Whether weights are a convex combination of p up to rounding errors that matter to nobody.
template <class Point>
[[nodiscard]] bool is_plausible(std::span<const Point> points, const Point& p,
                                const std::vector<VertexWeight>& weights) {
  constexpr double tolerance = 0x1p-33;
  decltype(p - p) sum{};
  double size = 0, total = 0;
  for (const auto& [vertex, weight] : weights) {
    if (!(weight >= -tolerance)) return false;
    const auto arm = points[vertex.index()] - p;
    sum = sum + weight * arm;
    size += std::abs(weight) * sum_of_magnitudes(arm);
    total += weight;
  }
  return sum_of_magnitudes(sum) <= tolerance * size && std::isfinite(size) &&
         std::abs(total - 1) <= tolerance;
}

/// Fill the weights of p, whose vertices are there already.
///
/// shares_in  shares_in(double{}) and shares_in(mpq_class{}) give one share a weight, of any one scale
template <class Point, class Shares>
void weigh_by_shares(std::span<const Point> points, const Point& p, const Shares& shares_in,
                     std::vector<VertexWeight>& weights) {
  divide_by_sum(shares_in(double{}), weights);
  if (!is_plausible(points, p, weights)) divide_by_sum(shares_in(mpq_class{}), weights);
  for (VertexWeight& w : weights) w.weight = std::max(w.weight, 0.0);
}

}  // namespace leonhard::delaunay
