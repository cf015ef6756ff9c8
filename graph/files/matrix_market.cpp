// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

#include "leonhard/graph/files/listed_graph.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::graph {
namespace {

struct Banner {
  unsigned values_each{};  ///< numbers after an entry's row and column
  bool general = false, array = false;
  bool without_diagonal = false;  ///< of an array: skew-symmetric
};

std::string lower_case(std::string_view word) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// "%%MatrixMarket matrix coordinate FIELD SYMMETRY", in any case. The scanner takes it for a comment.
Banner read_banner(std::string_view text, const std::string& source) {
  io::TextScanner scan(text, source, {});
  scan.need_line("%%MatrixMarket");
  const auto expect = [&](const char* word) {
    const std::string_view found = scan.word(word);
    if (lower_case(found) != lower_case(word)) scan.fail_found(found, word);
  };
  const std::string_view head = scan.word("%%MatrixMarket");
  if (lower_case(head) != "%%matrixmarket" && lower_case(head) != "%matrixmarket")
    scan.fail_found(head, "%%MatrixMarket");
  expect("matrix");
  const std::string_view form = scan.word("coordinate or array");
  const bool array = lower_case(form) == "array";
  if (!array && lower_case(form) != "coordinate") scan.fail_found(form, "coordinate or array");
  const std::string_view field = scan.word("a field"), symmetry = scan.word("a symmetry");
  scan.expect_line_end("the symmetry");
  constexpr std::array<std::string_view, 4> fields{"pattern", "real", "integer", "complex"};
  constexpr std::array<unsigned, 4> values{0, 1, 1, 2};
  constexpr std::array<std::string_view, 4> symmetries{"general", "symmetric", "skew-symmetric", "hermitian"};
  const auto known_field = std::ranges::find(fields, lower_case(field));
  if (known_field == fields.end()) scan.fail_found(field, "pattern, real, integer or complex");
  const auto known_symmetry = std::ranges::find(symmetries, lower_case(symmetry));
  if (known_symmetry == symmetries.end())
    scan.fail_found(symmetry, "general, symmetric, skew-symmetric or hermitian");
  return {values[static_cast<std::size_t>(known_field - fields.begin())],
          known_symmetry == symmetries.begin(), array, lower_case(symmetry) == "skew-symmetric"};
}

std::uint32_t read_index(io::TextScanner& scan, const char* what, std::uint32_t size) {
  const std::int64_t index = scan.integer(what);
  if (index < 1 || index > size)
    scan.fail(std::string("found ") + what + " " + std::to_string(index) + ", the matrix has " +
                  std::to_string(size),
              "rows and columns are numbered from 1");
  return static_cast<std::uint32_t>(index - 1);
}

/// A matrix has at least one entry a row that matters, but rows may be empty: the size is bounded by the file's.
std::uint32_t read_size(io::TextScanner& scan) {
  const std::int64_t rows = scan.integer("the number of rows"),
                     columns = scan.integer("the number of columns");
  if (rows != columns || rows < 0)
    scan.fail("the matrix has " + std::to_string(rows) + " rows and " + std::to_string(columns) + " columns",
              "only a square matrix is one of a graph");
  const auto limit = static_cast<std::int64_t>(
      std::min<std::size_t>(64 * (scan.bytes_left() + 16), std::numeric_limits<std::uint32_t>::max() - 1));
  if (rows > limit)
    scan.fail("the matrix has " + std::to_string(rows) + " rows, far more than the file can hold entries",
              "correct the number of rows");
  return static_cast<std::uint32_t>(rows);
}

/// An array's entries, column after column; of a symmetric one the lower triangle.
void read_array(io::TextScanner& scan, const Banner& banner, detail::ListedGraph& listed) {
  for (std::uint32_t column = 0; column < listed.vertices; ++column) {
    const std::uint32_t first = banner.general ? 0 : column + (banner.without_diagonal ? 1 : 0);
    for (std::uint32_t row = first; row < listed.vertices; ++row) {
      bool is_zero = true;
      for (unsigned k = 0; k < banner.values_each; ++k) {
        scan.need_word("an entry's value");
        if (scan.number("an entry's value") != 0) is_zero = false;
      }
      if (!is_zero) listed.entries.push_back({row, column, static_cast<std::uint32_t>(scan.line())});
    }
  }
}

}  // namespace

GraphFile parse_matrix_market(std::string_view text, const std::string& source) {
  const Banner banner = read_banner(text, source);
  io::TextScanner scan(text, source, {.comment = '%'});
  scan.need_line("the numbers of rows, columns and entries");
  const std::uint32_t size = read_size(scan);
  const std::size_t entries =
      banner.array ? 0 : scan.count("the number of entries", 4 + 2 * banner.values_each);
  scan.expect_line_end(banner.array ? "the number of columns" : "the number of entries");
  GraphFile file;
  detail::ListedGraph listed{source, size,           {},
                             {},     banner.general, "give the pattern of A + A^T, or say symmetric"};
  listed.entries.reserve(entries);
  if (banner.array) read_array(scan, banner, listed);
  for (std::size_t i = 0; i < entries; ++i) {
    scan.need_line("an entry");
    const std::uint32_t row = read_index(scan, "row", size), column = read_index(scan, "column", size);
    for (unsigned k = 0; k < banner.values_each; ++k) static_cast<void>(scan.number("an entry's value"));
    scan.expect_line_end("an entry");
    listed.entries.push_back({row, column, static_cast<std::uint32_t>(scan.line())});
  }
  if (scan.next_line()) scan.fail("found a line after the last entry", "correct the number of entries");
  detail::assemble(std::move(listed), file);
  if (banner.values_each > 0) file.warnings.push_back(source + ": the values of its entries were left out");
  return file;
}

}  // namespace leonhard::graph
