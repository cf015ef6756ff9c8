// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/stages/stage.hpp"
#include "leonhard/kernel/weighted_point.hpp"

/// The last stages of the predicates, for points whose exponents are too far apart for those before: the determinant in
/// floating point whose exponents stand apart, with a proven bound (wide_double.hpp), and what that leaves open as an
/// exact sum of terms, the largest first (term_sum.hpp). Right for every finite double; no number over- or underflows, and
/// no memory is allocated. Same sign conventions.
///
/// Differences of coordinates are not formed: among points of mixed exponents they would all but lose the smaller
/// coordinate, and the sign often depends on it. The determinants have a column of ones instead, and the terms of their
/// expansions, all different, are of different sizes as a rule, so that the largest one decides.
namespace leonhard::kernel::wide_range {

[[nodiscard]] StagedSign orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] StagedSign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
[[nodiscard]] StagedSign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
[[nodiscard]] StagedSign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                  const Point3& e);

[[nodiscard]] Sign in_diametral_circle(const Point2& p, const Point2& a, const Point2& b);
[[nodiscard]] Sign in_diametral_sphere(const Point3& p, const Point3& a, const Point3& b);
[[nodiscard]] Sign compare_distance(const Point2& p, const Point2& a, const Point2& b);
[[nodiscard]] Sign compare_distance(const Point3& p, const Point3& a, const Point3& b);

[[nodiscard]] Sign power_test(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                              const WeightedPoint2& d);
[[nodiscard]] Sign power_test(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                              const WeightedPoint3& d, const WeightedPoint3& e);
[[nodiscard]] Sign compare_power_distance(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b);
[[nodiscard]] Sign compare_power_distance(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b);

}  // namespace leonhard::kernel::wide_range
