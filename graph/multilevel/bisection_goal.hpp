// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace leonhard::graph::detail {

/// How heavy the two sides should be and may be.
struct BisectionGoal {
  std::array<std::int64_t, 2> target;  ///< sum: the graph's weight
  std::array<std::int64_t, 2> limit;   ///< at least the target
};

}  // namespace leonhard::graph::detail
