// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace leonhard::io {

/// Number of single-character insertions, deletions, replacements and swaps of neighbours that turn one word
/// into the other, capitals counting as small letters (optimal string alignment distance).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// `did you mean "X"?` with the nearest known word, or "" if none is near: at most one edit for words up to
/// four letters, a third of the letters for longer ones. Ties go to the first.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace leonhard::io
