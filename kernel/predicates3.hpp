// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/pair.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// Geometric predicates of space, exact for every finite double, made like those of the plane in predicates.hpp:
/// X_filter, inline, answers where a proven error bound allows it; X_exact, out of line, always; X tries the one and
/// falls through to the other. NaN and infinities: InputError, as there.
///
/// filtered_sign.hpp has the notation of the error bounds.
namespace leonhard::kernel {

// ---- orient3d ----

/// The determinant with rows U, V, W, the vectors from a, computed as U and V's minors in two planes at a time, and
/// the sum T of its six terms' sizes along with it.
///
/// Error bound. A term, a product of three rounded differences, has 3 roundings in its factors and 2 of its own, the
/// sum has 3 more, so the error is at most (8u + O(u^2)) T; 8.8819e-16 is 8u and a hundred-thousandth of it.
///
/// Underflow. W comes in last, scaled by 2^600, and is below 2^1024 or else infinite, which leaves the filter without
/// an answer. A product of U and V's coordinates that underflows is wrong by 2^-1075, so the six terms together by
/// less than 2^-48; the guard is above that. So the filter may answer if the determinant is between 2^-640 and 2^424.
[[nodiscard]] inline FilteredSign orient3d_filter(const Point3& a, const Point3& b, const Point3& c,
                                                  const Point3& d) {
  constexpr double scale = 0x1p600, guard = 0x1p-40;
  const Pair a_xy = xy_of(a), u = xy_of(b) - a_xy, v = xy_of(c) - a_xy, w = (xy_of(d) - a_xy) * scale;
  const double uz = b.z - a.z, vz = c.z - a.z, wz = (d.z - a.z) * scale;
  const Pair w_yx = swapped(w);
  const Pair first = v * uz * w_yx, second = u * vz * w_yx, third = u * swapped(v) * wz;
  const Pair sums = (first - second) + third;
  const Pair sizes = (absolute(first) + absolute(second)) + absolute(third);
  return sign_if_beyond(sums[0] - sums[1], 8.8819e-16 * (sizes[0] + sizes[1]), guard);
}
[[nodiscard]] Sign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// On which side of the plane abc does d lie?
///
/// returns  the sign of (b - a) x (c - a) . (d - a): positive if a, b, c turn counter-clockwise as seen from d, zero if
///          the four points are coplanar
/// Exact for all finite coordinates. Antisymmetric under every swap of two points. Shewchuk's orient3d has the
/// opposite sign.
[[nodiscard]] inline Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const FilteredSign s = orient3d_filter(a, b, c, d); s.is_certain()) [[likely]]
    return *s;
  return orient3d_exact(a, b, c, d);
}

// ---- insphere ----

/// The determinant |U|^2 [V W T] - |V|^2 [U W T] + |W|^2 [U V T] - |T|^2 [U V W] of the vectors to e, the brackets
/// being triple products, computed two of each kind at a time.
///
/// Error bound. A product of five rounded differences has 5 roundings in its factors and 4 of its own; the
/// subtraction in its minor and the additions, 2 in the triple product, 2 in the square, 2 in the sum of four, are 7
/// more. So the error is at most (16u + O(u^2)) times the sum over the four vectors of |U|^2 P(V, W, T), where P, the
/// permanent of absolute values, is at most (2 / sqrt 3) |V| |W| |T|: it is largest for three vectors along (1, 1,
/// 1). With S = |U|^2 + |V|^2 + |W|^2 + |T|^2 the sum is at most (2 / sqrt 3) |U| |V| |W| |T| (|U| + |V| + |W| + |T|)
/// <= (2 / sqrt 3) (S/4)^2 2 sqrt S < 0.1444 S^2 sqrt S, by the inequalities of the means. 16 * 0.1444 u < 2.4u; 3u
/// leaves a fifth for the terms in u^2. Products that underflow add less than 2^-1066 (1 + S^2 sqrt S). No term
/// exceeds S^2 sqrt S, so nothing overflows unless that does.
[[nodiscard]] inline FilteredSign insphere_filter(const Point3& a, const Point3& b, const Point3& c,
                                                  const Point3& d, const Point3& e) {
  const Pair e_xy = xy_of(e);
  const Pair u = xy_of(a) - e_xy, v = xy_of(b) - e_xy, w = xy_of(c) - e_xy, t = xy_of(d) - e_xy;
  const Pair uv_x = firsts(u, v), uv_y = seconds(u, v), uv_z = Pair{a.z, b.z} - e.z;
  const Pair wt_x = firsts(w, t), wt_y = seconds(w, t), wt_z = Pair{c.z, d.z} - e.z;

  const Pair uv_square = uv_x * uv_x + uv_y * uv_y + uv_z * uv_z;
  const Pair wt_square = wt_x * wt_x + wt_y * wt_y + wt_z * wt_z;
  const Pair squares = uv_square + wt_square;
  const double size = squares[0] + squares[1];

  // Minors in the plane xy, named by their vectors: uw_vt holds [u w] and [v t].
  const Pair ty_wy = swapped(wt_y);
  const Pair ux_vy = uv_x * swapped(uv_y), wx_ty = wt_x * ty_wy;
  const Pair uv_wt = firsts(ux_vy, wx_ty) - seconds(ux_vy, wx_ty);
  const Pair uw_vt = uv_x * wt_y - uv_y * wt_x, ut_vw = uv_x * ty_wy - uv_y * swapped(wt_x);
  const Pair ut_vt{ut_vw[0], uw_vt[1]}, uw_vw{uw_vt[0], ut_vw[1]};

  const Pair uwt_vwt = uv_z * uv_wt[1] - ut_vt * wt_z[0] + uw_vw * wt_z[1];
  const Pair uvw_uvt = wt_z * uv_wt[0] + seconds(ut_vw, uw_vt) * uv_z[0] - firsts(uw_vt, ut_vw) * uv_z[1];
  const Pair sums = swapped(uwt_vwt) * uv_square + swapped(uvw_uvt) * wt_square;
  return sign_if_beyond(sums[0] - sums[1], 0x1.8p-52 * (size * size * std::sqrt(size)));
}
[[nodiscard]] Sign insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                  const Point3& e);

/// Does e lie inside the sphere through a, b, c, d?
///
/// a, b, c, d  with orient3d positive; if it is negative the sign is reversed
/// returns     positive if e lies inside, zero on the sphere, negative outside; if a, b, c, d are coplanar, the
///             sign of the determinant all the same
/// Exact for all finite coordinates. Antisymmetric under every swap of two of the five points.
[[nodiscard]] inline Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                   const Point3& e) {
  if (const FilteredSign s = insphere_filter(a, b, c, d, e); s.is_certain()) [[likely]]
    return *s;
  return insphere_exact(a, b, c, d, e);
}

/// The sign of insphere(a, b, c, d, e) after a symbolic perturbation, for five points whose insphere is zero: a
/// precondition.
[[nodiscard]] Sign insphere_tie(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const Point3& e);

/// insphere with ties broken by coordinates alone, so that every point set has one Delaunay tetrahedralisation.
///
/// a, b, c, d  with orient3d positive (negative: the sign is reversed)
/// returns     as insphere where that is not zero; else as if each point were lifted off the paraboloid by an
///             infinitesimal height that grows with its lexicographic rank. Never zero if a, b, c, d are not coplanar
///             and the five points are distinct; zero if two points are equal or all five coplanar.
/// Exact for all finite coordinates. Antisymmetric under every swap of two of the five points.
/// Method: Devillers and Teillaud, Computational Geometry 44 (2011), "Perturbations for Delaunay and weighted
/// Delaunay 3D triangulations".
[[nodiscard]] inline Sign insphere_perturbed(const Point3& a, const Point3& b, const Point3& c,
                                             const Point3& d, const Point3& e) {
  const Sign s = insphere(a, b, c, d, e);
  if (s != Sign::zero) [[likely]]
    return s;
  return insphere_tie(a, b, c, d, e);
}

// ---- in_diametral_sphere ----

/// Error bound: 2 roundings in the factors of a product, 1 of its own, 2 in the sum, so 5u times the sum of the
/// products' sizes and terms in u^2; 5.5512e-16 is 5u and a hundred-thousandth of it.
[[nodiscard]] inline FilteredSign in_diametral_sphere_filter(const Point3& p, const Point3& a,
                                                             const Point3& b) {
  const double x = (a.x - p.x) * (p.x - b.x), y = (a.y - p.y) * (p.y - b.y), z = (a.z - p.z) * (p.z - b.z);
  return sign_if_beyond(x + y + z, 5.5512e-16 * (std::abs(x) + std::abs(y) + std::abs(z)));
}
[[nodiscard]] Sign in_diametral_sphere_exact(const Point3& p, const Point3& a, const Point3& b);

/// Does p lie inside the sphere that has ab as a diameter, that is, is the angle apb obtuse?
///
/// returns  positive strictly inside, zero on the sphere, negative outside
/// Exact for all finite coordinates. Unchanged if a and b are swapped.
[[nodiscard]] inline Sign in_diametral_sphere(const Point3& p, const Point3& a, const Point3& b) {
  if (const FilteredSign s = in_diametral_sphere_filter(p, a, b); s.is_certain()) [[likely]]
    return *s;
  return in_diametral_sphere_exact(p, a, b);
}

// ---- angle ----

/// Is the angle at `apex` between the rays to a and b acute, right or obtuse?
///
/// returns  the sign of its cosine: positive if it is acute, negative if it is obtuse; zero if it is right or if a ray has
///          no direction, a or b being the apex
/// Exact for all finite coordinates. Unchanged if a and b are swapped.
[[nodiscard]] inline Sign angle(const Point3& a, const Point3& apex, const Point3& b) {
  return -in_diametral_sphere(apex, a, b);
}

// ---- compare_distance ----

/// Error bound: 5 roundings in each of the squared distances A and B, so 5u (A + B) <= 5u (2 A + |A - B|) and terms
/// in u^2; 1.1103e-15 is 10u and a twenty-thousandth of it.
[[nodiscard]] inline FilteredSign compare_distance_filter(const Point3& p, const Point3& a, const Point3& b) {
  const Vec3 u = a - p, v = b - p;
  const double uu = dot(u, u);
  return sign_if_beyond(uu - dot(v, v), 1.1103e-15 * uu);
}
[[nodiscard]] Sign compare_distance_exact(const Point3& p, const Point3& a, const Point3& b);

/// Which of a and b lies farther from p?
///
/// returns  positive if a does, zero if both are equally far, negative if b does
/// Exact for all finite coordinates. Antisymmetric in a and b.
[[nodiscard]] inline Sign compare_distance(const Point3& p, const Point3& a, const Point3& b) {
  if (const FilteredSign s = compare_distance_filter(p, a, b); s.is_certain()) [[likely]]
    return *s;
  return compare_distance_exact(p, a, b);
}

// ---- compare_xyz ----

namespace detail {
/// throws  InputError: neither of two points comes first, nor are they equal
[[noreturn]] void refuse_order(const Point3& a, const Point3& b);
}  // namespace detail

/// Lexicographic order of two points, x before y before z: the order of symbolic perturbation.
///
/// returns  negative if a comes first, zero if the points are equal (-0 equal to +0), positive if b comes first
/// throws   InputError if a coordinate that is compared is NaN; infinities have their place in the order
[[nodiscard]] constexpr Sign compare_xyz(const Point3& a, const Point3& b) {
  if (a < b) return Sign::negative;
  if (b < a) return Sign::positive;
  if (a != b) detail::refuse_order(a, b);
  return Sign::zero;
}

}  // namespace leonhard::kernel
