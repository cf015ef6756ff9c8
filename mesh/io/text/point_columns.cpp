// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/text/point_columns.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <optional>

#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {
namespace {

constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view word) {
  while (!word.empty() && is_blank(word.front())) word.remove_prefix(1);
  while (!word.empty() && is_blank(word.back())) word.remove_suffix(1);
  return word;
}

std::string_view without_quotes(std::string_view word) {
  const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
  return quoted ? word.substr(1, word.size() - 2) : word;
}

/// Where the field that begins at `from` ends: at a separator outside quotation marks.
std::size_t field_end(std::string_view line, std::size_t from, bool (*separates)(char)) {
  bool quoted = false;
  for (std::size_t i = from; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (!quoted && separates(line[i])) return i;
  }
  return line.size();
}

/// The fields of a line that is not empty; reuses the vector.
void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  bool (*separates)(char) = is_blank;
  if (line.find(',') != std::string_view::npos) separates = [](char c) { return c == ','; };
  if (line.find(';') != std::string_view::npos) separates = [](char c) { return c == ';'; };
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t end = field_end(line, from, separates);
    const std::string_view field = trimmed(line.substr(from, end - from));
    if (separates != is_blank || !field.empty()) fields.push_back(without_quotes(field));
    from = end + 1;
  }
}

bool equal_in_any_case(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(a))) == b;
  });
}

class ColumnReader {
 public:
  ColumnReader(std::string_view text, const std::string& source, std::size_t dimension, bool further)
      : scan_(text, source, {.comment = '#'}), dimension_(dimension), further_(further) {
    for (std::size_t i = 0; i < dimension; ++i) column_[i] = i;
  }

  PointColumns read() {
    bool more = scan_.next_line();
    if (more && is_header()) {
      read_header();
      more = scan_.next_line();
    }
    for (; more; more = scan_.next_line()) read_point();
    if (result_.coordinates.empty())
      scan_.fail("no point was found", "give one point a line, its coordinates in columns");
    return std::move(result_);
  }

 private:
  /// A first line of words is a header; NaN is a word that is no name. A field that begins as a number does makes it a
  /// row, if perhaps a damaged one.
  bool is_header() {
    split(scan_.rest(), fields_);
    double ignored = 0;
    return parse_number(fields_.front(), ignored) == NumberFault::not_a_number &&
           std::none_of(fields_.begin(), fields_.end(), [](std::string_view field) {
             return !field.empty() &&
                    std::string_view("0123456789+-.").find(field.front()) != std::string_view::npos;
           });
  }

  void read_header() {
    std::array<std::size_t, 3> found{};
    for (std::size_t i = 0; i < dimension_; ++i) {
      const auto at = std::find_if(fields_.begin(), fields_.end(), [&](std::string_view name) {
        return equal_in_any_case(name, axis_names[i]);
      });
      if (at == fields_.end()) return;
      found[i] = static_cast<std::size_t>(at - fields_.begin());
    }
    column_ = found;
    set_columns();
  }

  /// Every line has as many columns as this one.
  void set_columns() {
    columns_ = fields_.size();
    if (*columns_ > dimension_)
      result_.warnings.push_back(scan_.where() + ": " + std::to_string(*columns_ - dimension_) +
                                 " columns beside the coordinates were left out");
  }

  void read_point() {
    split(scan_.rest(), fields_);
    const bool is_first = result_.coordinates.empty();
    if (further_ && is_first && !columns_ && fields_.size() > dimension_) {
      set_columns();
      told_by_ = "the first line";
    }
    check_column_count();
    for (std::size_t i = 0; i < dimension_; ++i) result_.coordinates.push_back(number(fields_[column_[i]]));
  }

  void check_column_count() const {
    const std::size_t expected = columns_.value_or(dimension_);
    if (fields_.size() == expected) return;
    std::string problem = "the line has " + std::to_string(fields_.size()) + " columns, ";
    problem += columns_ ? told_by_ + " " + std::to_string(expected)
                        : "a point of " + std::string(dimension_ == 2 ? "the plane" : "space") + " has " +
                              std::to_string(expected);
    const bool extra = fields_.size() > expected;
    scan_.fail(problem, columns_ ? "complete the line"
                        : extra
                            ? "leave out the others, or name the columns, x and y among them, in a first line"
                            : "separate the columns by blanks, commas or semicolons");
  }

  [[nodiscard]] double number(std::string_view field) const {
    double value = 0;
    switch (parse_number(field, value)) {
      case NumberFault::none:
        return value;
      case NumberFault::not_a_number:
        scan_.fail(
            "found " + in_quotes(field) + " where a coordinate was expected",
            field.find(',') != std::string_view::npos ? "write decimals with a point" : "write a number");
      case NumberFault::not_finite:
        scan_.fail(in_quotes(field) + " is not finite, where a coordinate was expected",
                   "NaN and infinities are bad input; find out what wrote them");
      case NumberFault::too_large:
        scan_.fail(in_quotes(field) + " is beyond the range of double, where a coordinate was expected");
    }
    return value;
  }

  TextScanner scan_;
  std::size_t dimension_;
  bool further_;
  std::array<std::size_t, 3> column_{};  ///< of each coordinate
  std::optional<std::size_t> columns_;   ///< of every line, where a header or the first line told
  std::string told_by_ = "the header";
  std::vector<std::string_view> fields_;
  PointColumns result_;
};

}  // namespace

PointColumns parse_point_columns(std::string_view text, const std::string& source, std::size_t dimension,
                                 bool further) {
  assert(dimension == 2 || dimension == 3);
  return ColumnReader(text, source, dimension, further).read();
}

}  // namespace leonhard::io
