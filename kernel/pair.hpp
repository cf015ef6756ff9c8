// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <type_traits>

#include "leonhard/kernel/point.hpp"

/// Two doubles side by side for filters (filtered_sign.hpp), in the vector type of GCC and clang: every processor that we
/// know of, x86-64 without options among them, computes with both at once. Rounds as two doubles do.
namespace leonhard::kernel {

using Pair = double __attribute__((vector_size(16)));

[[nodiscard]] inline Pair both(double x) { return Pair{x, x}; }
[[nodiscard]] inline Pair swapped(Pair p) { return Pair{p[1], p[0]}; }
[[nodiscard]] inline Pair firsts(Pair p, Pair q) { return Pair{p[0], q[0]}; }
[[nodiscard]] inline Pair seconds(Pair p, Pair q) { return Pair{p[1], q[1]}; }

[[nodiscard]] inline Pair absolute(Pair p) {
  using Bits = long long __attribute__((vector_size(16)));
  constexpr long long all_but_sign = 0x7fffffffffffffff;
  return reinterpret_cast<Pair>(reinterpret_cast<Bits>(p) & Bits{all_but_sign, all_but_sign});
}

/// The first two coordinates of a point or vector, read at once.
template <class PointOrVector>
[[nodiscard]] inline Pair xy_of(const PointOrVector& p) {
  static_assert(std::is_standard_layout_v<PointOrVector> && sizeof(p) >= sizeof(Pair));
  Pair xy;
  std::memcpy(&xy, &p, sizeof xy);
  return xy;
}

}  // namespace leonhard::kernel
