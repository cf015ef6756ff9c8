// SPDX-License-Identifier: MIT
// Bisections that look at coordinates alone: across the longest side of a box, across the principal axis.
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/partition/recursive_bisection.hpp"
#include "leonhard/graph/spectral/linear_algebra.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using detail::Halving;
using detail::Indices;
using detail::RecursiveBisection;

using Place = std::array<double, 3>;
Place place(Point2 p) { return {p.x, p.y, 0}; }
Place place(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Point>
void check(std::span<const Point> points, std::span<const std::uint32_t> weights, std::uint32_t parts) {
  if (parts == 0) throw InputError("parts", "a partition into 0 parts", "ask for at least 1");
  if (!weights.empty() && weights.size() != points.size())
    throw InputError(
        "weights",
        std::to_string(weights.size()) + " weights for " + std::to_string(points.size()) + " points",
        "give one each, or none");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Place p = place(points[i]);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
    std::string words = std::to_string(p[0]) + ", " + std::to_string(p[1]);
    if constexpr (std::is_same_v<Point, Point3>) words += ", " + std::to_string(p[2]);
    throw InputError("points", "point " + std::to_string(i) + " is (" + words + ")",
                     "give finite coordinates");
  }
}

/// Puts the smallest by key in front.
template <class Key>
std::size_t order_by(Indices vertices, const Halving& halving, const Key& key) {
  if (halving.whole_order)
    std::ranges::sort(vertices, {}, key);
  else
    std::ranges::nth_element(vertices, vertices.begin() + static_cast<std::ptrdiff_t>(halving.in_front), {},
                             key);
  return halving.in_front;
}

/// The axis along which the box of some points is longest, the first among equals.
template <class Point>
std::size_t longest_axis(std::span<const Point> points, Indices vertices) {
  Place low = place(points[vertices[0]]), high = low;
  for (const std::uint32_t v : vertices) {
    const Place p = place(points[v]);
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  std::size_t longest = 0;  // lengths are halved, so that no finite box overflows
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
    if (high[i] / 2 - low[i] / 2 > high[longest] / 2 - low[longest] / 2) longest = i;
  return longest;
}

template <class Point>
Partition coordinate_bisection(std::span<const Point> points, std::uint32_t parts,
                               std::span<const std::uint32_t> weights) {
  check(points, weights, parts);
  const auto arrange = [&](Indices vertices, const Halving& halving) {
    const std::size_t axis = longest_axis(points, vertices);
    return order_by(vertices, halving, [&, axis](std::uint32_t v) {
      const Place p = place(points[v]);
      return std::tuple(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3], v);
    });
  };
  return RecursiveBisection(weights, arrange)(points.size(), parts);
}

/// Where some points spread most: the eigenvector of their covariance, its largest component positive.
///
/// scale  coordinates are divided by it, so that nothing overflows
template <class Point>
Place principal_axis(std::span<const Point> points, Indices vertices, double scale) {
  const auto scaled = [&](std::uint32_t v) {
    Place p = place(points[v]);
    for (double& x : p) x /= scale;
    return p;
  };
  Place mean{};
  for (const std::uint32_t v : vertices)
    for (std::size_t i = 0; i < 3; ++i) mean[i] += scaled(v)[i];
  for (double& x : mean) x /= static_cast<double>(vertices.size());
  std::vector<double> minus_covariance(9, 0.0);  // its smallest eigenvalue comes first
  for (const std::uint32_t v : vertices) {
    const Place p = scaled(v);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) minus_covariance[3 * i + j] -= (p[i] - mean[i]) * (p[j] - mean[j]);
  }
  const detail::DenseEigen eigen = detail::symmetric_eigen(std::move(minus_covariance), 3);
  const auto vector = eigen.vector(0);
  Place axis{vector[0], vector[1], vector[2]};
  const double largest = *std::ranges::max_element(axis, {}, [](double x) { return std::abs(x); });
  if (largest < 0)
    for (double& x : axis) x = -x;
  return axis;
}

template <class Point>
Partition inertial_bisection(std::span<const Point> points, std::uint32_t parts,
                             std::span<const std::uint32_t> weights) {
  check(points, weights, parts);
  double scale = 0;
  for (const Point& p : points)
    for (const double x : place(p)) scale = std::max(scale, std::abs(x));
  if (scale == 0) scale = 1;
  const auto arrange = [&](Indices vertices, const Halving& halving) {
    const Place axis = principal_axis(points, vertices, scale);
    return order_by(vertices, halving, [&](std::uint32_t v) {
      const Place p = place(points[v]);
      return std::pair(p[0] / scale * axis[0] + p[1] / scale * axis[1] + p[2] / scale * axis[2], v);
    });
  };
  return RecursiveBisection(weights, arrange)(points.size(), parts);
}

}  // namespace

Partition recursive_coordinate_bisection(std::span<const Point2> points, std::uint32_t parts,
                                         std::span<const std::uint32_t> weights) {
  return coordinate_bisection(points, parts, weights);
}
Partition recursive_coordinate_bisection(std::span<const Point3> points, std::uint32_t parts,
                                         std::span<const std::uint32_t> weights) {
  return coordinate_bisection(points, parts, weights);
}

Partition recursive_inertial_bisection(std::span<const Point2> points, std::uint32_t parts,
                                       std::span<const std::uint32_t> weights) {
  return inertial_bisection(points, parts, weights);
}
Partition recursive_inertial_bisection(std::span<const Point3> points, std::uint32_t parts,
                                       std::span<const std::uint32_t> weights) {
  return inertial_bisection(points, parts, weights);
}

}  // namespace leonhard::graph
