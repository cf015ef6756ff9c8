// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/file_dimension.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/formats/vtu_grid.hpp"
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

bool is_flat(const std::vector<Point3>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Point3& p) { return p.z == points[0].z; });
}

int vtu_dimension(const std::string& bytes, const std::string& source) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  const VtuGrid grid(root, source);
  constexpr std::int64_t first_in_space = vtk_tetrahedron, last_in_space = 14;  // pyramid
  const std::vector<std::int64_t> types = grid.read_cell_types();
  const bool has_volume = std::any_of(types.begin(), types.end(), [&](std::int64_t type) {
    return type >= first_in_space && type <= last_in_space;
  });
  return has_volume || !is_flat(grid.read_points()) ? 3 : 2;
}

int msh_dimension(const std::filesystem::path& path) {
  const std::string head = read_file_head(path, head_bytes), source = path.string();
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || head[first] != '$')
    return keyword_value(head, source, "NDIMS", {.comment = '#', .extra_blank = ';'});
  const GmshData data = parse_gmsh_data(read_whole_file(path), source, GmshKinds::all);
  const auto is_empty = [](const std::vector<GmshCell>* cells) { return cells->empty(); };
  const std::array solids{&data.tetrahedra, &data.hexahedra, &data.prisms, &data.pyramids};
  return !std::all_of(solids.begin(), solids.end(), is_empty) || !is_flat(data.points) ? 3 : 2;
}

/// NDIME= may stand anywhere, but mostly comes first.
int su2_dimension(const std::filesystem::path& path) {
  const std::string head = read_file_head(path, head_bytes);
  const bool is_in_head = head.find("NDIME") < head.rfind('\n');
  return keyword_value(is_in_head ? head : read_whole_file(path), path.string(), "NDIME", {.comment = '%'});
}

}  // namespace

int file_dimension(const std::filesystem::path& path) {
  static const std::vector<std::string> known{".su2",  ".vtu",   ".msh",  ".mesh",  ".node", ".ele",
                                              ".poly", ".neigh", ".face", ".smesh", ".edge", ".p2dfmt"};
  const std::string extension = known_extension(path, known, "mesh"), source = path.string();
  if (extension == ".vtu") return vtu_dimension(read_whole_file(path), source);
  if (extension == ".msh") return msh_dimension(path);
  if (extension == ".su2") return su2_dimension(path);
  const std::string head = read_file_head(path, head_bytes);
  if (extension == ".mesh") return keyword_value(head, source, "DIMENSION", {.comment = '#'});
  if (extension == ".face" || extension == ".smesh") return 3;
  if (extension == ".edge" || extension == ".p2dfmt") return 2;
  return second_number(head, source, extension == ".ele" || extension == ".neigh");
}

}  // namespace leonhard::io
