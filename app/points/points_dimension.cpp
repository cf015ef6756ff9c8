// SPDX-License-Identifier: MIT
#include "leonhard/app/points/points_dimension.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/app/points/read_any_points.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::app {
namespace {

// The fields of a line as parse_point_columns separates them, in small letters, without quotation marks.
std::vector<std::string> fields_of(std::string_view line) {
  const char separator = line.find(';') != std::string_view::npos   ? ';'
                         : line.find(',') != std::string_view::npos ? ','
                                                                    : ' ';
  std::vector<std::string> fields;
  bool in_field = false;
  for (const char c : line) {
    const bool is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (separator == ' ' ? is_blank : c == separator) {
      if (separator != ' ' && !in_field) fields.emplace_back();
      in_field = false;
      continue;
    }
    if (is_blank) continue;
    if (!in_field) fields.emplace_back();
    in_field = true;
    if (c != '"' && c != '\'')
      fields.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return fields;
}

bool is_number(const std::string& field) { return field.find_first_of("0123456789") != std::string::npos; }

int columns_dimension(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = line.substr(0, std::min(line.find('#'), line.size()));
    const auto fields = fields_of(line);
    if (fields.empty()) continue;
    if (is_number(fields.front())) return fields.size() >= 3 ? 3 : 2;
    const auto names = [&](const char* name) {
      return std::find(fields.begin(), fields.end(), name) != fields.end();
    };
    if (names("x") && names("y")) return names("z") ? 3 : 2;
  }
  return 2;
}

}  // namespace

int points_dimension(const std::filesystem::path& path) {
  constexpr std::size_t head_bytes = std::size_t{1} << 16;
  const std::string extension = io::known_extension(path, any_point_extensions(), "points");
  if (extension == ".json" || extension == ".geojson") return 2;
  if (extension == ".node") return io::file_dimension(path);
  return columns_dimension(io::read_file_head(path, head_bytes));
}

}  // namespace leonhard::app
