// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/swap_criterion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "leonhard/delaunay/plane/exact_triangle.hpp"
#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/exact_sum.hpp"

namespace leonhard::delaunay::criterion {
namespace {

/// The corners about an edge from -> to; left and right are opposite it.
struct Quadrilateral {
  VertexId from, to, left, right;

  Quadrilateral(const GhostTriangulation& in, SideId s)
      : from(in.origin(s)), to(in.destination(s)), left(in.apex(s)), right(in.apex(in.twin(s))) {}
};

using Corners = std::array<VertexId, 3>;

/// The two triangles at the edge as it is, and at the other diagonal.
std::array<Corners, 2> before(const Quadrilateral& q) {
  return {{{q.from, q.to, q.left}, {q.to, q.from, q.right}}};
}
std::array<Corners, 2> after(const Quadrilateral& q) {
  return {{{q.right, q.left, q.from}, {q.left, q.right, q.to}}};
}

exact::Triangle triangle(std::span<const Point2> points, const Corners& c) {
  return {points[c[0].index()], points[c[1].index()], points[c[2].index()]};
}

// ---- largest angles ----

struct Interval {
  double low, high;
  [[nodiscard]] bool is_below(const Interval& other) const { return high < other.low; }
};

/// About the cotangent of the triangle's largest angle; none if doubles cannot tell. Differences and products
/// have relative errors of 3u together, sums u more: 1e-15 is 9u. The guard is more than underflow can add.
std::optional<Interval> cotangent_of_max_angle(const exact::Triangle& t) {
  constexpr double relative = 1e-15, guard = 1e-290;
  const std::array side{t[2] - t[1], t[0] - t[2], t[1] - t[0]};
  const double area2 = cross(side[0], side[1]);
  const double area2_error =
      relative * (std::abs(side[0].x * side[1].y) + std::abs(side[0].y * side[1].x)) + guard;
  if (!(area2 > 4 * area2_error)) return std::nullopt;
  double least = 0, error = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 u = side[(i + 1) % 3], v = side[(i + 2) % 3];
    const double at_corner = -dot(u, v);
    if (i == 0 || at_corner < least) least = at_corner;
    error = std::max(error, relative * (std::abs(u.x * v.x) + std::abs(u.y * v.y)) + guard);
  }
  // (x + dx) / (y + dy) is within 2 (|dx| + |x/y| |dy|) / y of x / y where |dy| < y / 4.
  const double cotangent = least / area2;
  const double bound =
      2 * (error + std::abs(cotangent) * area2_error) / area2 + relative * std::abs(cotangent);
  if (!std::isfinite(cotangent + bound)) return std::nullopt;
  return Interval{cotangent - bound, cotangent + bound};
}

std::optional<Interval> cotangent_of_max_angle(std::span<const Point2> points,
                                               const std::array<Corners, 2>& triangles) {
  const auto one = cotangent_of_max_angle(triangle(points, triangles[0])),
             two = cotangent_of_max_angle(triangle(points, triangles[1]));
  if (!one || !two) return std::nullopt;
  return Interval{std::min(one->low, two->low), std::min(one->high, two->high)};
}

mpq_class exact_cotangent_of_max_angle(std::span<const Point2> points,
                                       const std::array<Corners, 2>& triangles) {
  return std::min(exact::cotangent_of_max_angle(triangle(points, triangles[0])),
                  exact::cotangent_of_max_angle(triangle(points, triangles[1])));
}

// ---- lengths ----

mpq_class exact_squared_distance(const Point2& p, const Point2& q) {
  const mpq_class x = mpq_class(p.x) - mpq_class(q.x), y = mpq_class(p.y) - mpq_class(q.y);
  return x * x + y * y;
}

/// Is pq shorter than rs? 4 roundings in each squared length; 1e-15 is 9u.
bool is_shorter(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  const double pq = dot(q - p, q - p), rs = dot(s - r, s - r);
  if (const auto sign = kernel::sign_if_beyond(pq - rs, 1e-15 * (pq + rs)); sign.is_certain())
    return *sign == Sign::negative;
  return exact_squared_distance(p, q) < exact_squared_distance(r, s);
}

// ---- sums of costs ----

/// Is the exact sum of the first numbers less than that of the second? False if one of them is not finite.
template <std::size_t N>
bool sum_is_less(const std::array<double, N>& first, const std::array<double, N>& second) {
  mesh::ExactSum difference;
  for (std::size_t i = 0; i < N; ++i) {
    if (!std::isfinite(first[i]) || !std::isfinite(second[i])) return false;
    difference.add_product(first[i], 1);
    difference.add_product(second[i], -1);
  }
  return difference.sign() == Sign::negative;
}

/// The linear function over a triangle, its corners in lexicographic order so that the rounding does not
/// depend on which comes first.
struct LinearFunction {
  double x_slope, y_slope;  ///< times area2
  double area2;             ///< not 0 unless it underflowed

  LinearFunction(std::span<const Point2> points, std::span<const double> values, Corners c) {
    std::sort(c.begin(), c.end(),
              [&](VertexId v, VertexId w) { return points[v.index()] < points[w.index()]; });
    const Vec2 u = points[c[1].index()] - points[c[0].index()],
               v = points[c[2].index()] - points[c[0].index()];
    const double du = values[c[1].index()] - values[c[0].index()],
                 dv = values[c[2].index()] - values[c[0].index()];
    x_slope = du * v.y - dv * u.y;
    y_slope = dv * u.x - du * v.x;
    area2 = cross(u, v);
  }
  [[nodiscard]] double roughness() const {
    return (x_slope * x_slope + y_slope * y_slope) / (2 * std::abs(area2));
  }
  /// The upward unit normal of its graph.
  [[nodiscard]] Vec3 normal() const {
    const double x = x_slope / area2, y = y_slope / area2, length = std::sqrt(x * x + y * y + 1);
    return {-x / length, -y / length, 1 / length};
  }
};

double distance(const Vec3& u, const Vec3& v) {
  const Vec3 w = u - v;
  return std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
}

/// The costs of the five edges of two triangles: the common one and the four around.
class BendCosts {
 public:
  BendCosts(const GhostTriangulation& in, std::span<const Point2> points, std::span<const double> values,
            SideId s)
      : q_(in, s),
        points_(points),
        values_(values),
        around_{in.next(s), in.previous(s), in.next(in.twin(s)), in.previous(in.twin(s))} {
    for (std::size_t i = 0; i < 4; ++i) beyond_[i] = normal_beyond(in, around_[i]);
  }
  /// The sides around lie, in order, to -> left, left -> from, from -> right, right -> to.
  [[nodiscard]] std::array<double, 5> as_it_is() const {
    const auto [left, right] = normals(before(q_));
    return costs(left, right, {left, left, right, right});
  }
  [[nodiscard]] std::array<double, 5> swapped() const {
    const auto [at_from, at_to] = normals(after(q_));
    return costs(at_from, at_to, {at_to, at_from, at_from, at_to});
  }

 private:
  [[nodiscard]] Vec3 normal(const Corners& c) const { return LinearFunction(points_, values_, c).normal(); }
  [[nodiscard]] std::array<Vec3, 2> normals(const std::array<Corners, 2>& triangles) const {
    return {normal(triangles[0]), normal(triangles[1])};
  }
  [[nodiscard]] std::optional<Vec3> normal_beyond(const GhostTriangulation& in, SideId s) const {
    const AnyTriangleId t = in.triangle(in.twin(s));
    if (in.is_ghost(t)) return std::nullopt;
    return normal({in.corner(t, 0), in.corner(t, 1), in.corner(t, 2)});
  }
  [[nodiscard]] std::array<double, 5> costs(const Vec3& one, const Vec3& two,
                                            const std::array<Vec3, 4>& inside) const {
    std::array<double, 5> all{distance(one, two), 0, 0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i)
      if (beyond_[i]) all[i + 1] = distance(inside[i], *beyond_[i]);
    return all;
  }
  Quadrilateral q_;
  std::span<const Point2> points_;
  std::span<const double> values_;
  std::array<SideId, 4> around_;
  std::array<std::optional<Vec3>, 4> beyond_;  ///< none outside
};

}  // namespace

bool Delaunay::improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const {
  const Quadrilateral q(in, s);
  return kernel::incircle_perturbed(points[q.from.index()], points[q.to.index()], points[q.left.index()],
                                    points[q.right.index()]) == Sign::positive;
}

bool MaxMinAngle::improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const {
  const Quadrilateral q(in, s);
  return kernel::incircle(points[q.from.index()], points[q.to.index()], points[q.left.index()],
                          points[q.right.index()]) == Sign::positive;
}

bool MinMaxAngle::improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const {
  const Quadrilateral q(in, s);
  const auto here = cotangent_of_max_angle(points, before(q)),
             there = cotangent_of_max_angle(points, after(q));
  if (here && there && here->is_below(*there)) return true;
  if (here && there && there->is_below(*here)) return false;
  return exact_cotangent_of_max_angle(points, before(q)) < exact_cotangent_of_max_angle(points, after(q));
}

bool MinEdgeLength::improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const {
  const Quadrilateral q(in, s);
  return is_shorter(points[q.left.index()], points[q.right.index()], points[q.from.index()],
                    points[q.to.index()]);
}

bool MinRoughness::improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const {
  const Quadrilateral q(in, s);
  const auto costs = [&](const std::array<Corners, 2>& triangles) {
    return std::array{LinearFunction(points, values, triangles[0]).roughness(),
                      LinearFunction(points, values, triangles[1]).roughness()};
  };
  return sum_is_less(costs(after(q)), costs(before(q)));
}

bool AngleBetweenNormals::improves(const GhostTriangulation& in, std::span<const Point2> points,
                                   SideId s) const {
  const BendCosts costs(in, points, values, s);
  return sum_is_less(costs.swapped(), costs.as_it_is());
}

}  // namespace leonhard::delaunay::criterion
