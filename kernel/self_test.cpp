// SPDX-License-Identifier: MIT
#include "leonhard/kernel/self_test.hpp"

#include <limits>

namespace leonhard::kernel {
namespace {

static_assert(std::numeric_limits<double>::is_iec559, "leonhard needs IEEE 754 binary64 doubles");

/// Volatile operands keep the compiler from computing at compile time what this machine should be asked.
bool fuses_products_and_sums() {
  volatile double x = 1 + 0x1p-30, rounded_square = 1 + 0x1p-29;
  const double a = x, b = rounded_square;
  return a * a - b != 0;  // fused, the 2^-60 that rounding drops comes back
}

/// Or has the compiler cancelled operands against each other?
bool keeps_excess_precision() {
  volatile double one = 1, huge = 0x1p1000, tiny = 0x1p-60;
  const double a = one, b = huge, c = tiny;
  return (b * b) / b != std::numeric_limits<double>::infinity() || (a + c) - a != 0;
}

/// Three sums tell the four modes apart: downward and toward zero lose the first, upward the second or, for
/// negative numbers, downward the third.
bool rounds_other_than_to_nearest() {
  volatile double one = 1, quarter_ulp = 0x1p-54, three_quarters_ulp = 0x3p-54;
  const double a = one, q = quarter_ulp, t = three_quarters_ulp;
  return a + t != 1 + 0x1p-52 || a + q != 1 || -a - q != -1 || a + 0x1p-53 != 1;
}

bool flushes_subnormals() {
  volatile double smallest_normal = std::numeric_limits<double>::min(), half = 0.5;
  volatile double smallest = std::numeric_limits<double>::denorm_min(), two = 2;
  const double flushed_result = smallest_normal * half, flushed_operand = smallest * two;
  return flushed_result == 0 || flushed_operand == 0;
}

}  // namespace

std::optional<std::string> floating_point_self_test() {
  std::string broken;
  const auto report = [&broken](bool is_broken, const char* words) {
    if (!is_broken) return;
    if (!broken.empty()) broken += "; ";
    broken += words;
  };
  report(fuses_products_and_sums(),
         "products and sums are fused into one rounding (compile with -ffp-contract=off)");
  report(keeps_excess_precision(), "intermediate results keep excess precision or sums are reassociated (compile for SSE2, not x87, and without "
         "-ffast-math)");
  report(rounds_other_than_to_nearest(),
         "the rounding mode is not to nearest (a library changed it: fesetround)");
  report(flushes_subnormals(),
         "subnormal numbers are flushed to zero (a library compiled with -ffast-math changed the mode)");
  if (broken.empty()) return std::nullopt;
  return broken;
}

}  // namespace leonhard::kernel
