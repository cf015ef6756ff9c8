// SPDX-License-Identifier: MIT
#include "leonhard/kernel/implicit_point3.hpp"

#include <array>

#include "leonhard/kernel/arithmetic/rounded_coordinates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/staged_predicate.hpp"

namespace leonhard::kernel {
namespace {

/// The determinants of vectors to the last point have the opposite sign of orient3d and insphere.
StagedSign operator-(StagedSign s) { return {-s.sign, s.stage}; }

}  // namespace

LinePlaneCrossing::LinePlaneCrossing(const Point3& p, const Point3& q, const Point3& r, const Point3& s,
                                     const Point3& t)
    : ImplicitPoint(
          {p, q, r, s, t},
          {"LinePlaneCrossing", "line and plane are parallel, or their points do not span them",
           "make crossings of segments whose ends orient3d says to be on both sides of the plane"}) {}

ThreePlaneCrossing::ThreePlaneCrossing(const PlanePoints& a, const PlanePoints& b, const PlanePoints& c)
    : ImplicitPoint({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]},
                    {"ThreePlaneCrossing",
                     "the planes do not have one single point in common, or the points of one are collinear",
                     "give three planes whose normals are linearly independent"}) {}

Sign orient3d(const PointRef3& a, const PointRef3& b, const PointRef3& c, const PointRef3& d) {
  if (a.is_explicit() && b.is_explicit() && c.is_explicit() && d.is_explicit())
    return orient3d(a.explicit_point(), b.explicit_point(), c.explicit_point(), d.explicit_point());
  return orient3d_staged(a, b, c, d).sign;
}

Sign insphere(const PointRef3& a, const PointRef3& b, const PointRef3& c, const PointRef3& d,
              const PointRef3& e) {
  if (a.is_explicit() && b.is_explicit() && c.is_explicit() && d.is_explicit() && e.is_explicit())
    return insphere(a.explicit_point(), b.explicit_point(), c.explicit_point(), d.explicit_point(),
                    e.explicit_point());
  return insphere_staged(a, b, c, d, e).sign;
}

Sign compare_xyz(const PointRef3& a, const PointRef3& b) { return compare_xyz_staged(a, b).sign; }

StagedSign orient3d_staged(const PointRef3& a, const PointRef3& b, const PointRef3& c, const PointRef3& d,
                           Stage first) {
  return -determinant_sign(std::array{a, b, c, d}, first);
}

StagedSign insphere_staged(const PointRef3& a, const PointRef3& b, const PointRef3& c, const PointRef3& d,
                           const PointRef3& e, Stage first) {
  return -determinant_sign(std::array{a, b, c, d, e}, first);
}

StagedSign compare_xyz_staged(const PointRef3& a, const PointRef3& b, Stage first) {
  return lexicographic_sign(a, b, first);
}

RoundedPoint3 rounded(const PointRef3& p) {
  const auto [coordinates, error] = rounded_coordinates(p);
  return {{coordinates[0], coordinates[1], coordinates[2]}, error};
}

}  // namespace leonhard::kernel
