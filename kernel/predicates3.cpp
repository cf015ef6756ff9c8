// SPDX-License-Identifier: MIT
#include "leonhard/kernel/predicates3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "leonhard/kernel/double_double.hpp"
#include "leonhard/kernel/exact.hpp"
#include "leonhard/kernel/exact_range.hpp"
#include "leonhard/kernel/expansion.hpp"

namespace leonhard::kernel {
namespace {

// ---- vectors of longer numbers ----

template <class Number>
struct LongVec3 {
  Number x, y, z;
};

/// The exact difference of two points.
LongVec3<DoubleDouble> difference(const Point3& a, const Point3& b) {
  return {{two_difference(a.x, b.x)}, {two_difference(a.y, b.y)}, {two_difference(a.z, b.z)}};
}

LongVec3<Expansion<2>> expanded(const LongVec3<DoubleDouble>& v) {
  return {Expansion<2>(v.x), Expansion<2>(v.y), Expansion<2>(v.z)};
}

template <class Number>
auto dot(const LongVec3<Number>& u, const LongVec3<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

bool is_one_double(const LongVec3<DoubleDouble>& v) { return v.x.low == 0 && v.y.low == 0 && v.z.low == 0; }

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

/// |v|^2, good to a few u: enough for the scale of an error bound.
double rounded_square(const LongVec3<DoubleDouble>& v) {
  return v.x.high * v.x.high + v.y.high * v.y.high + v.z.high * v.z.high;
}

/// The vectors are exact; a product has errors of 2 * 7 u^2, its minor 3 u^2, the sum 2 * 3 u^2, so 23 u^2 times the
/// permanent of absolute values, which is at most (2 / sqrt 3) |u| |v| |w| <= (2/9) S sqrt S, where S = |u|^2 + |v|^2 +
/// |w|^2, as in insphere_filter: 5.2 u^2 S sqrt S, and 6 u^2 leaves a seventh for the rest.
FilteredSign orient3d_double_double(const LongVec3<DoubleDouble>& u, const LongVec3<DoubleDouble>& v,
                                    const LongVec3<DoubleDouble>& w) {
  const double size = rounded_square(u) + rounded_square(v) + rounded_square(w);
  return detail::sign_if_beyond(triple_product(u, v, w).high, 0x1.8p-104 * (size * std::sqrt(size)));
}

/// As insphere_filter. The vectors are exact; a product has errors of 4 * 7 u^2, its minor 3 u^2, and the sums
/// (2 + 2 + 2) 3 u^2: 49 u^2 0.1444 S^2 sqrt S with the estimates made there, and 8 u^2 leaves a tenth for the rest.
FilteredSign insphere_double_double(const LongVec3<DoubleDouble>& u, const LongVec3<DoubleDouble>& v,
                                    const LongVec3<DoubleDouble>& w, const LongVec3<DoubleDouble>& t) {
  const double size = rounded_square(u) + rounded_square(v) + rounded_square(w) + rounded_square(t);
  return detail::sign_if_beyond(insphere_determinant(u, v, w, t).high,
                                0x1p-103 * (size * size * std::sqrt(size)));
}

}  // namespace

// As in the plane: expansions at once where the differences are single doubles, as among neighbouring or integer
// points, for ties are found there and the expansions stay short; else double-double numbers first, which mostly tell.

Sign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  std::array points{a, b, c, d};
  if (!fit(points, exact_window<3>)) return exact::orient3d(a, b, c, d);
  const auto u = difference(points[1], points[0]);
  const auto v = difference(points[2], points[0]);
  const auto w = difference(points[3], points[0]);
  if (!(is_one_double(u) && is_one_double(v) && is_one_double(w)))
    if (const FilteredSign s = orient3d_double_double(u, v, w); s.is_certain()) return *s;
  return triple_product(expanded(u), expanded(v), expanded(w)).sign();
}

Sign insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  std::array points{a, b, c, d, e};
  if (!fit(points, exact_window<5>)) return exact::insphere(a, b, c, d, e);
  const auto u = difference(points[0], points[4]);
  const auto v = difference(points[1], points[4]);
  const auto w = difference(points[2], points[4]);
  const auto t = difference(points[3], points[4]);
  if (!(is_one_double(u) && is_one_double(v) && is_one_double(w) && is_one_double(t)))
    if (const FilteredSign s = insphere_double_double(u, v, w, t); s.is_certain()) return *s;
  return insphere_determinant(expanded(u), expanded(v), expanded(w), expanded(t)).sign();
}

Sign insphere_tie(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  // As incircle_tie: lifting one point by h changes the determinant by h times the orientation of the other four, in
  // the order that keeps the sign of the permutation.
  std::array ranked{std::pair{a, 0}, std::pair{b, 1}, std::pair{c, 2}, std::pair{d, 3}, std::pair{e, 4}};
  std::ranges::sort(ranked, [](const auto& p, const auto& q) { return p.first > q.first; });
  for (std::size_t i = 1; i < ranked.size(); ++i)
    if (ranked[i].first == ranked[i - 1].first) return Sign::zero;
  for (const auto& [point, position] : ranked) {
    Sign s = Sign::zero;
    switch (position) {
      case 0:
        s = orient3d(e, b, c, d);
        break;
      case 1:
        s = orient3d(a, e, c, d);
        break;
      case 2:
        s = orient3d(a, b, e, d);
        break;
      case 3:
        s = orient3d(a, b, c, e);
        break;
      default:
        s = -orient3d(a, b, c, d);
    }
    if (s != Sign::zero) return s;
  }
  return Sign::zero;
}

Sign in_diametral_sphere_exact(const Point3& p, const Point3& a, const Point3& b) {
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return exact::in_diametral_sphere(p, a, b);
  return -dot(expanded(difference(points[1], points[0])), expanded(difference(points[2], points[0]))).sign();
}

Sign compare_distance_exact(const Point3& p, const Point3& a, const Point3& b) {
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return exact::compare_distance(p, a, b);
  const auto u = expanded(difference(points[1], points[0])), v = expanded(difference(points[2], points[0]));
  return (dot(u, u) - dot(v, v)).sign();
}

}  // namespace leonhard::kernel
