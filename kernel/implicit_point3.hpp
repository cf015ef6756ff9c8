// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/stages/point_ref.hpp"
#include "leonhard/kernel/stages/stage.hpp"

/// Intersections of lines and planes of space as points that predicates take unrounded: as implicit_point.hpp, which
/// has the source.
namespace leonhard::kernel {

/// The point where the line pq crosses the plane rst.
///
/// throws  InputError if the line is parallel to the plane or in it, or there is no such line or plane because p = q or
///         r, s, t are collinear, which is decided exactly, or if a coordinate is not finite
/// Cost: about 0.4 microseconds to make.
class LinePlaneCrossing : public ImplicitPoint<Point3, 5> {
 public:
  LinePlaneCrossing(const Point3& p, const Point3& q, const Point3& r, const Point3& s, const Point3& t);
};

/// A plane by three of its points.
using PlanePoints = std::array<Point3, 3>;

/// The point that three planes have in common.
///
/// throws  InputError if there is none or more than one, or the points of a plane are collinear, which is decided
///         exactly, or if a coordinate is not finite
/// Cost: about 0.7 microseconds to make.
class ThreePlaneCrossing : public ImplicitPoint<Point3, 9> {
 public:
  ThreePlaneCrossing(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c);
};

/// The predicates of predicates3.hpp, with the same signs, of any mixture of Point3, LinePlaneCrossing and
/// ThreePlaneCrossing.
///
/// throws  InputError if a coordinate of a Point3 is NaN or infinite
/// Cost: 50 to 130 ns; for ties 1 to 40 microseconds, and more where exponents are far apart.
[[nodiscard]] Sign orient3d(const PointRef3& a, const PointRef3& b, const PointRef3& c, const PointRef3& d);
[[nodiscard]] Sign insphere(const PointRef3& a, const PointRef3& b, const PointRef3& c, const PointRef3& d,
                            const PointRef3& e);

/// Lexicographic order, x before y before z.
///
/// returns  negative if a comes first, zero if the points are equal, positive if b comes first
[[nodiscard]] Sign compare_xyz(const PointRef3& a, const PointRef3& b);

/// The same, telling which stage answered.
///
/// first  the first stage to be asked, for tests and measurements
[[nodiscard]] StagedSign orient3d_staged(const PointRef3& a, const PointRef3& b, const PointRef3& c,
                                         const PointRef3& d, Stage first = Stage::filter);
[[nodiscard]] StagedSign insphere_staged(const PointRef3& a, const PointRef3& b, const PointRef3& c,
                                         const PointRef3& d, const PointRef3& e, Stage first = Stage::filter);
[[nodiscard]] StagedSign compare_xyz_staged(const PointRef3& a, const PointRef3& b,
                                            Stage first = Stage::filter);

/// A double point beside a point that need not be one.
struct RoundedPoint3 {
  Point3 point;
  double error;  ///< the two are no farther apart than this in any coordinate
};

/// The double point nearest to p, as `rounded` in the plane.
[[nodiscard]] RoundedPoint3 rounded(const PointRef3& p);

}  // namespace leonhard::kernel
