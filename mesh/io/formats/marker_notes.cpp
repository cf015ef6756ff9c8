// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/marker_notes.hpp"

#include <algorithm>
#include <charconv>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::io {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Whether a line of text can hold the name so that it is found again.
bool is_plain(std::string_view name) {
  return !name.empty() && trimmed(name) == name && std::none_of(name.begin(), name.end(), is_control);
}

void check_name(Marker marker, const std::string& name, std::string_view word) {
  if (!is_plain(name))
    throw InputError(
        std::string(word) + " " + std::to_string(marker),
        "its name \"" + name + "\" is empty, holds a control character, or begins or ends with a blank",
        "choose a name that a text file can hold");
}

}  // namespace

std::string format_marker_notes(const std::map<Marker, std::string>& names, char comment,
                                std::string_view word) {
  std::string text;
  for (const auto& [marker, name] : names) {
    check_name(marker, name, word);
    text +=
        std::string(1, comment) + " " + std::string(word) + " " + std::to_string(marker) + " " + name + "\n";
  }
  return text;
}

std::map<Marker, std::string> read_marker_notes(std::string_view text, char comment, std::string_view word) {
  std::map<Marker, std::string> names;
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    std::string_view line = trimmed(text.substr(0, newline));
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    if (line.empty()) continue;
    if (line.front() != comment) break;
    line = trimmed(line.substr(1));
    if (!line.starts_with(word) || !line.substr(word.size()).starts_with(' ')) continue;
    line.remove_prefix(word.size() + 1);
    Marker marker = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), marker);
    const std::string_view rest = line.substr(static_cast<std::size_t>(end - line.data()));
    const std::string_view name = trimmed(rest);
    if (error != std::errc{} || !rest.starts_with(' ') || !is_plain(name)) continue;
    const auto same_name = [&](const auto& entry) { return entry.second == name; };
    if (names.contains(marker) || std::any_of(names.begin(), names.end(), same_name)) return {};
    names.emplace(marker, name);
  }
  return names;
}

}  // namespace leonhard::io
