// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/stages/point_ref.hpp"
#include "leonhard/kernel/stages/stage.hpp"

/// Intersections of lines of the plane as points that predicates take unrounded, exact for every finite double as in
/// predicates.hpp, and their conversion to the nearest doubles.
///
/// The idea is that of M. Attene, "Indirect predicates for geometric constructions", Computer-Aided Design 126 (2020).
/// Here a point carries its coordinates to about 100 bits, with what is not known of them, so that the filter of a
/// predicate costs little more than that of explicit points; staged_predicate.hpp has the rest.
namespace leonhard::kernel {

/// The point where the lines ab and cd cross.
///
/// throws  InputError if the lines are parallel or the same, or a = b or c = d, which is decided exactly, or if a
///         coordinate is not finite
/// Cost: about 0.2 microseconds to make.
class LineCrossing : public ImplicitPoint<Point2, 4> {
 public:
  LineCrossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
};

/// The predicates of predicates.hpp, with the same signs, of any mixture of Point2 and LineCrossing.
///
/// throws  InputError if a coordinate of a Point2 is NaN or infinite
/// Cost: tens of nanoseconds, microseconds for ties.
[[nodiscard]] Sign orient2d(const PointRef2& a, const PointRef2& b, const PointRef2& c);
[[nodiscard]] Sign incircle(const PointRef2& a, const PointRef2& b, const PointRef2& c, const PointRef2& d);

/// Lexicographic order, x before y.
///
/// returns  negative if a comes first, zero if the points are equal, positive if b comes first
[[nodiscard]] Sign compare_xy(const PointRef2& a, const PointRef2& b);

/// The same, telling which stage answered.
///
/// first  the first stage to be asked, for tests and measurements
[[nodiscard]] StagedSign orient2d_staged(const PointRef2& a, const PointRef2& b, const PointRef2& c,
                                         Stage first = Stage::filter);
[[nodiscard]] StagedSign incircle_staged(const PointRef2& a, const PointRef2& b, const PointRef2& c,
                                         const PointRef2& d, Stage first = Stage::filter);
[[nodiscard]] StagedSign compare_xy_staged(const PointRef2& a, const PointRef2& b,
                                           Stage first = Stage::filter);

/// A double point beside a point that need not be one.
struct RoundedPoint2 {
  Point2 point;
  double error;  ///< the two are no farther apart than this in any coordinate
};

/// The double point nearest to p: each coordinate is rounded to the nearest double, ties to even.
///
/// throws   InputError if p is explicit and not finite
/// returns  error 0 if p is explicit, else at most u = 2^-53 times the larger coordinate, or 2^-1074 if that is more. A
///          coordinate from 2^1024 - 2^970 on becomes the largest double, and the error infinite.
[[nodiscard]] RoundedPoint2 rounded(const PointRef2& p);

}  // namespace leonhard::kernel
