// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace leonhard::app {

/// `did you mean "x"?` for a candidate near enough to be meant, else `known here: a, b, c`, else "remove it".
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace leonhard::app
