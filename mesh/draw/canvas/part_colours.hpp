// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace leonhard::draw {

/// A number of a colour to each part, none shared by parts that touch, about eight in all. Not meant for callers of the
/// room.
///
/// touching  the parts that touch each part
/// Method: Welsh and Powell, Computer Journal 10 (1967) 85-86, many neighbours first; of the free colours the one used
/// least, so that all are seen.
[[nodiscard]] std::vector<std::size_t> colour_parts(const std::vector<std::set<std::uint32_t>>& touching);

}  // namespace leonhard::draw
