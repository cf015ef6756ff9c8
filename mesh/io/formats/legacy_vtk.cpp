// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/text/byte_reader.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {
namespace {

/// The words and numbers of a legacy file: text throughout, or lines of text between big-endian numbers.
class LegacyReader {
 public:
  LegacyReader(std::string_view bytes, std::string source) : reader_(bytes, std::move(source), 0, false) {
    reader_.set_swapped(std::endian::native == std::endian::little);
  }

  void set_binary(bool binary) { is_binary_ = binary; }
  [[nodiscard]] bool at_end() const { return reader_.bytes_left() == 0; }
  std::string_view line() { return reader_.line("a line"); }

  /// Whether the next line that is not empty begins with a word, in capitals or not.
  [[nodiscard]] bool next_words_begin_with(std::string_view word) const {
    const std::string_view rest = reader_.rest_from(reader_.offset());
    const std::size_t begin = std::min(rest.find_first_not_of(" \t\r\n"), rest.size());
    return std::equal(word.begin(), word.end(), rest.begin() + static_cast<std::ptrdiff_t>(begin),
                      rest.begin() + static_cast<std::ptrdiff_t>(std::min(begin + word.size(), rest.size())),
                      [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); });
  }

  /// The words of the next line that has some; none at the end of the file.
  std::vector<std::string> words() {
    std::vector<std::string> list;
    while (list.empty() && !at_end()) {
      const std::string_view text = line();
      std::string word;
      for (const char c : text) {
        if (std::isspace(static_cast<unsigned char>(c)) == 0) {
          word += c;
        } else if (!word.empty()) {
          list.push_back(std::exchange(word, {}));
        }
      }
      if (!word.empty()) list.push_back(std::move(word));
    }
    return list;
  }

  /// The next word of a text, wherever it stands.
  std::string_view word(const char* expected) {
    char c = reader_.take<char>(expected);
    while (std::isspace(static_cast<unsigned char>(c)) != 0) c = reader_.take<char>(expected);
    const std::string_view rest = reader_.rest_from(reader_.offset() - 1);
    std::size_t length = 1;
    while (length < rest.size() && std::isspace(static_cast<unsigned char>(rest[length])) == 0) ++length;
    reader_.skip(length - 1);
    return rest.substr(0, length);
  }

  double real(const std::string& type, const char* expected) {
    if (!is_binary_) {
      double value = 0;
      const std::string_view found = word(expected);
      const NumberFault fault = parse_number(found, value);
      if (fault != NumberFault::none && fault != NumberFault::not_finite)
        fail("found " + in_quotes(found) + " where " + expected + " was expected");
      return value;
    }
    if (type == "double") return reader_.take<double>(expected);
    if (type == "float") return static_cast<double>(reader_.take<float>(expected));
    return static_cast<double>(binary_integer(type, expected));
  }

  std::int64_t integer(const std::string& type, const char* expected) {
    if (is_binary_) return binary_integer(type, expected);
    const double value = real(type, expected);
    if (value != std::floor(value) || std::abs(value) > 0x1p53)
      fail(std::string("found a number that is not whole where ") + expected + " was expected");
    return static_cast<std::int64_t>(value);
  }

  /// Whether the file can hold so many numbers; a digit and a blank each in text.
  void need(std::uint64_t count, const std::string& type, const char* expected) {
    reader_.need(count, is_binary_ ? size_of(type) : 1, expected);
  }

  std::size_t count(const std::string& text, const char* expected) {
    double value = 0;
    if (parse_number(text, value) != NumberFault::none || value < 0 || value != std::floor(value) ||
        value >= static_cast<double>(std::numeric_limits<IdRaw>::max()))
      fail("found " + in_quotes(text) + " where " + expected + " was expected");
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = {}) const {
    reader_.fail(problem, remedy);
  }

 private:
  std::size_t size_of(const std::string& type) const {
    if (type == "double" || type == "long" || type == "unsigned_long" || type == "vtktypeint64") return 8;
    if (type == "float" || type == "int" || type == "unsigned_int" || type == "vtkidtype") return 4;
    if (type == "short" || type == "unsigned_short") return 2;
    if (type == "char" || type == "unsigned_char") return 1;
    fail("the type " + in_quotes(type) + " is not known", "VTK's are float, double, int, long and the like");
  }

  std::int64_t binary_integer(const std::string& type, const char* expected) {
    switch (size_of(type)) {
      case 8:
        return reader_.take<std::int64_t>(expected);
      case 4:
        return type == "unsigned_int" ? std::int64_t{reader_.take<std::uint32_t>(expected)}
                                      : std::int64_t{reader_.take<std::int32_t>(expected)};
      case 2:
        return type == "unsigned_short" ? std::int64_t{reader_.take<std::uint16_t>(expected)}
                                        : std::int64_t{reader_.take<std::int16_t>(expected)};
      default:
        return type == "unsigned_char" ? std::int64_t{reader_.take<std::uint8_t>(expected)}
                                       : std::int64_t{reader_.take<std::int8_t>(expected)};
    }
  }

  ByteReader reader_;
  bool is_binary_ = false;
};

std::string in_capitals(std::string word) {
  for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return word;
}
std::string in_small_letters(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

class LegacyParser {
 public:
  LegacyParser(std::string_view bytes, const std::string& source) : in_(bytes, source) {}

  VtkGrid parse() {
    read_head();
    for (words_ = in_.words(); !words_.empty(); words_ = in_.words()) read_section(in_capitals(words_[0]));
    finish();
    return std::move(grid_);
  }

 private:
  void read_head() {
    if (in_.at_end() || !in_.line().starts_with("# vtk DataFile Version"))
      in_.fail("the file does not begin with \"# vtk DataFile Version\"", "give a legacy .vtk file");
    if (!in_.at_end()) in_.line();  // the title
    const auto kind = in_.words();
    const std::string form = kind.empty() ? "" : in_capitals(kind[0]);
    if (form != "ASCII" && form != "BINARY")
      in_.fail("found " + in_quotes(form) + " where ASCII or BINARY was expected");
    in_.set_binary(form == "BINARY");
    words_ = in_.words();
    if (words_.size() < 2 || in_capitals(words_[0]) != "DATASET")
      in_.fail("the line DATASET is missing", "the file was cut short");
    const std::string dataset = in_capitals(words_[1]);
    if (dataset != "UNSTRUCTURED_GRID" && dataset != "POLYDATA")
      in_.fail("the file holds a " + dataset, "unstructured grids and poly data can be read");
  }

  [[nodiscard]] const std::string& argument(std::size_t i) const {
    if (i >= words_.size()) in_.fail("the line " + in_quotes(words_[0]) + " is too short", "it was damaged");
    return words_[i];
  }

  void read_section(const std::string& keyword) {
    if (keyword == "POINTS") return read_points();
    if (keyword == "CELLS") return read_cells(0);
    if (keyword == "CELL_TYPES") return read_types();
    if (keyword == "VERTICES") return read_cells(vtk_poly_vertex);
    if (keyword == "LINES") return read_cells(vtk_poly_line);
    if (keyword == "POLYGONS") return read_cells(vtk_polygon);
    if (keyword == "TRIANGLE_STRIPS") return read_cells(vtk_triangle_strip);
    if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
      arrays_ = keyword == "POINT_DATA" ? &grid_.point_arrays : &grid_.cell_arrays;
      rows_ = in_.count(argument(1), "the number of rows");
      return;
    }
    if (keyword == "SCALARS") return read_scalars();
    if (keyword == "VECTORS" || keyword == "NORMALS") return read_rows(argument(1), 3, argument(2), rows_);
    if (keyword == "TENSORS") return read_rows(argument(1), 9, argument(2), rows_);
    if (keyword == "TEXTURE_COORDINATES")
      return read_rows(argument(1), in_.count(argument(2), "the number of components"), argument(3), rows_);
    if (keyword == "FIELD") return read_field();
    if (keyword == "METADATA") return skip_metadata();
    if (keyword == "LOOKUP_TABLE")
      return skip_numbers(4 * in_.count(argument(2), "the size of a table"), "float");
    in_.fail("the keyword " + in_quotes(words_[0]) + " is not known",
             "the file was damaged, or a count is wrong");
  }

  void read_points() {
    const std::size_t count = in_.count(argument(1), "the number of points");
    const std::string type = in_small_letters(argument(2));
    in_.need(3 * std::uint64_t{count}, type, "coordinates");
    for (std::size_t i = 0; i < count; ++i) {
      const double x = in_.real(type, "a coordinate"), y = in_.real(type, "a coordinate");
      grid_.points.push_back({x, y, in_.real(type, "a coordinate")});
    }
  }

  /// Versions before 5: the number of vertices before each cell; since then OFFSETS and CONNECTIVITY.
  void read_cells(std::int64_t type) {
    const std::size_t count = in_.count(argument(1), "the number of cells"),
                      size = in_.count(argument(2), "the size of the list");
    const std::size_t before = grid_.offsets.size();
    if (type == 0 && before > 0) in_.fail("the section CELLS comes a second time");
    const auto first = std::ssize(grid_.connectivity);
    if (in_.next_words_begin_with("OFFSETS")) {
      read_offsets(count, size, first);
    } else {
      in_.need(size, "int", "entries of cells");
      for (std::size_t c = 0; c < count; ++c) {
        const std::int64_t vertices = in_.integer("int", "the number of vertices of a cell");
        if (vertices < 0 || static_cast<std::uint64_t>(vertices) > size)
          in_.fail("a cell has " + std::to_string(vertices) + " vertices");
        for (std::int64_t i = 0; i < vertices; ++i)
          grid_.connectivity.push_back(in_.integer("int", "a vertex of a cell"));
        grid_.offsets.push_back(std::ssize(grid_.connectivity));
      }
    }
    if (type != 0) grid_.types.resize(grid_.offsets.size(), type);
  }

  void read_offsets(std::size_t count, std::size_t size, std::ptrdiff_t first) {
    words_ = in_.words();
    const std::string type = in_small_letters(argument(1));
    in_.need(count, type, "offsets");
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t end = in_.integer(type, "an offset");
      if (i > 0) grid_.offsets.push_back(first + end);
    }
    words_ = in_.words();
    if (words_.size() < 2 || in_capitals(words_[0]) != "CONNECTIVITY")
      in_.fail("the line CONNECTIVITY is missing", "the file was cut short");
    const std::string of_links = in_small_letters(words_[1]);
    in_.need(size, of_links, "entries of cells");
    for (std::size_t i = 0; i < size; ++i)
      grid_.connectivity.push_back(in_.integer(of_links, "a vertex of a cell"));
  }

  void read_types() {
    const std::size_t count = in_.count(argument(1), "the number of cells");
    in_.need(count, "int", "types of cells");
    grid_.types.clear();
    for (std::size_t c = 0; c < count; ++c) grid_.types.push_back(in_.integer("int", "the type of a cell"));
  }

  // ---- arrays ----

  void read_scalars() {
    const std::string name = argument(1), type = argument(2);
    const std::size_t components = words_.size() > 3 ? in_.count(words_[3], "the number of components") : 1;
    if (in_.next_words_begin_with("LOOKUP_TABLE")) in_.words();
    read_rows(name, components, type, rows_);
  }

  void read_rows(std::string name, std::size_t components, std::string type, std::size_t rows) {
    constexpr std::size_t most = 1000;
    type = in_small_letters(std::move(type));
    if (components == 0 || components > most)
      in_.fail("the field " + in_quotes(name) + " has " + std::to_string(components) + " components",
               "1 to " + std::to_string(most) + " can be read");
    VtkNumbers numbers{std::move(name), components, type != "float" && type != "double", {}, 0};
    in_.need(std::uint64_t{rows} * components, type, "numbers of a field");
    numbers.values.reserve(rows * components);
    for (std::size_t i = 0; i < rows * components; ++i)
      numbers.values.push_back(in_.real(type, "a number of a field"));
    if (arrays_ == nullptr) return;
    if (rows != rows_)
      in_.fail("the field " + in_quotes(numbers.name) + " has " + std::to_string(rows) + " rows, not " +
               std::to_string(rows_));
    const bool is_new = std::none_of(arrays_->begin(), arrays_->end(),
                                     [&](const VtkNumbers& array) { return array.name == numbers.name; });
    if (is_new) {
      arrays_->push_back(std::move(numbers));
    } else {
      grid_.warnings.push_back("the field " + in_quotes(numbers.name) +
                               " was left out: another one has this name");
    }
  }

  /// FIELD name count, then arrays: name components rows type, and the numbers.
  void read_field() {
    const std::size_t count = in_.count(argument(2), "the number of arrays");
    for (std::size_t i = 0; i < count; ++i) {
      words_ = in_.words();
      if (!words_.empty() && in_capitals(words_[0]) == "METADATA") {
        skip_metadata();
        words_ = in_.words();
      }
      if (words_.size() < 4) in_.fail("an array of a field is missing", "the file was cut short");
      if (in_small_letters(words_[3]) == "string") in_.fail("a field holds text", "only numbers can be read");
      read_rows(words_[0], in_.count(words_[1], "the number of components"), words_[3],
                in_.count(words_[2], "the number of rows"));
    }
  }

  /// Up to an empty line.
  void skip_metadata() {
    while (!in_.at_end())
      if (in_.line().find_first_not_of(" \t\r") == std::string_view::npos) return;
  }

  void skip_numbers(std::size_t count, const char* type) {
    in_.need(count, type, "numbers");
    for (std::size_t i = 0; i < count; ++i) in_.real(type, "a number");
  }

  // ---- the end ----

  void finish() {
    if (grid_.types.size() != grid_.offsets.size())
      in_.fail("the file has " + std::to_string(grid_.offsets.size()) + " cells, but types of " +
                   std::to_string(grid_.types.size()),
               "it was cut short");
    std::int64_t begin = 0;
    for (const std::int64_t end : grid_.offsets) {
      if (end < begin || end > std::ssize(grid_.connectivity))
        in_.fail("a cell ends at entry " + std::to_string(end) + " of " +
                 std::to_string(grid_.connectivity.size()) + ", and begins at " + std::to_string(begin));
      begin = end;
    }
    for (const std::int64_t v : grid_.connectivity)
      if (v < 0 || v >= std::ssize(grid_.points))
        in_.fail("vertex " + std::to_string(v) + " does not exist, the file has vertices 0 to " +
                 std::to_string(std::ssize(grid_.points) - 1));
    check_rows(grid_.point_arrays, grid_.points.size(), "points");
    check_rows(grid_.cell_arrays, grid_.types.size(), "cells");
  }

  void check_rows(const std::vector<VtkNumbers>& arrays, std::size_t rows, const char* of) const {
    for (const VtkNumbers& array : arrays)
      if (array.values.size() != rows * array.components)
        in_.fail("the field " + in_quotes(array.name) + " does not fit " + std::to_string(rows) + " " + of);
  }

  LegacyReader in_;
  std::vector<std::string> words_;  ///< of the line that began the section
  VtkGrid grid_;
  std::vector<VtkNumbers>* arrays_ = nullptr;  ///< which section of data is being read
  std::size_t rows_ = 0;
};

}  // namespace

VtkGrid parse_legacy_vtk(std::string_view bytes, const std::string& source) {
  return LegacyParser(bytes, source).parse();
}

}  // namespace leonhard::io
