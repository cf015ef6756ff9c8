// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <span>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/weighted_point.hpp"

/// The predicates of predicates.hpp, predicates3.hpp and power.hpp evaluated in GMP's rational numbers, straight
/// from their definitions: the oracle of tests and fuzzers. The predicates themselves do without.
/// Slow (microseconds a call), right for every finite double; each double converts to a rational without error.
/// Same sign conventions.
namespace leonhard::kernel::exact {

[[nodiscard]] Sign orient2d(Point2 a, Point2 b, Point2 c);
[[nodiscard]] Sign incircle(Point2 a, Point2 b, Point2 c, Point2 d);
[[nodiscard]] Sign in_diametral_circle(Point2 p, Point2 a, Point2 b);
[[nodiscard]] Sign compare_distance(Point2 p, Point2 a, Point2 b);

[[nodiscard]] Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
[[nodiscard]] Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);
[[nodiscard]] Sign in_diametral_sphere(const Point3& p, const Point3& a, const Point3& b);
[[nodiscard]] Sign compare_distance(const Point3& p, const Point3& a, const Point3& b);

[[nodiscard]] Sign power_test(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                              const WeightedPoint2& d);
[[nodiscard]] Sign power_test(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                              const WeightedPoint3& d, const WeightedPoint3& e);
[[nodiscard]] Sign compare_power_distance(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b);
[[nodiscard]] Sign compare_power_distance(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b);

/// Twice the signed area of a closed polygon (the last point joins the first), exact.
///
/// polygon  corners in order; fewer than three give 0
/// returns  positive if the polygon runs counter-clockwise, in squared units of the coordinates
[[nodiscard]] mpq_class area2(std::span<const Point2> polygon);

}  // namespace leonhard::kernel::exact
