// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>

#include "leonhard/kernel/point.hpp"

/// Figures of one triangle as rational numbers, exact for all finite coordinates. Microseconds each.
namespace leonhard::delaunay::exact {

/// Corners counter-clockwise, of positive area.
using Triangle = std::array<Point2, 3>;

/// The cotangent of the triangle's smallest angle: the greatest of its three.
[[nodiscard]] mpq_class cotangent_of_min_angle(const Triangle& t);

/// The cotangent of the triangle's largest angle: the least of its three.
[[nodiscard]] mpq_class cotangent_of_max_angle(const Triangle& t);

/// The square of the radius of the smallest circle that encloses the triangle.
[[nodiscard]] mpq_class squared_containment_radius(const Triangle& t);

/// The integral over the triangle of the squared gradient of the linear function with these values at its
/// corners, (3.2) of Barth's notes; the unit is that of the values squared.
[[nodiscard]] mpq_class roughness(const Triangle& t, const std::array<double, 3>& values);

}  // namespace leonhard::delaunay::exact
