// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leonhard::app {

/// Letters to insert, delete, change or swap with their neighbour to make one word from the other (optimal
/// string alignment distance). Cost O(|a| |b|).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to the word, if near enough to be meant: at most one letter in three is wrong. The
/// first of equals.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word,
                                                      std::span<const std::string> candidates);

/// `did you mean "x"?` for the nearest candidate, else `known here: a, b, c`.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace leonhard::app
