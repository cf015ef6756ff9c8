// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// Geometric predicates of space, exact for every finite double, made like those of the plane in predicates.hpp:
/// X_filter, inline, answers where a proven error bound allows it; X_exact, out of line, always; X tries the one and
/// falls through to the other. NaN and infinities are outside the domain.
///
/// filtered_sign.hpp has the notation of the error bounds.
namespace leonhard::kernel {

namespace detail {

/// The determinant with rows u, v, w, that is (u x v) . w: positive if they are right-handed. Vector is any struct of
/// x, y, z: of doubles or of longer numbers.
template <class Vector>
[[nodiscard]] auto triple_product(const Vector& u, const Vector& v, const Vector& w) {
  return (u.y * v.z - u.z * v.y) * w.x + (u.z * v.x - u.x * v.z) * w.y + (u.x * v.y - u.y * v.x) * w.z;
}

/// insphere's determinant, from the vectors to e: |u|^2 [v w t] - |v|^2 [u w t] + |w|^2 [u v t] - |t|^2 [u v w], the
/// brackets being triple products, which share their minors.
template <class Vector>
[[nodiscard]] auto insphere_determinant(const Vector& u, const Vector& v, const Vector& w, const Vector& t) {
  const auto uv = u.x * v.y - u.y * v.x, vw = v.x * w.y - v.y * w.x, wt = w.x * t.y - w.y * t.x,
             tu = t.x * u.y - t.y * u.x, uw = u.x * w.y - u.y * w.x, vt = v.x * t.y - v.y * t.x;
  const auto vwt = wt * v.z - vt * w.z + vw * t.z, uwt = wt * u.z + tu * w.z + uw * t.z,
             uvt = vt * u.z + tu * v.z + uv * t.z, uvw = vw * u.z - uw * v.z + uv * w.z;
  return (vwt * dot(u, u) - uwt * dot(v, v)) + (uvt * dot(w, w) - uvw * dot(t, t));
}

}  // namespace detail

// ---- orient3d ----

/// Error bound. A product of three rounded differences has 3 roundings in its factors and 2 of its own; the subtraction
/// in its minor and the two additions of the sum are 3 more. So the error is at most (8u + O(u^2)) P, P being the
/// permanent of the absolute values of U, V, W, and P <= (2 / sqrt 3) |U| |V| |W| <= (2/9) S sqrt S, where
/// S = |U|^2 + |V|^2 + |W|^2: the first is largest for U = V = W along (1, 1, 1), the second is the inequality of the
/// means. 16u/9 < 2u leaves a tenth for the terms in u^2. Products that underflow add less than 2^-1072 (1 + S sqrt S).
/// No term exceeds S sqrt S, so nothing overflows unless that does.
[[nodiscard]] inline FilteredSign orient3d_filter(const Point3& a, const Point3& b, const Point3& c,
                                                  const Point3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double size = dot(u, u) + dot(v, v) + dot(w, w);
  return detail::sign_if_beyond(detail::triple_product(u, v, w), 0x1p-52 * (size * std::sqrt(size)));
}
[[nodiscard]] Sign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// On which side of the plane abc does d lie?
///
/// returns  the sign of (b - a) x (c - a) . (d - a): positive if a, b, c turn counter-clockwise as seen from d, zero if
///          the four points are coplanar
/// Exact for all finite coordinates. Antisymmetric under every swap of two points. Shewchuk's orient3d has the opposite
/// sign.
[[nodiscard]] inline Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const FilteredSign s = orient3d_filter(a, b, c, d); s.is_certain()) [[likely]]
    return *s;
  return orient3d_exact(a, b, c, d);
}

// ---- insphere ----

/// Error bound. A product of five rounded differences has 5 roundings in its factors, 4 of its own; the subtraction in
/// its minor and the additions, 2 in the triple product, 2 in the square, 2 in the sum of four, are 7 more. So the error
/// is at most (16u + O(u^2)) times the sum over the four vectors of |U|^2 P(V, W, T), P as for orient3d. With
/// S = |U|^2 + |V|^2 + |W|^2 + |T|^2 that sum is at most (2 / sqrt 3) |U| |V| |W| |T| (|U| + |V| + |W| + |T|) <=
/// (2 / sqrt 3) (S / 4)^2 2 sqrt S < 0.1444 S^2 sqrt S, by the inequalities of the means. 16 * 0.1444 u < 2.4u; 3u leaves
/// a fifth for the terms in u^2. Products that underflow add less than 2^-1066 (1 + S^2 sqrt S). No term exceeds
/// S^2 sqrt S, so nothing overflows unless that does.
[[nodiscard]] inline FilteredSign insphere_filter(const Point3& a, const Point3& b, const Point3& c,
                                                  const Point3& d, const Point3& e) {
  const Vec3 u = a - e, v = b - e, w = c - e, t = d - e;
  const double size = dot(u, u) + dot(v, v) + dot(w, w) + dot(t, t);
  return detail::sign_if_beyond(detail::insphere_determinant(u, v, w, t),
                                0x1.8p-52 * (size * size * std::sqrt(size)));
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

/// The sign of insphere(a, b, c, d, e) after a symbolic perturbation, for five points whose insphere is zero.
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

/// Error bound: 2 roundings in the factors of a product, 1 of its own, 2 in the sum, so 5u times the sum of the products'
/// sizes and terms in u^2; 5.5512e-16 is 5u and a hundred-thousandth of it.
[[nodiscard]] inline FilteredSign in_diametral_sphere_filter(const Point3& p, const Point3& a,
                                                             const Point3& b) {
  const double x = (a.x - p.x) * (p.x - b.x), y = (a.y - p.y) * (p.y - b.y), z = (a.z - p.z) * (p.z - b.z);
  return detail::sign_if_beyond(x + y + z, 5.5512e-16 * (std::abs(x) + std::abs(y) + std::abs(z)));
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

// ---- compare_distance ----

/// Error bound: 5 roundings in each of the squared distances A and B, so 5u (A + B) <= 5u (2 A + |A - B|) and terms in
/// u^2; 1.1103e-15 is 10u and a twenty-thousandth of it.
[[nodiscard]] inline FilteredSign compare_distance_filter(const Point3& p, const Point3& a, const Point3& b) {
  const Vec3 u = a - p, v = b - p;
  const double uu = dot(u, u);
  return detail::sign_if_beyond(uu - dot(v, v), 1.1103e-15 * uu);
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

/// Lexicographic order of two finite points, x before y before z: the order of symbolic perturbation.
///
/// returns  negative if a comes first, zero if the points are equal (-0 equal to +0), positive if b comes first
[[nodiscard]] constexpr Sign compare_xyz(const Point3& a, const Point3& b) {
  return a < b ? Sign::negative : b < a ? Sign::positive : Sign::zero;
}

}  // namespace leonhard::kernel
