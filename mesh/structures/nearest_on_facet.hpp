// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/box_tree.hpp"

namespace leonhard::mesh {

/// Squared distances from a point, in scaled coordinates and rounded, so that those of a box bound those of all points in
/// it from below: each operation rounds monotonically.
template <class Point>
class ScaledDistance {
 public:
  /// scale  a power of two
  ScaledDistance(const Point& p, double scale) : scale_(scale), p_(scaled(p)) {}

  [[nodiscard]] double operator()(const Point& q) const { return to_scaled(scaled(q)); }
  [[nodiscard]] double operator()(const Box<Point>& box) const {
    const Point low = scaled(box.low), high = scaled(box.high);
    double sum = 0;
    for (const auto x : axes_of<Point>) {
      const double away = std::max({0.0, low.*x - p_.*x, p_.*x - high.*x});
      sum += away * away;
    }
    return sum;
  }
  [[nodiscard]] double to_scaled(const Point& q) const {
    double sum = 0;
    for (const auto x : axes_of<Point>) {
      const double away = std::max(q.*x - p_.*x, p_.*x - q.*x);
      sum += away * away;
    }
    return sum;
  }
  [[nodiscard]] Point scaled(Point q) const {
    for (const auto x : axes_of<Point>) q.*x *= scale_;
    return q;
  }
  [[nodiscard]] const Point& scaled_point() const { return p_; }

 private:
  double scale_;
  Point p_;
};

/// The point of an edge or a triangle that is nearest to a point.
template <class Point>
struct OnFacet {
  static constexpr std::size_t corners = axes_of<Point>.size();
  double distance2 = std::numeric_limits<double>::infinity();  ///< scaled
  Point point;                                                 ///< scaled; in the facet's box
  std::array<double, corners> weights{};                       ///< of the facet's corners: >= 0, their sum 1
};

/// The nearest point of the segment ab to p as a weight of b, in [0, 1].
template <class Point>
[[nodiscard]] double nearest_on_segment(const Point& p, const Point& a, const Point& b) {
  const auto along = b - a;
  const double length2 = dot(along, along);
  return length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
}

/// Take a point of a facet, given by the weights of its corners in scaled coordinates, if it is nearer than the best one.
template <class Point, std::size_t N>
void take_if_nearer(const ScaledDistance<Point>& distance2, const std::array<Point, N>& corners,
                    const std::array<double, N>& weights, OnFacet<Point>& best) {
  Point q{};
  Box<Point> box;
  for (std::size_t i = 0; i < N; ++i) {
    for (const auto x : axes_of<Point>) q.*x += weights[i] * corners[i].*x;
    box.include(corners[i]);
  }
  for (const auto x : axes_of<Point>) q.*x = std::clamp(q.*x, box.low.*x, box.high.*x);
  if (const double d2 = distance2.to_scaled(q); d2 < best.distance2) best = {d2, q, weights};
}

[[nodiscard]] inline OnFacet<Point2> nearest_on_facet(const ScaledDistance<Point2>& distance2,
                                                      const std::array<Point2, 2>& edge) {
  const std::array<Point2, 2> corners{distance2.scaled(edge[0]), distance2.scaled(edge[1])};
  const double t = nearest_on_segment(distance2.scaled_point(), corners[0], corners[1]);
  OnFacet<Point2> best;
  take_if_nearer(distance2, corners, {1 - t, t}, best);
  return best;
}

[[nodiscard]] inline OnFacet<Point3> nearest_on_facet(const ScaledDistance<Point3>& distance2,
                                                      const std::array<Point3, 3>& face) {
  const std::array<Point3, 3> c{distance2.scaled(face[0]), distance2.scaled(face[1]),
                                distance2.scaled(face[2])};
  const Point3& p = distance2.scaled_point();
  OnFacet<Point3> best;
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = nearest_on_segment(p, c[i], c[(i + 1) % 3]);
    std::array<double, 3> weights{};
    weights[i] = 1 - t;
    weights[(i + 1) % 3] = t;
    take_if_nearer(distance2, c, weights, best);
  }
  const Vec3 u = c[1] - c[0], v = c[2] - c[0], to_p = p - c[0], normal = cross(u, v);
  const double area2 = dot(normal, normal);
  if (!(area2 > 0)) return best;
  const double w1 = dot(cross(to_p, v), normal) / area2, w2 = dot(cross(u, to_p), normal) / area2;
  if (w1 > 0 && w2 > 0 && w1 + w2 < 1) take_if_nearer(distance2, c, {1 - w1 - w2, w1, w2}, best);
  return best;
}

}  // namespace leonhard::mesh
