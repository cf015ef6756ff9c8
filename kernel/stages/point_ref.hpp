// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "leonhard/kernel/arithmetic/ball.hpp"
#include "leonhard/kernel/arithmetic/homogeneous.hpp"
#include "leonhard/kernel/double_double.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::kernel {

/// A point's coordinates to about 100 bits, with what is not known of them.
template <class Point>
using Coordinates = std::array<NumberBall<DoubleDouble>, dimension<Point>>;

/// The words in which an intersection that does not exist is refused.
struct Refusal {
  const char *where, *problem, *remedy;
};

/// A point that is known by its defining points alone, see homogeneous.hpp, together with the balls in which its
/// coordinates lie: what LineCrossing, LinePlaneCrossing and ThreePlaneCrossing share.
template <class Point, std::size_t Count>
class ImplicitPoint {
 public:
  [[nodiscard]] std::span<const Point> defining_points() const { return points_; }
  [[nodiscard]] const Coordinates<Point>& coordinates() const { return coordinates_; }

 protected:
  /// throws  InputError with the points if one of them is not finite or there is no such intersection
  ImplicitPoint(const std::array<Point, Count>& defining_points, const Refusal& refusal);

 private:
  std::array<Point, Count> points_;
  Coordinates<Point> coordinates_;
};

/// A reference to an explicit or implicit point, made without being asked for where a predicate takes it. Like a
/// std::string_view it must not outlive the point.
template <class Point>
class PointRef {
 public:
  PointRef(const Point& p) : defining_(&p, 1) {}
  template <std::size_t Count>
  PointRef(const ImplicitPoint<Point, Count>& p)
      : defining_(p.defining_points()), coordinates_(&p.coordinates()) {}

  [[nodiscard]] bool is_explicit() const { return coordinates_ == nullptr; }
  /// The point itself if it is explicit.
  [[nodiscard]] std::span<const Point> defining_points() const { return defining_; }
  [[nodiscard]] const Point& explicit_point() const { return defining_[0]; }

  [[nodiscard]] NumberBall<DoubleDouble> coordinate(std::size_t axis) const {
    if (!is_explicit()) return (*coordinates_)[axis];
    return {{{kernel::coordinate(explicit_point(), axis), 0}}, 0};
  }
  [[nodiscard]] Coordinates<Point> coordinates() const {
    Coordinates<Point> all;
    for (std::size_t axis = 0; axis < all.size(); ++axis) all[axis] = coordinate(axis);
    return all;
  }

 private:
  std::span<const Point> defining_;
  const Coordinates<Point>* coordinates_ = nullptr;
};

using PointRef2 = PointRef<Point2>;
using PointRef3 = PointRef<Point3>;

}  // namespace leonhard::kernel
