// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/cell_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/io/vtk_array.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "leonhard/mesh/io/vtu_names.hpp"
#include "leonhard/mesh/io/xml.hpp"

namespace leonhard::io {

namespace {

// VTK's cell types.
constexpr std::int64_t vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5, vtk_quadrilateral = 9;

/// Names under which other programs keep the number of the physical curve that a line cell belongs to.
constexpr const char* line_marker_names[] = {"marker", "gmsh:physical", "medit:ref", "CellEntityIds"};

class VtuReader {
 public:
  VtuReader(const XmlElement& root, const std::string& source) : root_(root), source_(source) {
    soup_.source = source;
  }

  MeshFile read() {
    const XmlElement& piece = open_piece();
    read_points(piece);
    read_cells(piece);
    const bool knows_boundary = read_field_data(need(root_, "UnstructuredGrid").child("FieldData"));
    MeshFile result = assemble(
        std::move(soup_), knows_boundary ? EdgeRule::edges_are_the_boundary : EdgeRule::fill_in_the_boundary);
    const auto has_marker_1 = [](const MarkedEdge& edge) { return edge.marker == 1; };
    if (!knows_boundary &&
        std::any_of(result.mesh.boundary.begin(), result.mesh.boundary.end(), has_marker_1))
      result.mesh.marker_names.try_emplace(1, "boundary");
    return result;
  }

  PointField read_field(const std::string& name) {
    const XmlElement& piece = open_piece();
    const XmlElement* data = piece.child("PointData");
    const XmlElement* array = find_array(data, name);
    if (array == nullptr)
      fail(data != nullptr ? *data : piece, "there is no point field " + in_quotes(name), field_names(data));
    PointField field{name, 1, {}};
    const std::string components = array->attribute("NumberOfComponents", "1");
    if (components != "1" && components != "2" && components != "3")
      fail(*array, "the field " + in_quotes(name) + " has " + components + " components",
           "1 to 3 can be read");
    field.components = static_cast<std::size_t>(components[0] - '0');
    field.values = read_doubles(*array, encoding_, field.components * point_count_);
    for (std::size_t i = 0; i < field.values.size(); ++i)
      if (!std::isfinite(field.values[i]))
        fail(*array, "the field " + in_quotes(name) + " is not finite at vertex " +
                         std::to_string(i / field.components));
    return field;
  }

 private:
  /// Check what the file is and find its one piece.
  const XmlElement& open_piece() {
    if (root_.name != "VTKFile" || root_.attribute("type") != "UnstructuredGrid")
      fail(root_, "this is no unstructured grid of VTK (<VTKFile type=\"UnstructuredGrid\">)",
           "give a .vtu file");
    encoding_ = vtk_encoding(root_, source_);
    const XmlElement& grid = need(root_, "UnstructuredGrid");
    if (std::count_if(grid.children.begin(), grid.children.end(),
                      [](const XmlElement& child) { return child.name == "Piece"; }) > 1)
      fail(grid, "the grid comes in several pieces", "merge them into one (ParaView: Merge Blocks)");
    const XmlElement& piece = need(grid, "Piece");
    point_count_ = read_count(piece, "NumberOfPoints");
    cell_count_ = read_count(piece, "NumberOfCells");
    return piece;
  }

  [[noreturn]] void fail(const XmlElement& element, std::string problem, std::string remedy = {}) const {
    throw InputError(at_line(source_, element.line), std::move(problem), std::move(remedy));
  }

  const XmlElement& need(const XmlElement& parent, std::string_view name) const {
    const XmlElement* child = parent.child(name);
    if (child == nullptr)
      fail(parent, "the element <" + std::string(parent.name) + "> has no <" + std::string(name) + ">",
           "the file was cut short, or is no grid of VTK");
    return *child;
  }

  /// "it has density, mach", for the message about a field that is not there.
  static std::string field_names(const XmlElement* data) {
    std::string names;
    if (data != nullptr)
      for (const XmlElement& child : data->children)
        if (child.name == "DataArray") names += (names.empty() ? "it has " : ", ") + child.attribute("Name");
    return names;
  }

  static const XmlElement* find_array(const XmlElement* data, std::string_view name) {
    if (data == nullptr) return nullptr;
    const auto found =
        std::find_if(data->children.begin(), data->children.end(), [&](const XmlElement& child) {
          return child.name == "DataArray" && child.attribute("Name") == name;
        });
    return found == data->children.end() ? nullptr : &*found;
  }

  const XmlElement& need_array(const XmlElement& data, std::string_view name) const {
    const XmlElement* array = find_array(&data, name);
    if (array == nullptr)
      fail(data, "the element <" + std::string(data.name) + "> has no array " + in_quotes(name));
    return *array;
  }

  std::size_t read_count(const XmlElement& element, const char* attribute) const {
    const std::string text = element.attribute(attribute);
    TextScanner scan(text, source_, {.lines_before = element.line - 1});
    scan.need_line(attribute);
    const std::int64_t count = scan.integer(attribute);
    // Whether the file can hold so many is known to the arrays; this keeps later sums from overflowing.
    if (count < 0 || count >= std::int64_t{std::numeric_limits<IdRaw>::max() / 4})
      fail(element, std::string(attribute) + " is " + std::to_string(count) + ", which no mesh can have");
    return static_cast<std::size_t>(count);
  }

  /// A whole number from a file as a vertex id; assemble checks its range.
  VertexId vertex(const XmlElement& array, std::int64_t id) const {
    if (id < 0 || static_cast<std::uint64_t>(id) >= point_count_)
      fail(array, "vertex " + std::to_string(id) + " does not exist, the file has vertices 0 to " +
                      std::to_string(static_cast<std::int64_t>(point_count_) - 1));
    return VertexId::from(static_cast<std::size_t>(id));
  }

  Marker marker(const XmlElement& array, std::int64_t value) const {
    if (value < std::numeric_limits<Marker>::min() || value > std::numeric_limits<Marker>::max())
      fail(array, "the marker " + std::to_string(value) + " does not fit 32 bits");
    return static_cast<Marker>(value);
  }

  /// An array of whole numbers with one number a row, or none if it is missing or of another shape.
  std::optional<std::vector<std::int64_t>> find_numbers(const XmlElement* data, std::string_view name,
                                                        std::size_t count) const {
    const XmlElement* array = find_array(data, name);
    if (array == nullptr || array->attribute("NumberOfComponents", "1") != "1") return std::nullopt;
    if (array->attribute("type").starts_with("Float")) return std::nullopt;
    return read_integers(*array, encoding_, count);
  }

  void read_points(const XmlElement& piece) {
    const XmlElement& points = need(piece, "Points");
    const XmlElement& array = need(points, "DataArray");
    if (array.attribute("NumberOfComponents") != "3") fail(array, "points have other than 3 components");
    const std::vector<double> coordinates = read_doubles(array, encoding_, 3 * point_count_);
    soup_.points.reserve(point_count_);
    for (std::size_t i = 0; i < coordinates.size(); i += 3) {
      if (coordinates[i + 2] != coordinates[2])
        fail(array,
             "point " + std::to_string(i / 3) + " has z = " + std::to_string(coordinates[i + 2]) +
                 " unlike the first, which has z = " + std::to_string(coordinates[2]),
             "only meshes in a plane z = const can be read");
      soup_.points.push_back({coordinates[i], coordinates[i + 1]});
    }
    const XmlElement* data = piece.child("PointData");
    if (const auto markers = find_numbers(data, vtu_names::vertex_marker, point_count_))
      for (const std::int64_t value : *markers)
        soup_.vertex_markers.push_back(marker(*find_array(data, vtu_names::vertex_marker), value));
  }

  void read_cells(const XmlElement& piece) {
    const XmlElement& cells = need(piece, "Cells");
    const XmlElement& array = need_array(cells, "connectivity");
    const auto offsets = read_integers(need_array(cells, "offsets"), encoding_, cell_count_);
    const auto types = read_integers(need_array(cells, "types"), encoding_, cell_count_);
    const auto connectivity = read_integers(array, encoding_, std::nullopt);
    const std::vector<Marker> line_markers = read_line_markers(piece.child("CellData"));
    const std::vector<double> regions = read_regions(piece.child("CellData"));
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < cell_count_; ++c) {
      const std::int64_t end = offsets[c];
      if (end < begin || end > std::ssize(connectivity))
        fail(array, "cell " + std::to_string(c) + " ends at entry " + std::to_string(end) + " of " +
                        std::to_string(connectivity.size()) + ", and begins at " + std::to_string(begin));
      const std::span<const std::int64_t> corners(connectivity.data() + begin,
                                                  static_cast<std::size_t>(end - begin));
      if (add_cell(array, c, types[c], corners, line_markers.empty() ? 1 : line_markers[c]) &&
          !regions.empty())
        soup_.cell_regions.push_back(regions[c]);
      begin = end;
    }
  }

  /// returns whether the cell is a triangle or a quadrilateral
  bool add_cell(const XmlElement& array, std::size_t c, std::int64_t type,
                std::span<const std::int64_t> corners, Marker line_marker) {
    const std::size_t expected = type == vtk_vertex          ? 1
                                 : type == vtk_line          ? 2
                                 : type == vtk_triangle      ? 3
                                 : type == vtk_quadrilateral ? 4
                                                             : 0;
    if (expected == 0)
      fail(array, "cell " + std::to_string(c) + " has the type " + std::to_string(type),
           "only triangles (5), quadrilaterals (9), and lines (3) on the boundary can be read");
    if (corners.size() != expected)
      fail(array, "cell " + std::to_string(c) + " of type " + std::to_string(type) + " has " +
                      std::to_string(corners.size()) + " vertices");
    if (type == vtk_vertex) return false;
    if (type == vtk_line) {
      soup_.edges.push_back({vertex(array, corners[0]), vertex(array, corners[1]), line_marker});
      return false;
    }
    Cell cell;
    cell.corner_count = static_cast<std::uint32_t>(expected);
    for (std::size_t i = 0; i < expected; ++i) cell.corners[i] = vertex(array, corners[i]);
    soup_.cells.push_back(cell);
    return true;
  }

  std::vector<Marker> read_line_markers(const XmlElement* cell_data) const {
    for (const char* name : line_marker_names) {
      const auto numbers = find_numbers(cell_data, name, cell_count_);
      if (!numbers) continue;
      std::vector<Marker> markers;
      for (const std::int64_t value : *numbers)
        markers.push_back(marker(*find_array(cell_data, name), value));
      return markers;
    }
    return {};
  }

  std::vector<double> read_regions(const XmlElement* cell_data) const {
    const XmlElement* array = find_array(cell_data, vtu_names::region);
    if (array == nullptr || array->attribute("NumberOfComponents", "1") != "1") return {};
    return read_doubles(*array, encoding_, cell_count_);
  }

  std::vector<MarkedEdge> read_edges(const XmlElement& array) const {
    const auto rows = read_integers(array, encoding_, std::nullopt);
    if (rows.size() % 3 != 0) fail(array, "the edges do not come in rows of three numbers");
    std::vector<MarkedEdge> edges;
    for (std::size_t i = 0; i < rows.size(); i += 3)
      edges.push_back({vertex(array, rows[i]), vertex(array, rows[i + 1]), marker(array, rows[i + 2])});
    return edges;
  }

  void read_marker_names(const XmlElement& names_array, const XmlElement& numbers_array) {
    const auto numbers = read_integers(numbers_array, encoding_, std::nullopt);
    std::vector<std::string> names(1);
    for (const std::int64_t byte : read_integers(names_array, encoding_, std::nullopt)) {
      if (byte == 0) {
        names.emplace_back();
      } else {
        names.back() += static_cast<char>(byte);
      }
    }
    if (names.size() != numbers.size() + 1)
      fail(names_array, "the numbers of markers and of their names differ");
    for (std::size_t i = 0; i < numbers.size(); ++i)
      soup_.marker_names.insert_or_assign(marker(numbers_array, numbers[i]), names[i]);
  }

  /// returns whether the file says what the boundary is, as those that write_vtu wrote do
  bool read_field_data(const XmlElement* field_data) {
    const XmlElement* numbers = find_array(field_data, vtu_names::marker_numbers);
    const XmlElement* names = find_array(field_data, vtu_names::marker_names);
    if (numbers != nullptr && names != nullptr) read_marker_names(*names, *numbers);
    if (const XmlElement* array = find_array(field_data, vtu_names::constraints))
      soup_.constraints = read_edges(*array);
    const XmlElement* boundary = find_array(field_data, vtu_names::boundary);
    if (boundary != nullptr) soup_.edges = read_edges(*boundary);
    return boundary != nullptr;
  }

  const XmlElement& root_;
  const std::string& source_;
  VtkEncoding encoding_;
  CellSoup soup_;
  std::size_t point_count_ = 0, cell_count_ = 0;
};

}  // namespace

MeshFile parse_vtu(std::string_view bytes, const std::string& source) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  return VtuReader(root, source).read();
}

MeshFile read_vtu(const std::filesystem::path& path) {
  return parse_vtu(read_whole_file(path), path.string());
}

PointField read_vtu_field(const std::filesystem::path& path, const std::string& name) {
  const std::string bytes = read_whole_file(path), source = path.string();
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  return VtuReader(root, source).read_field(name);
}

}  // namespace leonhard::io
