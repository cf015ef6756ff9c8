// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/pair.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// Geometric predicates of the plane, exact for every finite double: overflow, underflow and subnormals
/// included.
///
/// Each predicate has three parts. X_filter, inline, evaluates the determinant in floating point and answers
/// only if a proven error bound says that the sign is right; X_exact passes through the stages of stage.hpp, the last
/// of which takes all finite doubles; X tries the one and falls through to the other.
///
/// Every predicate throws InputError, naming itself and the point, if a coordinate is NaN or infinite: the filter cannot
/// tell then, so the check is made behind it and costs nothing where the filter answers. X_filter alone says that it
/// cannot tell; X_tie wants finite points whose X is zero.
///
/// filtered_sign.hpp has the notation of the error bounds. Points are taken by reference so that the call of the
/// exact part costs the inlined filter no copies.
namespace leonhard::kernel {

namespace detail {

/// The sign of l - r, each the rounded product of two rounded differences of coordinates.
///
/// l and r have three roundings each, so |(l - r) - exact| <= (3u + O(u^2)) (|l| + |r|) + 2^-1074, and the rounded
/// difference has the sign of l - r. As |l| + |r| <= 2 |l| + |l - r|, it is enough that
/// (1 - 3u) |l - r| > 6u |l| and what is left. 6.6614e-16 is 6u and a hundred-thousandth of it, more than all terms in
/// u^2 together.
[[nodiscard]] inline FilteredSign sign_of_difference(double l, double r) {
  return sign_if_beyond(l - r, 6.6614e-16 * std::abs(l));
}

}  // namespace detail

// ---- orient2d ----

[[nodiscard]] inline FilteredSign orient2d_filter(const Point2& a, const Point2& b, const Point2& c) {
  const Pair c_xy = xy_of(c), products = (xy_of(a) - c_xy) * swapped(xy_of(b) - c_xy);
  return detail::sign_of_difference(products[0], products[1]);
}
[[nodiscard]] Sign orient2d_exact(const Point2& a, const Point2& b, const Point2& c);

/// On which side of the line ab does c lie?
///
/// returns  positive if a, b, c turn counter-clockwise (c left of ab), zero if they are collinear
/// Exact for all finite coordinates. Antisymmetric under every swap of two points.
/// Filter after Shewchuk, Discrete & Computational Geometry 18 (1997), section 4.
[[nodiscard]] inline Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  if (const FilteredSign s = orient2d_filter(a, b, c); s.is_certain()) [[likely]]
    return *s;
  return orient2d_exact(a, b, c);
}

// ---- incircle ----

/// The determinant |U|^2 [V W] - |V|^2 [U W] + |W|^2 [U V] of the vectors from d, the brackets being minors, computed
/// two of each kind at a time.
///
/// Error bound. A product of four rounded differences has 4 roundings in its factors and 3 of its own, its square 1
/// more, its minor at most 1, the sum 2: 11u + O(u^2) times the sum over the three vectors of |U|^2 (|Vx Wy| + |Wx Vy|).
/// By Cauchy and Schwarz the last factor is at most |V| |W|, so the sum is at most uvw (u + v + w) <= (uv + vw + wu)^2 / 3
/// <= L^2 / 3, u = |U| and so on, L = |U|^2 + |V|^2 + |W|^2. 11u/3 < 2^-51 = 4u leaves a twelfth for the terms in u^2. A
/// minor or square that underflows adds less than 2^-1073 L, a final product 2^-1073: together less than the guard plus
/// 2^-1000 L^2. No term exceeds L^2, so nothing overflows unless L^2 does.
[[nodiscard]] inline FilteredSign incircle_filter(const Point2& a, const Point2& b, const Point2& c,
                                                  const Point2& d) {
  const Pair d_xy = xy_of(d), u = xy_of(a) - d_xy, v = xy_of(b) - d_xy, w = xy_of(c) - d_xy;
  const Pair uv_x = firsts(u, v), uv_y = seconds(u, v), w_x = firsts(w, w), w_y = seconds(w, w);
  const Pair uv_square = uv_x * uv_x + uv_y * uv_y, w_square = w_x * w_x + w_y * w_y;
  const Pair uw_vw = uv_x * w_y - uv_y * w_x;
  const Pair sums = swapped(uw_vw) * uv_square + uv_x * swapped(uv_y) * w_square;
  const double size = uv_square[0] + uv_square[1] + w_square[0];
  return sign_if_beyond(sums[0] - sums[1], 0x1p-51 * (size * size));
}
[[nodiscard]] Sign incircle_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// Does d lie inside the circle through a, b, c?
///
/// a, b, c  counter-clockwise; if they turn clockwise the sign is reversed
/// returns  positive if d lies inside, zero on the circle, negative outside; if a, b, c are collinear, the
///          sign of the determinant all the same
/// Exact for all finite coordinates. Antisymmetric under every swap of two of the four points.
[[nodiscard]] inline Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (const FilteredSign s = incircle_filter(a, b, c, d); s.is_certain()) [[likely]]
    return *s;
  return incircle_exact(a, b, c, d);
}

/// The sign of incircle(a, b, c, d) after a symbolic perturbation, for four points whose incircle is zero: a precondition.
[[nodiscard]] Sign incircle_tie(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// incircle with ties broken by coordinates alone, so that every point set has one Delaunay triangulation.
///
/// a, b, c  counter-clockwise (clockwise: the sign is reversed)
/// returns  as incircle where that is not zero; else as if each point were lifted off the paraboloid by an
///          infinitesimal height that grows with its lexicographic rank. Never zero if a, b, c turn and the
///          four points are distinct; zero if two points are equal or all four collinear.
/// Exact for all finite coordinates. Antisymmetric under every swap of two of the four points.
/// Method: Devillers and Teillaud, Computational Geometry 44 (2011), "Perturbations for Delaunay and weighted
/// Delaunay 3D triangulations", here in the plane.
[[nodiscard]] inline Sign incircle_perturbed(const Point2& a, const Point2& b, const Point2& c,
                                             const Point2& d) {
  const Sign s = incircle(a, b, c, d);
  if (s != Sign::zero) [[likely]]
    return s;
  return incircle_tie(a, b, c, d);
}

// ---- in_diametral_circle ----

[[nodiscard]] inline FilteredSign in_diametral_circle_filter(const Point2& p, const Point2& a,
                                                             const Point2& b) {
  return detail::sign_of_difference((a.x - p.x) * (p.x - b.x), (a.y - p.y) * (b.y - p.y));
}
[[nodiscard]] Sign in_diametral_circle_exact(const Point2& p, const Point2& a, const Point2& b);

/// Does p lie inside the circle that has ab as a diameter, that is, is the angle apb obtuse?
///
/// returns  positive strictly inside, zero on the circle, negative outside
/// Exact for all finite coordinates. Unchanged if a and b are swapped.
[[nodiscard]] inline Sign in_diametral_circle(const Point2& p, const Point2& a, const Point2& b) {
  if (const FilteredSign s = in_diametral_circle_filter(p, a, b); s.is_certain()) [[likely]]
    return *s;
  return in_diametral_circle_exact(p, a, b);
}

// ---- angle ----

/// Is the angle at `apex` between the rays to a and b acute, right or obtuse?
///
/// returns  the sign of its cosine: positive if it is acute, negative if it is obtuse; zero if it is right or if a ray has
///          no direction, a or b being the apex
/// Exact for all finite coordinates. Unchanged if a and b are swapped.
[[nodiscard]] inline Sign angle(const Point2& a, const Point2& apex, const Point2& b) {
  return -in_diametral_circle(apex, a, b);
}

// ---- compare_distance ----

/// Error bound: 4 roundings in each of the squared distances A and B, so 4u (A + B) <= 4u (2 A + |A - B|) and terms in
/// u^2; 8.8819e-16 is 8u and a hundred-thousandth of it.
[[nodiscard]] inline FilteredSign compare_distance_filter(const Point2& p, const Point2& a, const Point2& b) {
  const Vec2 u = a - p, v = b - p;
  const double uu = dot(u, u);
  return sign_if_beyond(uu - dot(v, v), 8.8819e-16 * uu);
}
[[nodiscard]] Sign compare_distance_exact(const Point2& p, const Point2& a, const Point2& b);

/// Which of a and b lies farther from p?
///
/// returns  positive if a does, zero if both are equally far, negative if b does
/// Exact for all finite coordinates. Antisymmetric in a and b.
[[nodiscard]] inline Sign compare_distance(const Point2& p, const Point2& a, const Point2& b) {
  if (const FilteredSign s = compare_distance_filter(p, a, b); s.is_certain()) [[likely]]
    return *s;
  return compare_distance_exact(p, a, b);
}

// ---- compare_xy ----

namespace detail {
/// throws  InputError: neither of two points comes first, nor are they equal
[[noreturn]] void refuse_order(const Point2& a, const Point2& b);
}  // namespace detail

/// Lexicographic order of two points, x before y: the order of symbolic perturbation.
///
/// returns  negative if a comes first, zero if the points are equal (-0 equal to +0), positive if b comes first
/// throws   InputError if a coordinate that is compared is NaN; infinities have their place in the order
[[nodiscard]] constexpr Sign compare_xy(const Point2& a, const Point2& b) {
  if (a < b) return Sign::negative;
  if (b < a) return Sign::positive;
  if (a != b) detail::refuse_order(a, b);
  return Sign::zero;
}

}  // namespace leonhard::kernel
