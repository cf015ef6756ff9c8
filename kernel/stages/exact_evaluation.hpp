// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "leonhard/kernel/arithmetic/exact_numbers.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/stages/finite.hpp"
#include "leonhard/kernel/stages/stage.hpp"

namespace leonhard::kernel {

/// Calls evaluate(numbers) -> Sign with Expansions, having scaled the points if need be, or with Integers.
template <class Point, class Evaluate>
[[nodiscard]] StagedSign evaluate_exactly(std::span<Point> points, int degree, Stage first,
                                          Evaluate evaluate) {
  BitRange bits;
  for (Point& p : points) {
    detail::require_finite("predicate of implicit points", p);
    for (const double* x : coordinates(p)) bits.include(*x);
  }
  const std::optional<int> shift = expansion_shift(bits, degree);
  if (!shift || first == Stage::rational) return {evaluate(Integers{bits.lowest}), Stage::rational};
  if (*shift != 0)
    for (Point& p : points)
      for (double* x : coordinates(p)) *x = std::scalbn(*x, *shift);
  return {evaluate(Expansions{}), Stage::expansion};
}

}  // namespace leonhard::kernel
