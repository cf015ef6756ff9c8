// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace leonhard::kernel {

/// Does this machine, as it is now set, compute as the exact predicates need it?
///
/// returns  none if all is well; else in words what is broken: products and sums fused into one rounding,
///          intermediate results kept in excess precision or sums reassociated, a rounding mode other than to
///          nearest, subnormal results flushed or subnormal operands taken as zero
/// Cost: nanoseconds. Programs call it once at start and refuse to go on; a library loaded later may change
/// the modes of a thread, so it may be called again.
[[nodiscard]] std::optional<std::string> floating_point_self_test();

}  // namespace leonhard::kernel
