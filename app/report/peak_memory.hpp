// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace leonhard::app {

/// Largest resident set of this process so far, bytes.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace leonhard::app
