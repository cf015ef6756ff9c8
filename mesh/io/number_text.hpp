// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <string>

namespace leonhard::io {

/// Append a number to a text: integers in decimal, doubles as the shortest decimal that reads back as the
/// same bits.
template <class Number>
void append_number(std::string& text, Number value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

}  // namespace leonhard::io
