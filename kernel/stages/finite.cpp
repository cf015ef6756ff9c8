// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/finite.hpp"

#include <charconv>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::kernel::detail {

void throw_not_finite(const char* where, std::size_t place, std::span<const double> values) {
  std::string list;
  for (const double x : values) {
    std::array<char, 32> text;
    list.append(list.empty() ? "(" : ", ");
    list.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr);
  }
  throw InputError(where,
                   "point " + std::to_string(place) + " of the call is " + list + "), which is not finite",
                   "give finite numbers");
}

}  // namespace leonhard::kernel::detail
