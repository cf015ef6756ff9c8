// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/solver/gas.hpp"

// Points and vectors as one number an axis, so that one text serves the plane and space.

namespace leonhard::solver {

[[nodiscard]] inline Axes<2> axes(Vec2 v) { return {v.x, v.y}; }
[[nodiscard]] inline Axes<3> axes(const Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Axes<2> axes(Point2 p) { return {p.x, p.y}; }
[[nodiscard]] inline Axes<3> axes(const Point3& p) { return {p.x, p.y, p.z}; }

[[nodiscard]] inline Vec2 vector_of(const Axes<2>& a) { return {a[0], a[1]}; }
[[nodiscard]] inline Vec3 vector_of(const Axes<3>& a) { return {a[0], a[1], a[2]}; }

}  // namespace leonhard::solver
