// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/support/lanes.hpp"

// Limiter formulas: how much of a step the reconstruction may take, given how much room the neighbours' values leave.
// The loop that finds room and step is in sweep_impl.hpp. All formulas, cut off at 1, do not increase with the step,
// so it is enough to ask for the longest step up and the longest step down of each vertex.

namespace leonhard::solver {

/// Barth and Jespersen (AIAA 89-0366): min(1, room / step).
/// room, step  of one sign or zero; step = 0 gives 1
template <class T>
LEONHARD_INLINE T limit_barth_jespersen(const T& room, const T& step) {
  const T room_size = magnitude<T>(room), step_size = magnitude<T>(step);
  return select(step_size > room_size, T(room_size / (step_size + 1e-300)), constant<T>(1));
}

/// Venkatakrishnan (Journal of Computational Physics 118, 1995), cut off at 1:
/// (room^2 + e + 2 step room) / (room^2 + 2 step^2 + room step + e). Smooth; a variation below sqrt(e) passes unlimited.
/// scale2  e > 0, of the unit of room squared
template <class T>
LEONHARD_INLINE T limit_venkatakrishnan(const T& room, const T& step, const T& scale2) {
  const T base = room * room + scale2, mixed = room * step;
  return smaller<T>((base + 2.0 * mixed) / (base + mixed + 2.0 * step * step), constant<T>(1));
}

/// H. Nishikawa's R3 (AIAA 2022-1374): Venkatakrishnan's form one power higher, which takes less from a step of more than half the
/// room, and nothing from a shorter one; e likewise.
/// scale3  e > 0, of the unit of room cubed
template <class T>
LEONHARD_INLINE T limit_nishikawa_r3(const T& room, const T& step, const T& scale3) {
  const T a = magnitude<T>(room), b = magnitude<T>(step);
  const T base = a * a * a + scale3, four = 4.0 * b * b;
  return select(a > 2.0 * b, constant<T>(1), T((base + a * four) / (base + b * (a * a + four))));
}

}  // namespace leonhard::solver
