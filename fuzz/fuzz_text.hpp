// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/input_error.hpp"

/// What the fuzz targets of readers share: texts made from an input, and findings printed with the text.
namespace leonhard::fuzzing {

[[noreturn]] inline void report(const std::string& broken, std::string_view text) {
  std::fprintf(stderr, "\n%s, for the text\n", broken.c_str());
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fprintf(stderr, "\n");
  std::abort();
}

/// A text that its reader accepts, and what is tried with texts like it.
struct Format {
  std::string valid;
  void (*attempt)(const std::string& text);
};

/// The formats, each reader having accepted its valid text: edits to one that is refused reach nothing.
inline std::vector<Format> accepted(std::vector<Format> all) {
  for (const Format& format : all) {
    try {
      format.attempt(format.valid);
    } catch (const InputError& error) {
      report(std::string("a valid text was refused: ") + error.what(), format.valid);
    }
  }
  return all;
}

/// Replace, insert and erase bytes, or insert a word that readers fear.
inline std::string edited(std::string text, Input& input) {
  constexpr std::array words{"nan",        "-inf", "1e999", "-1", "0", "1",      "2",  "99999999999",
                             "4294967295", "\n",   " ",     "%",  "#", "1e-320", "0.5"};
  while (!input.empty() && text.size() < 10000) {
    const auto operation = input.take<std::uint8_t>();
    const std::size_t at = input.take<std::uint16_t>() % (text.size() + 1);
    const auto value = input.take<std::uint8_t>();
    if (operation % 4 == 0) text.replace(at, 1, 1, static_cast<char>(value));
    if (operation % 4 == 1) text.insert(at, 1, static_cast<char>(value));
    if (operation % 4 == 2) text.erase(at, value % 16);
    if (operation % 4 == 3) text.replace(at, operation / 4 % 3, words[value % words.size()]);
  }
  return text;
}

/// Takes a format and a text, of its own or edits to the valid one, from the input, and makes the attempt. Only refusals
/// are allowed, but not those of what a writer wrote (whose source is "again") or of what a reader returned.
inline void try_one(const std::vector<Format>& all, Input& input) {
  const auto choice = input.take<std::uint8_t>();
  const Format& format = all[choice / 2 % all.size()];
  std::string text;
  if (choice % 2 == 0) {
    text = edited(format.valid, input);
  } else {
    while (!input.empty()) text += static_cast<char>(input.take<std::uint8_t>());
  }
  try {
    format.attempt(text);
  } catch (const InputError& error) {
    if (error.where().starts_with("again"))
      report(std::string("what a writer wrote was refused: ") + error.what(), text);
    if (std::string_view(error.what()).find("marker ") == 0)
      report(std::string("a writer refused what its reader returned: ") + error.what(), text);
  }
}

/// What a target of readers does with an input; the formats are made once.
inline int try_formats(std::vector<Format> (*formats)(), const std::uint8_t* data, std::size_t size) {
  static const std::vector<Format> all = accepted(formats());
  Input input(data, size);
  try_one(all, input);
  return 0;
}

}  // namespace leonhard::fuzzing
