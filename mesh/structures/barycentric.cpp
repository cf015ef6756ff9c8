// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/barycentric.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace leonhard::mesh {
namespace {

std::array<double, 2> coordinates(const Point2& p) { return {p.x, p.y}; }
std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// Up to three rows of up to three numbers.
template <class Number>
using Rows = std::array<std::array<Number, 3>, 3>;

/// The determinant of m rows of m numbers; with sizes of numbers and std::plus, the sum of its terms' sizes.
template <class Number, class Minus>
Number determinant(const Rows<Number>& r, std::size_t m, const Minus& minus) {
  const auto minor = [&](std::size_t i, std::size_t j) -> Number {
    return minus(Number(r[1][i] * r[2][j]), Number(r[1][j] * r[2][i]));
  };
  if (m == 1) return r[0][0];
  if (m == 2) return minus(Number(r[0][0] * r[1][1]), Number(r[0][1] * r[1][0]));
  return r[0][0] * minor(1, 2) + r[0][1] * minor(2, 0) + r[0][2] * minor(0, 1);
}

/// Corners of a simplex of dimension m = count - 1 in a space of d axes, and a point strictly inside it.
template <std::size_t d>
struct PlacedSimplex {
  std::size_t count;
  std::array<std::array<double, d>, d + 1> corners;
  std::array<double, d> p;

  /// The axes that the simplex is projected along: its dimension's worth, in a good choice first.
  [[nodiscard]] std::vector<std::array<std::size_t, 3>> choices_of_axes() const {
    std::vector<std::array<std::size_t, 3>> choices;
    std::array<double, d> extent{};  // of an edge along an axis, or of a triangle's projection along it
    if (count == d + 1) return {{0, 1, 2}};
    for (std::size_t i = 0; i < d; ++i) {
      const std::size_t j = (i + 1) % d, k = (i + 2) % d;
      const auto edge = [&](std::size_t c, std::size_t axis) { return corners[c][axis] - corners[0][axis]; };
      extent[i] = std::abs(count == 2 ? edge(1, i) : edge(1, j) * edge(2, k) - edge(1, k) * edge(2, j));
      choices.push_back(count == 2 ? std::array{i, j, k} : std::array{j, k, i});
    }
    std::array<std::size_t, d> order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return extent[i] > extent[j]; });
    std::vector<std::array<std::size_t, 3>> sorted;
    for (const std::size_t i : order) sorted.push_back(choices[i]);
    return sorted;
  }

  /// The vectors from p to all corners but one.
  template <class Number>
  [[nodiscard]] Rows<Number> rows_without(std::size_t corner, const std::array<std::size_t, 3>& axes) const {
    Rows<Number> rows{};
    std::size_t row = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == corner) continue;
      for (std::size_t k = 0; k + 1 < count; ++k)
        rows[row][k] = Number(corners[i][axes[k]]) - Number(p[axes[k]]);
      ++row;
    }
    return rows;
  }
};

/// Determinants of doubles over their sum; false if rounding, overflow or underflow may have harmed them.
///
/// Error bound. The determinants' errors are at most 8u times their terms' sizes (predicates3.hpp), so if these add up to
/// no more than 2^8 times the sum of the determinants, a quotient is off by less than 2^-53 2^3 2^8 2 = 2^-41.
template <std::size_t d>
bool weigh_in_doubles(const PlacedSimplex<d>& simplex, const std::array<std::size_t, 3>& axes,
                      std::array<double, d + 1>& weights) {
  double sum = 0, sizes = 0;
  for (std::size_t i = 0; i < simplex.count; ++i) {
    Rows<double> rows = simplex.template rows_without<double>(i, axes);
    weights[i] = std::abs(determinant(rows, simplex.count - 1, std::minus<>()));
    for (auto& row : rows) {
      for (double& x : row) x = std::abs(x);
    }
    sum += weights[i];
    sizes += determinant(rows, simplex.count - 1, std::plus<>());
  }
  if (!(sum > 0x1p-900 && sizes <= 0x1p8 * sum && sizes < 0x1p1000)) return false;
  for (double& w : weights) w /= sum;
  return true;
}

/// The same without error but for the last rounding; false if the projection is of no volume.
template <std::size_t d>
bool weigh_exactly(const PlacedSimplex<d>& simplex, const std::array<std::size_t, 3>& axes,
                   std::array<double, d + 1>& weights) {
  std::array<mpq_class, d + 1> exact;
  mpq_class sum = 0;
  for (std::size_t i = 0; i < simplex.count; ++i) {
    const Rows<mpq_class> rows = simplex.template rows_without<mpq_class>(i, axes);
    exact[i] = abs(determinant(rows, simplex.count - 1, std::minus<>()));
    sum += exact[i];
  }
  if (sum == 0) return false;
  for (std::size_t i = 0; i < simplex.count; ++i) weights[i] = mpq_class(exact[i] / sum).get_d();
  return true;
}

template <class Point, std::size_t N>
VertexWeights<N> weights_of(const PerId<VertexId, Point>& points,
                            const std::array<MaybeId<VertexId>, N>& span, const Point& p) {
  VertexWeights<N> result;
  PlacedSimplex<N - 1> simplex{0, {}, coordinates(p)};
  for (const MaybeId<VertexId> v : span) {
    if (!v) break;
    result.vertices[simplex.count] = *v;
    simplex.corners[simplex.count++] = coordinates(points[*v]);
  }
  result.count = simplex.count;
  if (simplex.count == 1) result.weights[0] = 1;
  if (simplex.count < 2) return result;
  const auto choices = simplex.choices_of_axes();
  if (weigh_in_doubles(simplex, choices.front(), result.weights)) return result;
  for (const auto& axes : choices) {
    if (weigh_exactly(simplex, axes, result.weights)) break;
  }
  return result;
}

}  // namespace

VertexWeights<3> barycentric_weights(const PerId<VertexId, Point2>& points,
                                     const std::array<MaybeId<VertexId>, 3>& span, const Point2& p) {
  return weights_of(points, span, p);
}
VertexWeights<4> barycentric_weights(const PerId<VertexId, Point3>& points,
                                     const std::array<MaybeId<VertexId>, 4>& span, const Point3& p) {
  return weights_of(points, span, p);
}

}  // namespace leonhard::mesh
