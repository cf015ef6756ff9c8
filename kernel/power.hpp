// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/weighted_point.hpp"

/// incircle, insphere and compare_distance of weighted points, for regular triangulations and power diagrams,
/// exact for every finite coordinate and weight, in stages as in predicates.hpp; InputError if one is NaN or infinite. With
/// equal weights they are incircle, insphere and compare_distance.
///
/// The power of two weighted points is |p - q|^2 - w_p - w_q; it is zero if their circles meet at right
/// angles. The orthogonal circle of a, b, c is the weighted point whose power to each of them is zero. A
/// weighted point is lifted to the height |p|^2 - w: the tests are orientations of lifted points (F.
/// Aurenhammer, SIAM Journal on Computing 16 (1987), "Power diagrams").
///
/// filtered_sign.hpp has the notation of the error bounds.
namespace leonhard::kernel {

namespace detail {

/// The determinant with rows (Ux, Uy, hu) and so on; of rounded or longer numbers.
template <class Vector, class Height>
[[nodiscard]] auto lifted_determinant(const Vector& u, const Vector& v, const Vector& w, const Height& hu,
                                      const Height& hv, const Height& hw) {
  return cross(v, w) * hu + cross(w, u) * hv + cross(u, v) * hw;
}

/// hu [V W T] - hv [U W T] + hw [U V T] - ht [U V W], the brackets being triple products, which share their
/// minors; of rounded or longer numbers.
template <class Vector, class Height>
[[nodiscard]] auto lifted_determinant(const Vector& u, const Vector& v, const Vector& w, const Vector& t,
                                      const Height& hu, const Height& hv, const Height& hw,
                                      const Height& ht) {
  const auto uv = u.x * v.y - u.y * v.x, vw = v.x * w.y - v.y * w.x, wt = w.x * t.y - w.y * t.x,
             tu = t.x * u.y - t.y * u.x, uw = u.x * w.y - u.y * w.x, vt = v.x * t.y - v.y * t.x;
  const auto vwt = wt * v.z - vt * w.z + vw * t.z, uwt = wt * u.z + tu * w.z + uw * t.z,
             uvt = vt * u.z + tu * v.z + uv * t.z, uvw = vw * u.z - uw * v.z + uv * w.z;
  return (vwt * hu - uwt * hv) + (uvt * hw - uvw * ht);
}

}  // namespace detail

// ---- power_test in the plane ----

/// The determinant of incircle_filter with the heights h = |A|^2 - g in place of the squares, g being the
/// weight of a less that of d, and so on.
///
/// Error bound. A height has 4 roundings in the square, 1 in g, 1 of its own, so the error of the whole is at
/// most (12u + O(u^2)) sum (|A|^2 + |g|) (|Bx Cy| + |Cx By|): one rounding more than in incircle_filter. As
/// there the squares' part of the sum is at most L^2 / 3; the last factor being at most |B| |C| <= L / 2, the
/// weights' part is at most G L / 2, G the sum of |g|. So 4u L^2 + 6u G L; 4.5u L (L + 1.5 G) leaves an
/// eighth for the terms in u^2.
///
/// Underflow. A minor that underflows is wrong by 2^-1074, which the heights make 2^-1073 (L + G); the
/// 2^-1000 in L makes the bound larger than that, or else the guard is. The rest is as in incircle_filter. No
/// term exceeds L (L + 1.5 G), so nothing overflows unless that does.
[[nodiscard]] inline FilteredSign power_test_filter(const WeightedPoint2& a, const WeightedPoint2& b,
                                                    const WeightedPoint2& c, const WeightedPoint2& d) {
  const Vec2 u = a.point - d.point, v = b.point - d.point, w = c.point - d.point;
  const double gu = a.weight - d.weight, gv = b.weight - d.weight, gw = c.weight - d.weight;
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const double determinant = detail::lifted_determinant(u, v, w, uu - gu, vv - gv, ww - gw);
  const double size = 0x1p-1000 + uu + vv + ww, weights = std::abs(gu) + std::abs(gv) + std::abs(gw);
  return sign_if_beyond(determinant, 0x1.2p-51 * (size * (size + 1.5 * weights)));
}
[[nodiscard]] Sign power_test_exact(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                                    const WeightedPoint2& d);

/// Is d in conflict with a, b, c: is its power to their orthogonal circle negative?
///
/// a, b, c  counter-clockwise; if they turn clockwise the sign is reversed
/// returns  positive if d is in conflict, so that abc is no triangle of the regular triangulation; zero if
///          the power is zero, negative if it is positive; if a, b, c are collinear, the sign of the
///          determinant all the same
/// Exact for all finite coordinates and weights. Antisymmetric under every swap of two of the four points.
/// Equals incircle if the weights are equal.
[[nodiscard]] inline Sign power_test(const WeightedPoint2& a, const WeightedPoint2& b,
                                     const WeightedPoint2& c, const WeightedPoint2& d) {
  if (const FilteredSign s = power_test_filter(a, b, c, d); s.is_certain()) [[likely]]
    return *s;
  return power_test_exact(a, b, c, d);
}

/// power_test with ties broken by coordinates alone, so that every set of weighted points has one regular
/// triangulation.
///
/// a, b, c  counter-clockwise (clockwise: the sign is reversed)
/// returns  as power_test where that is not zero; else as if each point were lifted by an infinitesimal
///          height that grows with the lexicographic rank of its coordinates. Never zero for distinct points
///          (their coordinates, that is) that are not all collinear. Two equal points with different weights
///          need no perturbation: power_test is zero only if all four are collinear. Two with the same weight
///          make it zero.
/// Exact for all finite coordinates and weights. Antisymmetric under every swap of two of the four points.
/// Equals incircle_perturbed if the weights are equal. Method: Devillers and Teillaud, Computational Geometry
/// 44 (2011), "Perturbations for Delaunay and weighted Delaunay 3D triangulations", here in the plane.
[[nodiscard]] inline Sign power_test_perturbed(const WeightedPoint2& a, const WeightedPoint2& b,
                                               const WeightedPoint2& c, const WeightedPoint2& d) {
  const Sign s = power_test(a, b, c, d);
  if (s != Sign::zero) [[likely]]
    return s;
  return incircle_tie(a.point, b.point, c.point, d.point);
}

// ---- power_test in space ----

/// The determinant of insphere_filter with the heights h = |U|^2 - g in place of the squares, g being the
/// weight of a less that of e, and so on.
///
/// Error bound. One rounding more than in insphere_filter, 17, times the sum over the four vectors of (|U|^2
/// + |g|) P(V, W, T). The squares' part of the sum is at most 0.1444 S^2 sqrt S, as there; the weights' part
/// at most G (2 / sqrt 3) |V| |W| |T| <= G (2 / sqrt 3) (S/3) sqrt(S/3) = (2/9) G S sqrt S, G the sum of |g|.
/// So 2.46u S^2 sqrt S + 3.78u G S sqrt S; 3u S sqrt S (S + 1.5 G) leaves a seventh for the terms in u^2.
///
/// Underflow. A triple product may be wrong by 2^-1071 (1 + sqrt S), which the heights make 2^-1069 (1 + sqrt
/// S) (S + G); the 2^-600 in S makes the bound larger than that, or else the guard is. The rest is as in
/// insphere_filter. No term exceeds S sqrt S (S + 1.5 G), so nothing overflows unless that does.
[[nodiscard]] inline FilteredSign power_test_filter(const WeightedPoint3& a, const WeightedPoint3& b,
                                                    const WeightedPoint3& c, const WeightedPoint3& d,
                                                    const WeightedPoint3& e) {
  const Vec3 u = a.point - e.point, v = b.point - e.point, w = c.point - e.point, t = d.point - e.point;
  const double gu = a.weight - e.weight, gv = b.weight - e.weight, gw = c.weight - e.weight,
               gt = d.weight - e.weight;
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), tt = dot(t, t);
  const double determinant = detail::lifted_determinant(u, v, w, t, uu - gu, vv - gv, ww - gw, tt - gt);
  const double size = 0x1p-600 + uu + vv + ww + tt;
  const double weights = std::abs(gu) + std::abs(gv) + std::abs(gw) + std::abs(gt);
  return sign_if_beyond(determinant, 0x1.8p-52 * (size * std::sqrt(size) * (size + 1.5 * weights)));
}
[[nodiscard]] Sign power_test_exact(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                                    const WeightedPoint3& d, const WeightedPoint3& e);

/// Is e in conflict with a, b, c, d: is its power to their orthogonal sphere negative?
///
/// a, b, c, d  with orient3d positive; if it is negative the sign is reversed
/// returns     positive if e is in conflict, so that abcd is no tetrahedron of the regular
///             tetrahedralisation; zero if the power is zero, negative if it is positive; if a, b, c, d are
///             coplanar, the sign of the determinant
/// Exact for all finite coordinates and weights. Antisymmetric under every swap of two of the five points.
/// Equals insphere if the weights are equal.
[[nodiscard]] inline Sign power_test(const WeightedPoint3& a, const WeightedPoint3& b,
                                     const WeightedPoint3& c, const WeightedPoint3& d,
                                     const WeightedPoint3& e) {
  if (const FilteredSign s = power_test_filter(a, b, c, d, e); s.is_certain()) [[likely]]
    return *s;
  return power_test_exact(a, b, c, d, e);
}

/// power_test with ties broken by coordinates alone, as in the plane: never zero for distinct points that are
/// not all coplanar; zero for two equal points of the same weight; for two equal points of different weights
/// zero only if all five are coplanar.
///
/// a, b, c, d  with orient3d positive (negative: the sign is reversed)
/// Exact for all finite coordinates and weights. Antisymmetric under every swap of two of the five points.
/// Equals insphere_perturbed if the weights are equal.
[[nodiscard]] inline Sign power_test_perturbed(const WeightedPoint3& a, const WeightedPoint3& b,
                                               const WeightedPoint3& c, const WeightedPoint3& d,
                                               const WeightedPoint3& e) {
  const Sign s = power_test(a, b, c, d, e);
  if (s != Sign::zero) [[likely]]
    return s;
  return insphere_tie(a.point, b.point, c.point, d.point, e.point);
}

// ---- compare_power_distance ----

/// Error bound: 4 roundings in each of the squared distances A and B, 1 in their difference, 1 in g, the
/// difference of the weights, 1 in the last subtraction: 6u (A + B) + 2u |g| and terms in u^2, below 7u (A +
/// B + |g|).
[[nodiscard]] inline FilteredSign compare_power_distance_filter(const Point2& p, const WeightedPoint2& a,
                                                                const WeightedPoint2& b) {
  const Vec2 u = a.point - p, v = b.point - p;
  const double uu = dot(u, u), vv = dot(v, v), g = a.weight - b.weight;
  return sign_if_beyond((uu - vv) - g, 0x1.cp-51 * (uu + vv + std::abs(g)));
}
[[nodiscard]] Sign compare_power_distance_exact(const Point2& p, const WeightedPoint2& a,
                                                const WeightedPoint2& b);

/// To which of a and b has p the larger power |p - a|^2 - w_a? The sides of a power diagram's edges.
///
/// returns  positive if to a, zero if the powers are equal, negative if to b
/// Exact for all finite coordinates and weights. Antisymmetric in a and b. Equals compare_distance if the
/// weights are equal.
[[nodiscard]] inline Sign compare_power_distance(const Point2& p, const WeightedPoint2& a,
                                                 const WeightedPoint2& b) {
  if (const FilteredSign s = compare_power_distance_filter(p, a, b); s.is_certain()) [[likely]]
    return *s;
  return compare_power_distance_exact(p, a, b);
}

/// Error bound: as in the plane, one rounding more in each squared distance; below 8u (A + B + |g|).
[[nodiscard]] inline FilteredSign compare_power_distance_filter(const Point3& p, const WeightedPoint3& a,
                                                                const WeightedPoint3& b) {
  const Vec3 u = a.point - p, v = b.point - p;
  const double uu = dot(u, u), vv = dot(v, v), g = a.weight - b.weight;
  return sign_if_beyond((uu - vv) - g, 0x1p-50 * (uu + vv + std::abs(g)));
}
[[nodiscard]] Sign compare_power_distance_exact(const Point3& p, const WeightedPoint3& a,
                                                const WeightedPoint3& b);

/// As in the plane.
[[nodiscard]] inline Sign compare_power_distance(const Point3& p, const WeightedPoint3& a,
                                                 const WeightedPoint3& b) {
  if (const FilteredSign s = compare_power_distance_filter(p, a, b); s.is_certain()) [[likely]]
    return *s;
  return compare_power_distance_exact(p, a, b);
}

}  // namespace leonhard::kernel
