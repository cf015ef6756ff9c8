// SPDX-License-Identifier: MIT
#include "leonhard/kernel/power.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>

#include "leonhard/kernel/arithmetic/exact_range.hpp"
#include "leonhard/kernel/arithmetic/long_vector.hpp"
#include "leonhard/kernel/stages/finite.hpp"
#include "leonhard/kernel/stages/wide_predicates.hpp"

namespace leonhard::kernel {
namespace {

// ---- range ----

/// Binary exponents of the numbers other than 0 that were shown to it.
class ExponentRange {
 public:
  void show(double x) {
    if (x == 0) return;
    const int exponent = std::ilogb(x);
    lowest_ = std::min(lowest_, exponent);
    highest_ = std::max(highest_, exponent);
  }

  [[nodiscard]] bool empty() const { return lowest_ > highest_; }
  [[nodiscard]] int lowest() const { return lowest_; }
  [[nodiscard]] int highest() const { return highest_; }

 private:
  int lowest_ = INT_MAX, highest_ = INT_MIN;
};

int half_down(int x) { return (x - (x < 0 ? 1 : 0)) / 2; }
int half_up(int x) { return -half_down(-x); }

/// As fit of points: multiplies coordinates by a power of two and weights by its square, so that coordinates
/// come into the window of `Degree` and weights where squares of coordinates are: their lowest bit at 2
/// (lowest - 52) or higher, their difference below 2^(2 (highest + 2)). Heights then have three terms and not
/// two, and insphere's 72 products become 96, for which the window has room too.
template <int Degree, class WeightedPoint, std::size_t Count>
[[nodiscard]] bool fit_weighted(std::array<WeightedPoint, Count>& points) {
  constexpr ExponentWindow window = exact_window<Degree>;
  constexpr ExponentWindow weight_window{2 * window.lowest - 52, 2 * window.highest + 2};
  ExponentRange lengths, weights;
  for (WeightedPoint& p : points) {
    for (const double* coordinate : coordinates(p.point)) lengths.show(*coordinate);
    weights.show(p.weight);
  }
  int lowest_shift = -10'000, highest_shift = 10'000;
  if (!lengths.empty()) {
    lowest_shift = window.lowest - lengths.lowest();
    highest_shift = window.highest - lengths.highest();
  }
  if (!weights.empty()) {
    lowest_shift = std::max(lowest_shift, half_up(weight_window.lowest - weights.lowest()));
    highest_shift = std::min(highest_shift, half_down(weight_window.highest - weights.highest()));
  }
  if (lowest_shift <= 0 && highest_shift >= 0) return true;
  if (lowest_shift > highest_shift) return false;
  for (WeightedPoint& p : points) {
    for (double* coordinate : coordinates(p.point)) *coordinate = std::scalbn(*coordinate, highest_shift);
    p.weight = std::scalbn(p.weight, 2 * highest_shift);
  }
  return true;
}

// ---- relative to one point ----

/// The vector from one weighted point to another and the difference of their weights, all exact.
template <class Vector, class Number>
struct Relative {
  Vector vector;
  Number weight;
};
template <class Vector, class Number>
Relative(Vector, Number) -> Relative<Vector, Number>;

template <class WeightedPoint>
auto relative(const WeightedPoint& a, const WeightedPoint& origin) {
  return Relative{long_difference(a.point, origin.point),
                  DoubleDouble{two_difference(a.weight, origin.weight)}};
}

template <class Vector>
bool is_one_double(const Relative<Vector, DoubleDouble>& a) {
  return kernel::is_one_double(a.vector) && a.weight.low == 0;
}

/// |A|^2 - g.
template <class Vector, class Number>
auto height(const Relative<Vector, Number>& a) {
  return dot(a.vector, a.vector) - a.weight;
}

template <class Vector>
auto expanded(const Relative<Vector, DoubleDouble>& a) {
  return Relative{kernel::expanded(a.vector), Expansion<2>(a.weight)};
}

// ---- determinants of longer numbers ----

template <class Number>
auto power_determinant(const Relative<LongVec2<Number>, Number>& a,
                       const Relative<LongVec2<Number>, Number>& b,
                       const Relative<LongVec2<Number>, Number>& c) {
  return detail::lifted_determinant(a.vector, b.vector, c.vector, height(a), height(b), height(c));
}
template <class Number>
auto power_determinant(const Relative<LongVec3<Number>, Number>& a,
                       const Relative<LongVec3<Number>, Number>& b,
                       const Relative<LongVec3<Number>, Number>& c,
                       const Relative<LongVec3<Number>, Number>& d) {
  return detail::lifted_determinant(a.vector, b.vector, c.vector, d.vector, height(a), height(b), height(c),
                                    height(d));
}

using Relative2 = Relative<LongVec2<DoubleDouble>, DoubleDouble>;
using Relative3 = Relative<LongVec3<DoubleDouble>, DoubleDouble>;

/// As power_test_filter. Vectors and weights are exact; a square has errors of 10 u^2, a height 3 u^2 more, a
/// minor 10 u^2, their product 7 u^2, the sum 2 * 3 u^2: 36 u^2 (L^2 / 3 + G L / 2) with the estimates made
/// there. 16 u^2 L (L + 1.5 G) leaves a quarter for the roundings of L and G; nothing underflows, for all
/// bits are in range.
FilteredSign power_test_double_double(const Relative2& a, const Relative2& b, const Relative2& c) {
  const DoubleDouble determinant = power_determinant(a, b, c);
  const double size = rounded_square(a.vector) + rounded_square(b.vector) + rounded_square(c.vector);
  const double weights = std::abs(a.weight.high) + std::abs(b.weight.high) + std::abs(c.weight.high);
  return sign_if_beyond(determinant.high, 0x1p-102 * (size * (size + 1.5 * weights)));
}

/// As power_test_filter. Vectors and weights are exact; a product has errors of 4 * 7 u^2, its minor 3 u^2,
/// the height 3 u^2 and the sums (2 + 2 + 2) 3 u^2: 52 u^2 S sqrt S (0.1444 S + 0.2223 G) with the estimates
/// made there. 8 u^2 S sqrt S (S + 1.5 G) leaves a thirtieth for the rest.
FilteredSign power_test_double_double(const Relative3& a, const Relative3& b, const Relative3& c,
                                      const Relative3& d) {
  const DoubleDouble determinant = power_determinant(a, b, c, d);
  const double size = rounded_square(a.vector) + rounded_square(b.vector) + rounded_square(c.vector) +
                      rounded_square(d.vector);
  const double weights =
      std::abs(a.weight.high) + std::abs(b.weight.high) + std::abs(c.weight.high) + std::abs(d.weight.high);
  return sign_if_beyond(determinant.high, 0x1p-103 * (size * std::sqrt(size) * (size + 1.5 * weights)));
}

template <class WeightedPoint>
Sign compare_power_distance_expansion(const WeightedPoint& p, const WeightedPoint& a,
                                      const WeightedPoint& b) {
  return (height(expanded(relative(a, p))) - height(expanded(relative(b, p)))).sign();
}

}  // namespace

// The stages are those of incircle_exact and insphere_exact.

Sign power_test_exact(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                      const WeightedPoint2& d) {
  detail::require_finite("power_test", a, b, c, d);
  std::array points{a, b, c, d};
  if (!fit_weighted<4>(points)) return wide_range::power_test(a, b, c, d);
  const auto u = relative(points[0], points[3]);
  const auto v = relative(points[1], points[3]);
  const auto w = relative(points[2], points[3]);
  if (!(is_one_double(u) && is_one_double(v) && is_one_double(w)))
    if (const FilteredSign s = power_test_double_double(u, v, w); s.is_certain()) return *s;
  return power_determinant(expanded(u), expanded(v), expanded(w)).sign();
}

Sign power_test_exact(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                      const WeightedPoint3& d, const WeightedPoint3& e) {
  detail::require_finite("power_test", a, b, c, d, e);
  std::array points{a, b, c, d, e};
  if (!fit_weighted<5>(points)) return wide_range::power_test(a, b, c, d, e);
  const auto u = relative(points[0], points[4]);
  const auto v = relative(points[1], points[4]);
  const auto w = relative(points[2], points[4]);
  const auto t = relative(points[3], points[4]);
  if (!(is_one_double(u) && is_one_double(v) && is_one_double(w) && is_one_double(t)))
    if (const FilteredSign s = power_test_double_double(u, v, w, t); s.is_certain()) return *s;
  return power_determinant(expanded(u), expanded(v), expanded(w), expanded(t)).sign();
}

Sign compare_power_distance_exact(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b) {
  detail::require_finite("compare_power_distance", p, a, b);
  std::array points{WeightedPoint2{p, 0}, a, b};
  if (!fit_weighted<2>(points)) return wide_range::compare_power_distance(p, a, b);
  return compare_power_distance_expansion(points[0], points[1], points[2]);
}

Sign compare_power_distance_exact(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b) {
  detail::require_finite("compare_power_distance", p, a, b);
  std::array points{WeightedPoint3{p, 0}, a, b};
  if (!fit_weighted<2>(points)) return wide_range::compare_power_distance(p, a, b);
  return compare_power_distance_expansion(points[0], points[1], points[2]);
}

}  // namespace leonhard::kernel
