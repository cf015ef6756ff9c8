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

/// The check that every stage behind a filter makes first. A filter needs none: NaN and infinities make its bound NaN or
/// infinite, so that it cannot tell.
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

/// 0 in both if all is finite, else NaN in one.
[[nodiscard]] inline Pair finite_zeros(const Point2& p) { return xy_of(p) - xy_of(p); }
[[nodiscard]] inline Pair finite_zeros(const Point3& p) { return (xy_of(p) - xy_of(p)) + Pair{p.z - p.z, 0}; }
template <class WeightedPoint>
[[nodiscard]] inline Pair finite_zeros(const WeightedPoint& p) {
  return finite_zeros(p.point) + Pair{p.weight - p.weight, 0};
}

template <class... AnyPoints>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_not_finite(const char* where, const AnyPoints&... points) {
  std::size_t place = 0;
  const auto refuse_if_bad = [&](std::span<const double> values) {
    ++place;
    for (const double x : values)
      if (!std::isfinite(x)) throw_not_finite(where, place, values);
  };
  (refuse_if_bad(values_of(points)), ...);
  throw_not_finite(where, 0, {});
}

/// throws  InputError, naming the predicate or construction and the first point that is not finite
template <class... AnyPoints>
[[gnu::always_inline]] inline void require_finite(const char* where, const AnyPoints&... points) {
  const Pair zeros = (finite_zeros(points) + ...);
  if (!(zeros[0] + zeros[1] == 0)) [[unlikely]]
    refuse_not_finite(where, points...);
}

}  // namespace leonhard::kernel::detail
