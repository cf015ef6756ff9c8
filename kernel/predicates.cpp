// SPDX-License-Identifier: MIT
#include "leonhard/kernel/predicates.hpp"

#include <algorithm>
#include <array>
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
struct LongVec2 {
  Number x, y;
};

/// The exact difference of two points.
LongVec2<DoubleDouble> difference(const Point2& a, const Point2& b) {
  return {{two_difference(a.x, b.x)}, {two_difference(a.y, b.y)}};
}

LongVec2<Expansion<2>> expanded(const LongVec2<DoubleDouble>& v) {
  return {Expansion<2>(v.x), Expansion<2>(v.y)};
}

template <class Number>
auto dot(const LongVec2<Number>& u, const LongVec2<Number>& v) {
  return u.x * v.x + u.y * v.y;
}
template <class Number>
auto cross(const LongVec2<Number>& u, const LongVec2<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

bool is_one_double(const LongVec2<DoubleDouble>& v) { return v.x.low == 0 && v.y.low == 0; }

/// The determinant of incircle_filter in double-double numbers. The vectors are exact; a square or minor has errors of
/// (7 + 3) u^2, their product 7 u^2 more, the sum 2 * 3 u^2: 33 u^2 L^2 / 3 with the estimates made there, and
/// 2^-102 = 16 u^2 leaves room for underflow and for L, which is rounded.
FilteredSign incircle_double_double(const LongVec2<DoubleDouble>& u, const LongVec2<DoubleDouble>& v,
                                    const LongVec2<DoubleDouble>& w) {
  const DoubleDouble uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const DoubleDouble determinant = uu * cross(v, w) + vv * cross(w, u) + ww * cross(u, v);
  const double size = uu.high + vv.high + ww.high;
  return detail::sign_if_beyond(determinant.high, 0x1p-102 * (size * size));
}

Sign incircle_expansion(const LongVec2<Expansion<2>>& u, const LongVec2<Expansion<2>>& v,
                        const LongVec2<Expansion<2>>& w) {
  const Expansion<1536> determinant =
      cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w);
  return determinant.sign();
}

}  // namespace

Sign orient2d_exact(const Point2& a, const Point2& b, const Point2& c) {
  std::array points{a, b, c};
  if (!fit(points, exact_window<2>)) return exact::orient2d(a, b, c);
  return cross(expanded(difference(points[0], points[2])), expanded(difference(points[1], points[2]))).sign();
}

Sign incircle_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  std::array points{a, b, c, d};
  if (!fit(points, exact_window<4>)) return exact::incircle(a, b, c, d);
  const auto u = difference(points[0], points[3]);
  const auto v = difference(points[1], points[3]);
  const auto w = difference(points[2], points[3]);
  // Expansions are quick where the differences are single doubles, as among neighbouring or integer points, and ties
  // are found there; else they grow to hundreds of terms, mostly to decide what 106 bits tell.
  if (!(is_one_double(u) && is_one_double(v) && is_one_double(w)))
    if (const FilteredSign s = incircle_double_double(u, v, w); s.is_certain()) return *s;
  return incircle_expansion(expanded(u), expanded(v), expanded(w));
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
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return exact::in_diametral_circle(p, a, b);
  return -dot(expanded(difference(points[1], points[0])), expanded(difference(points[2], points[0]))).sign();
}

Sign compare_distance_exact(const Point2& p, const Point2& a, const Point2& b) {
  std::array points{p, a, b};
  if (!fit(points, exact_window<2>)) return exact::compare_distance(p, a, b);
  const auto u = expanded(difference(points[1], points[0])), v = expanded(difference(points[2], points[0]));
  return (dot(u, u) - dot(v, v)).sign();
}

}  // namespace leonhard::kernel
