// SPDX-License-Identifier: MIT
#include "leonhard/kernel/predicates3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "leonhard/kernel/arithmetic/exact_range.hpp"
#include "leonhard/kernel/arithmetic/long_vector.hpp"
#include "leonhard/kernel/arithmetic/small_multiples.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/pair.hpp"
#include "leonhard/kernel/stages/finite.hpp"
#include "leonhard/kernel/stages/integer_predicates.hpp"
#include "leonhard/kernel/stages/stage.hpp"
#include "leonhard/kernel/stages/wide_predicates.hpp"

namespace leonhard::kernel {
namespace {

// ---- determinants of longer numbers ----

/// (u x v) . w, the determinant with rows u, v, w.
template <class Number>
auto triple_product(const LongVec3<Number>& u, const LongVec3<Number>& v, const LongVec3<Number>& w) {
  return (u.y * v.z - u.z * v.y) * w.x + (u.z * v.x - u.x * v.z) * w.y + (u.x * v.y - u.y * v.x) * w.z;
}

/// insphere's determinant, see insphere_filter; the triple products share their minors.
template <class Number>
auto insphere_determinant(const LongVec3<Number>& u, const LongVec3<Number>& v, const LongVec3<Number>& w,
                          const LongVec3<Number>& t) {
  const auto uv = u.x * v.y - u.y * v.x, vw = v.x * w.y - v.y * w.x, wt = w.x * t.y - w.y * t.x,
             tu = t.x * u.y - t.y * u.x, uw = u.x * w.y - u.y * w.x, vt = v.x * t.y - v.y * t.x;
  const auto vwt = wt * v.z - vt * w.z + vw * t.z, uwt = wt * u.z + tu * w.z + uw * t.z,
             uvt = vt * u.z + tu * v.z + uv * t.z, uvw = vw * u.z - uw * v.z + uv * w.z;
  return (vwt * dot(u, u) - uwt * dot(v, v)) + (uvt * dot(w, w) - uvw * dot(t, t));
}

/// The vectors are exact; a product has errors of 2 * 7 u^2, its minor 3 u^2, the sum 2 * 3 u^2, so 23 u^2 times the
/// permanent of absolute values, which is at most (2 / sqrt 3) |u| |v| |w| <= (2/9) S sqrt S, where S = |u|^2 + |v|^2 +
/// |w|^2, as in insphere_filter: 5.2 u^2 S sqrt S, and 6 u^2 leaves a seventh for the rest.
FilteredSign orient3d_double_double(const LongVec3<DoubleDouble>& u, const LongVec3<DoubleDouble>& v,
                                    const LongVec3<DoubleDouble>& w) {
  const double size = rounded_square(u) + rounded_square(v) + rounded_square(w);
  return sign_if_beyond(triple_product(u, v, w).high, 0x1.8p-104 * (size * std::sqrt(size)));
}

/// As insphere_filter. The vectors are exact; a product has errors of 4 * 7 u^2, its minor 3 u^2, and the sums
/// (2 + 2 + 2) 3 u^2: 49 u^2 0.1444 S^2 sqrt S with the estimates made there, and 8 u^2 leaves a tenth for the rest.
FilteredSign insphere_double_double(const LongVec3<DoubleDouble>& u, const LongVec3<DoubleDouble>& v,
                                    const LongVec3<DoubleDouble>& w, const LongVec3<DoubleDouble>& t) {
  const double size = rounded_square(u) + rounded_square(v) + rounded_square(w) + rounded_square(t);
  return sign_if_beyond(insphere_determinant(u, v, w, t).high, 0x1p-103 * (size * size * std::sqrt(size)));
}

double rounded_insphere(const Vec3& u, const Vec3& v, const Vec3& w, const Vec3& t) {
  const Vec3 uv = cross(u, v), wt = cross(w, t);
  return dot(wt, v) * dot(u, u) - dot(wt, u) * dot(v, v) + dot(uv, t) * dot(w, w) - dot(uv, w) * dot(t, t);
}

/// The commonest of ties: faces of boxes, walls of rooms.
bool in_a_plane_of_coordinates(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return (a.z == b.z && a.z == c.z && a.z == d.z) || (a.y == b.y && a.y == c.y && a.y == d.y) ||
         (a.x == b.x && a.x == c.x && a.x == d.x);
}

StagedSign orient3d_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  detail::require_finite("orient3d", a, b, c, d);
  if (in_a_plane_of_coordinates(a, b, c, d)) return {Sign::zero, Stage::small_integer};
  const Vec3 to_b = b - a, to_c = c - a, to_d = d - a;
  const std::array differences{xy_of(to_b), xy_of(to_c), xy_of(to_d), Pair{to_b.z, to_c.z}, both(to_d.z)};
  if (are_small_multiples<16>(
          differences, std::array{xy_of(a), xy_of(b), xy_of(c), xy_of(d), Pair{a.z, b.z}, Pair{c.z, d.z}}))
    return {sign_of(dot(cross(to_b, to_c), to_d)), Stage::small_integer};  // below 6 * 2^(3 * 16) units
  if (const auto s = integer::orient3d(a, b, c, d)) return {*s, Stage::integer};
  std::array points{a, b, c, d};
  if (!fit(points, exact_window<3>)) return wide_range::orient3d(a, b, c, d);
  const auto u = long_difference(points[1], points[0]);
  const auto v = long_difference(points[2], points[0]);
  const auto w = long_difference(points[3], points[0]);
  if (const FilteredSign s = orient3d_double_double(u, v, w); s.is_certain())
    return {*s, Stage::double_double};
  return {triple_product(expanded(u), expanded(v), expanded(w)).sign(), Stage::expansion};
}

StagedSign insphere_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                  const Point3& e) {
  detail::require_finite("insphere", a, b, c, d, e);
  const Vec3 to_a = a - e, to_b = b - e, to_c = c - e, to_d = d - e;
  const std::array differences{xy_of(to_a), xy_of(to_b),          xy_of(to_c),
                               xy_of(to_d), Pair{to_a.z, to_b.z}, Pair{to_c.z, to_d.z}};
  if (are_small_multiples<9>(differences, std::array{xy_of(a), xy_of(b), xy_of(c), xy_of(d), xy_of(e),
                                                     Pair{a.z, b.z}, Pair{c.z, d.z}, both(e.z)}))
    return {sign_of(rounded_insphere(to_a, to_b, to_c, to_d)),
            Stage::small_integer};  // below 72 * 2^(5 * 9) units
  if (const auto s = integer::insphere(a, b, c, d, e)) return {*s, Stage::integer};
  std::array points{a, b, c, d, e};
  if (!fit(points, exact_window<5>)) return wide_range::insphere(a, b, c, d, e);
  const auto u = long_difference(points[0], points[4]);
  const auto v = long_difference(points[1], points[4]);
  const auto w = long_difference(points[2], points[4]);
  const auto t = long_difference(points[3], points[4]);
  if (const FilteredSign s = insphere_double_double(u, v, w, t); s.is_certain())
    return {*s, Stage::double_double};
  return {insphere_determinant(expanded(u), expanded(v), expanded(w), expanded(t)).sign(), Stage::expansion};
}

}  // namespace

void detail::refuse_order(const Point3& a, const Point3& b) {
  refuse_not_finite("compare_xyz", a, b);
  throw InputError("compare_xyz", "the points have no order");  // not reached
}

Sign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return orient3d_beyond_filter(a, b, c, d).sign;
}
StagedSign orient3d_staged(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const FilteredSign s = orient3d_filter(a, b, c, d); s.is_certain()) return {*s, Stage::filter};
  return orient3d_beyond_filter(a, b, c, d);
}

Sign insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  return insphere_beyond_filter(a, b, c, d, e).sign;
}
StagedSign insphere_staged(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                           const Point3& e) {
  if (const FilteredSign s = insphere_filter(a, b, c, d, e); s.is_certain()) return {*s, Stage::filter};
  return insphere_beyond_filter(a, b, c, d, e);
}

Sign insphere_tie(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  // As incircle_tie: lifting one point by h changes the determinant by h times the orientation of the other four, in
  // the order that keeps the sign of the permutation: e in the place of the point lifted. The last point in
  // lexicographic order is lifted most; if the others are coplanar, the next one decides. Comparisons are made without
  // branches, which nothing could foretell: on grids this is asked for every third tetrahedron.
  const auto comes_before = [](const Point3& p, const Point3& q) {
    return (p.x < q.x) | ((p.x == q.x) & ((p.y < q.y) | ((p.y == q.y) & (p.z < q.z))));
  };
  const std::array points{&a, &b, &c, &d, &e};
  std::array<unsigned, 5> left{0, 1, 2, 3, 4};
  for (unsigned count = 5; count > 0; --count) {
    unsigned last = 0;
    bool equal = false;
    for (unsigned i = 1; i < count; ++i) {
      const Point3 &p = *points[left[last]], &q = *points[left[i]];
      const bool before = comes_before(p, q);
      equal |= !before & !comes_before(q, p);
      last = before ? i : last;
    }
    if (equal) return Sign::zero;
    const unsigned lifted = std::exchange(left[last], left[count - 1]);
    std::array others{&a, &b, &c, &d};
    if (lifted < 4) others[lifted] = &e;
    const Sign s = orient3d(*others[0], *others[1], *others[2], *others[3]);
    if (s != Sign::zero) return lifted < 4 ? s : -s;
  }
  return Sign::zero;
}

Sign in_diametral_sphere_exact(const Point3& p, const Point3& a, const Point3& b) {
  detail::require_finite("in_diametral_sphere", p, a, b);
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return wide_range::in_diametral_sphere(p, a, b);
  return -dot(expanded(long_difference(points[1], points[0])),
              expanded(long_difference(points[2], points[0])))
              .sign();
}

Sign compare_distance_exact(const Point3& p, const Point3& a, const Point3& b) {
  detail::require_finite("compare_distance", p, a, b);
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return wide_range::compare_distance(p, a, b);
  const auto u = expanded(long_difference(points[1], points[0])),
             v = expanded(long_difference(points[2], points[0]));
  return (dot(u, u) - dot(v, v)).sign();
}

}  // namespace leonhard::kernel
