// SPDX-License-Identifier: MIT
#include "leonhard/kernel/predicates.hpp"

#include <algorithm>
#include <array>
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

/// incircle's determinant, see incircle_filter.
template <class Number>
auto incircle_determinant(const LongVec2<Number>& u, const LongVec2<Number>& v, const LongVec2<Number>& w) {
  return cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w);
}

/// The determinant of incircle_filter in double-double numbers. The vectors are exact; a square or minor has errors of
/// (7 + 3) u^2, their product 7 u^2 more, the sum 2 * 3 u^2: 33 u^2 L^2 / 3 with the estimates made there, and
/// 2^-102 = 16 u^2 leaves room for underflow and for L, which is rounded.
FilteredSign incircle_double_double(const LongVec2<DoubleDouble>& u, const LongVec2<DoubleDouble>& v,
                                    const LongVec2<DoubleDouble>& w) {
  const double size = rounded_square(u) + rounded_square(v) + rounded_square(w);
  return sign_if_beyond(incircle_determinant(u, v, w).high, 0x1p-102 * (size * size));
}

double rounded_incircle(Vec2 u, Vec2 v, Vec2 w) {
  return cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w);
}

StagedSign orient2d_beyond_filter(const Point2& a, const Point2& b, const Point2& c) {
  detail::require_finite("orient2d", a, b, c);
  const Vec2 l = a - c, r = b - c;
  if (are_small_multiples<26>(std::array{xy_of(l), xy_of(r)}, std::array{xy_of(a), xy_of(b), xy_of(c)}))
    return {sign_of(cross(l, r)), Stage::small_integer};  // below 2 * 2^(2 * 26) units
  if (const auto s = integer::orient2d(a, b, c)) return {*s, Stage::integer};
  std::array points{a, b, c};
  if (!fit(points, exact_window<2>)) return wide_range::orient2d(a, b, c);
  return {
      cross(expanded(long_difference(points[0], points[2])), expanded(long_difference(points[1], points[2])))
          .sign(),
      Stage::expansion};
}

StagedSign incircle_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  detail::require_finite("incircle", a, b, c, d);
  const Vec2 to_a = a - d, to_b = b - d, to_c = c - d;
  if (are_small_multiples<12>(std::array{xy_of(to_a), xy_of(to_b), xy_of(to_c)},
                              std::array{xy_of(a), xy_of(b), xy_of(c), xy_of(d)}))
    return {sign_of(rounded_incircle(to_a, to_b, to_c)),
            Stage::small_integer};  // below 12 * 2^(4 * 12) units
  if (const auto s = integer::incircle(a, b, c, d)) return {*s, Stage::integer};
  std::array points{a, b, c, d};
  if (!fit(points, exact_window<4>)) return wide_range::incircle(a, b, c, d);
  const auto u = long_difference(points[0], points[3]);
  const auto v = long_difference(points[1], points[3]);
  const auto w = long_difference(points[2], points[3]);
  if (const FilteredSign s = incircle_double_double(u, v, w); s.is_certain())
    return {*s, Stage::double_double};
  return {incircle_determinant(expanded(u), expanded(v), expanded(w)).sign(), Stage::expansion};
}

}  // namespace

void detail::refuse_order(const Point2& a, const Point2& b) {
  refuse_not_finite("compare_xy", a, b);
  throw InputError("compare_xy", "the points have no order");  // not reached
}

Sign orient2d_exact(const Point2& a, const Point2& b, const Point2& c) {
  return orient2d_beyond_filter(a, b, c).sign;
}
StagedSign orient2d_staged(const Point2& a, const Point2& b, const Point2& c) {
  if (const FilteredSign s = orient2d_filter(a, b, c); s.is_certain()) return {*s, Stage::filter};
  return orient2d_beyond_filter(a, b, c);
}

Sign incircle_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return incircle_beyond_filter(a, b, c, d).sign;
}
StagedSign incircle_staged(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (const FilteredSign s = incircle_filter(a, b, c, d); s.is_certain()) return {*s, Stage::filter};
  return incircle_beyond_filter(a, b, c, d);
}

Sign incircle_tie(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  // Lifting one point by h changes the determinant by h times the orientation of the other three, in the
  // order that keeps the sign of the permutation. The point of highest rank is lifted infinitely more than
  // the rest together.
  std::array ranked{std::pair{a, 0}, std::pair{b, 1}, std::pair{c, 2}, std::pair{d, 3}};
  std::ranges::sort(ranked, [](const auto& p, const auto& q) { return p.first > q.first; });
  for (std::size_t i = 1; i < ranked.size(); ++i)
    if (ranked[i].first == ranked[i - 1].first) return Sign::zero;
  for (const auto& [point, position] : ranked) {
    Sign s = Sign::zero;
    switch (position) {
      case 0:
        s = orient2d(d, b, c);
        break;
      case 1:
        s = orient2d(a, d, c);
        break;
      case 2:
        s = orient2d(a, b, d);
        break;
      default:
        s = -orient2d(a, b, c);
    }
    if (s != Sign::zero) return s;
  }
  return Sign::zero;
}

Sign in_diametral_circle_exact(const Point2& p, const Point2& a, const Point2& b) {
  detail::require_finite("in_diametral_circle", p, a, b);
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return wide_range::in_diametral_circle(p, a, b);
  return -dot(expanded(long_difference(points[1], points[0])),
              expanded(long_difference(points[2], points[0])))
              .sign();
}

Sign compare_distance_exact(const Point2& p, const Point2& a, const Point2& b) {
  detail::require_finite("compare_distance", p, a, b);
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return wide_range::compare_distance(p, a, b);
  const auto u = expanded(long_difference(points[1], points[0])),
             v = expanded(long_difference(points[2], points[0]));
  return (dot(u, u) - dot(v, v)).sign();
}

}  // namespace leonhard::kernel
