// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/file_dimension.hpp"

#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/gmsh_soup.hpp"
#include "leonhard/mesh/io/formats/medit_data.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

constexpr std::size_t head_bytes = std::size_t{1} << 16;

int checked(TextScanner& scan, std::int64_t dimension) {
  if (dimension != 2 && dimension != 3)
    scan.fail("the dimension is " + std::to_string(dimension), "2 and 3 can be read");
  return static_cast<int>(dimension);
}

/// The second number of the first line: the dimension itself in .node and .poly, the nodes of a cell in .ele, its sides
/// in .neigh.
int second_number(std::string_view text, const std::string& source, bool is_cell) {
  TextScanner scan(text, source, {.comment = '#'});
  scan.need_line("the number of entries");
  scan.integer("the number of entries");
  if (!is_cell) return checked(scan, scan.integer("the dimension"));
  const std::int64_t nodes = scan.integer("the number of nodes per cell");
  return nodes == 4 || nodes == 10 ? 3 : nodes == 3 || nodes == 6 ? 2 : checked(scan, nodes);
}

/// The first line that gives a keyword its value, after an equals sign or not, or on the next line.
int keyword_value(std::string_view text, const std::string& source, const std::string& keyword,
                  TextSyntax syntax) {
  TextScanner scan(text, source, syntax);
  while (scan.next_line()) {
    std::string head(scan.rest().substr(0, keyword.size()));
    for (char& c : head) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (head != keyword) continue;
    if (scan.at_key()) {
      scan.key("a keyword");
    } else {
      scan.word("a keyword");
    }
    scan.need_word("the dimension");
    return checked(scan, scan.integer("the dimension"));
  }
  scan.fail("the file does not tell its dimension (" + keyword + ")", "was it written completely?");
}

int msh_dimension(const std::filesystem::path& path) {
  const std::string head = read_file_head(path, head_bytes), source = path.string();
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || head[first] != '$')
    return keyword_value(head, source, "NDIMS", {.comment = '#', .extra_blank = ';'});
  return dimension_of(parse_gmsh_data(read_whole_file(path), source));
}

}  // namespace

int file_dimension(const std::filesystem::path& path) {
  static const std::vector<std::string> known{".su2",  ".vtu",    ".msh",   ".mesh", ".node",
                                              ".ele",  ".poly",   ".neigh", ".face", ".smesh",
                                              ".edge", ".p2dfmt", ".pvtu",  ".vtk"};
  const std::string extension = known_extension(path, known, "mesh"), source = path.string();
  if (extension == ".vtu") return dimension_of(parse_vtu_grid(read_whole_file(path), source));
  if (extension == ".vtk") return dimension_of(parse_legacy_vtk(read_whole_file(path), source));
  if (extension == ".pvtu")
    return dimension_of(read_pvtu_grid(read_whole_file(path), source, path.parent_path()));
  if (extension == ".msh") return msh_dimension(path);
  if (extension == ".su2") {
    const std::string text = read_whole_file(path);
    return su2_dimension(find_su2_zone(text, source, std::nullopt), source);
  }
  if (extension == ".p2dfmt") return 2;
  const std::string head = read_file_head(path, head_bytes);
  if (extension == ".mesh") {
    if (keyword_value(head, source, "DIMENSION", {.comment = '#'}) == 2) return 2;
    return dimension_of(parse_medit_data(read_whole_file(path), source));
  }
  if (extension == ".face" || extension == ".smesh") return 3;
  if (extension == ".edge" || extension == ".p2dfmt") return 2;
  return second_number(head, source, extension == ".ele" || extension == ".neigh");
}

}  // namespace leonhard::io
