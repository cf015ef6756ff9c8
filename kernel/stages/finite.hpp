// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

#include "leonhard/kernel/pair.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/weighted_point.hpp"

/// The check that the stages behind a filter make. The filter needs none: NaN and infinities make its bound NaN or
/// infinite, so that it cannot tell; neither do small integers (small_multiples.hpp), which they are not.
namespace leonhard::kernel::detail {

/// values  of the point at `place`, counted from 1, in the call of `where`
[[noreturn]] void throw_not_finite(const char* where, std::size_t place, std::span<const double> values);

/// The coordinates of a point, then its weight if it has one.
template <class AnyPoint>
[[nodiscard]] std::array<double, sizeof(AnyPoint) / sizeof(double)> values_of(const AnyPoint& p) {
  static_assert(std::is_standard_layout_v<AnyPoint> && sizeof(AnyPoint) % sizeof(double) == 0);
  std::array<double, sizeof(AnyPoint) / sizeof(double)> values;
  std::memcpy(values.data(), &p, sizeof p);
  return values;
}

/// Something finite, unless a value is not or the sum overflows.
[[nodiscard]] inline double sum_of_values(const Point2& p) { return p.x + p.y; }
[[nodiscard]] inline double sum_of_values(const Point3& p) { return p.x + p.y + p.z; }
template <class WeightedPoint>
[[nodiscard]] inline double sum_of_values(const WeightedPoint& p) {
  return sum_of_values(p.point) + p.weight;
}
template <class... AnyPoints>
[[nodiscard]] inline double sum_of_all(const AnyPoints&... points) {
  return (sum_of_values(points) + ...);
}
[[nodiscard]] inline double sum_of_all(const Point2& a, const Point2& b, const Point2& c) {
  const Pair sum = xy_of(a) + xy_of(b) + xy_of(c);
  return sum[0] + sum[1];
}
[[nodiscard]] inline double sum_of_all(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Pair sum = (xy_of(a) + xy_of(b)) + (xy_of(c) + xy_of(d));
  return sum[0] + sum[1];
}
[[nodiscard]] inline double sum_of_all(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Pair sum = (xy_of(a) + xy_of(b)) + (xy_of(c) + xy_of(d));
  return (sum[0] + sum[1]) + ((a.z + b.z) + (c.z + d.z));
}
[[nodiscard]] inline double sum_of_all(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                       const Point3& e) {
  const Pair sum = (xy_of(a) + xy_of(b)) + (xy_of(c) + xy_of(d)) + xy_of(e);
  return (sum[0] + sum[1]) + ((a.z + b.z) + (c.z + d.z)) + e.z;
}

/// Returns if all values are finite after all, their sum alone having overflowed.
template <class... AnyPoints>
[[gnu::cold, gnu::noinline]] void refuse_not_finite(const char* where, const AnyPoints&... points) {
  std::size_t place = 0;
  const auto refuse_if_bad = [&](std::span<const double> values) {
    ++place;
    for (const double x : values)
      if (!std::isfinite(x)) throw_not_finite(where, place, values);
  };
  (refuse_if_bad(values_of(points)), ...);
}

/// throws  InputError, naming the predicate or construction and the first point that is not finite
///
/// A sum that is finite has finite terms: infinities of unlike sign make NaN, and neither they nor NaN go away.
template <class... AnyPoints>
[[gnu::always_inline]] inline void require_finite(const char* where, const AnyPoints&... points) {
  const double sum = sum_of_all(points...);
  if (!(sum - sum == 0)) [[unlikely]]
    refuse_not_finite(where, points...);
}

}  // namespace leonhard::kernel::detail
