// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/vtu_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// Names under which other programs keep the number of the physical group that a cell belongs to.
constexpr const char* cell_marker_names[] = {"marker", "gmsh:physical", "medit:ref", "CellEntityIds"};

/// No field of anybody has more, and no product with a number of vertices overflows.
constexpr std::int64_t most_components = 1000;

/// "it has density, mach", for the message about a field that is not there.
std::string field_names(const XmlElement* data) {
  std::string names;
  if (data != nullptr)
    for (const XmlElement& child : data->children)
      if (child.name == "DataArray") names += (names.empty() ? "it has " : ", ") + child.attribute("Name");
  return names;
}

}  // namespace

VtuGrid::VtuGrid(const XmlElement& root, const std::string& source) : source_(source) {
  if (root.name != "VTKFile" || root.attribute("type") != "UnstructuredGrid")
    fail(root, "this is no unstructured grid of VTK (<VTKFile type=\"UnstructuredGrid\">)",
         "give a .vtu file");
  encoding_ = vtk_encoding(root, source_);
  const XmlElement& grid = need(root, "UnstructuredGrid");
  if (std::count_if(grid.children.begin(), grid.children.end(),
                    [](const XmlElement& child) { return child.name == "Piece"; }) > 1)
    fail(grid, "the grid comes in several pieces", "merge them into one (ParaView: Merge Blocks)");
  piece_ = &need(grid, "Piece");
  field_data_ = grid.child("FieldData");
  point_count_ = read_count(*piece_, "NumberOfPoints");
  cell_count_ = read_count(*piece_, "NumberOfCells");
}

void VtuGrid::fail(const XmlElement& element, std::string problem, std::string remedy) const {
  throw InputError(at_line(source_, element.line), std::move(problem), std::move(remedy));
}

const XmlElement& VtuGrid::need(const XmlElement& parent, std::string_view name) const {
  const XmlElement* child = parent.child(name);
  if (child == nullptr)
    fail(parent, "the element <" + std::string(parent.name) + "> has no <" + std::string(name) + ">",
         "the file was cut short, or is no grid of VTK");
  return *child;
}

const XmlElement* VtuGrid::find_array(const XmlElement* data, std::string_view name) {
  if (data == nullptr) return nullptr;
  const auto found = std::find_if(data->children.begin(), data->children.end(), [&](const XmlElement& child) {
    return child.name == "DataArray" && child.attribute("Name") == name;
  });
  return found == data->children.end() ? nullptr : &*found;
}

const XmlElement& VtuGrid::need_array(const XmlElement& data, std::string_view name) const {
  const XmlElement* array = find_array(&data, name);
  if (array == nullptr)
    fail(data, "the element <" + std::string(data.name) + "> has no array " + in_quotes(name));
  return *array;
}

std::size_t VtuGrid::read_count(const XmlElement& element, const char* attribute) const {
  const std::string text = element.attribute(attribute);
  TextScanner scan(text, source_, {.lines_before = element.line - 1});
  scan.need_line(attribute);
  const std::int64_t count = scan.integer(attribute);
  // Whether the file can hold so many is known to the arrays; this keeps later sums from overflowing.
  if (count < 0 || count >= std::int64_t{std::numeric_limits<IdRaw>::max() / 4})
    fail(element, std::string(attribute) + " is " + std::to_string(count) + ", which no mesh can have");
  return static_cast<std::size_t>(count);
}

void VtuGrid::check_vertex_count(const VtuCells& cells, std::size_t c, std::size_t expected) const {
  if (cells.vertices(c).size() != expected)
    fail(*cells.array, "cell " + std::to_string(c) + " of type " + std::to_string(cells.types[c]) + " has " +
                           std::to_string(cells.vertices(c).size()) + " vertices");
}

VertexId VtuGrid::vertex(const XmlElement& array, std::int64_t id) const {
  if (id < 0 || static_cast<std::uint64_t>(id) >= point_count_)
    fail(array, "vertex " + std::to_string(id) + " does not exist, the file has vertices 0 to " +
                    std::to_string(static_cast<std::int64_t>(point_count_) - 1));
  return VertexId::from(static_cast<std::size_t>(id));
}

Marker VtuGrid::marker(const XmlElement& array, std::int64_t value) const {
  if (value < std::numeric_limits<Marker>::min() || value > std::numeric_limits<Marker>::max())
    fail(array, "the marker " + std::to_string(value) + " does not fit 32 bits");
  return static_cast<Marker>(value);
}

/// An array of whole numbers with one number a row, or none if it is missing or of another shape.
std::optional<std::vector<std::int64_t>> VtuGrid::find_numbers(const XmlElement* data, std::string_view name,
                                                               std::size_t count) const {
  const XmlElement* array = find_array(data, name);
  if (array == nullptr || array->attribute("NumberOfComponents", "1") != "1") return std::nullopt;
  if (array->attribute("type").starts_with("Float")) return std::nullopt;
  return read_integers(*array, encoding_, count);
}

std::vector<Marker> VtuGrid::markers(const XmlElement& array,
                                     const std::vector<std::int64_t>& numbers) const {
  std::vector<Marker> result;
  result.reserve(numbers.size());
  for (const std::int64_t value : numbers) result.push_back(marker(array, value));
  return result;
}

const XmlElement& VtuGrid::points_array() const { return need(need(*piece_, "Points"), "DataArray"); }

std::vector<Point3> VtuGrid::read_points() const {
  const XmlElement& array = points_array();
  if (array.attribute("NumberOfComponents") != "3") fail(array, "points have other than 3 components");
  const std::vector<double> coordinates = read_doubles(array, encoding_, 3 * point_count_);
  std::vector<Point3> points;
  points.reserve(point_count_);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  return points;
}

std::vector<Point2> VtuGrid::read_plane_points() const {
  const std::vector<Point3> points = read_points();
  std::vector<Point2> plane;
  plane.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].z != points[0].z)
      fail(points_array(),
           "point " + std::to_string(i) + " has z = " + std::to_string(points[i].z) +
               " unlike the first, which has z = " + std::to_string(points[0].z),
           "only meshes in a plane z = const can be read");
    plane.push_back({points[i].x, points[i].y});
  }
  return plane;
}

VtuCells VtuGrid::read_cells() const {
  const XmlElement& data = need(*piece_, "Cells");
  VtuCells cells;
  cells.array = &need_array(data, "connectivity");
  cells.offsets = read_integers(need_array(data, "offsets"), encoding_, cell_count_);
  cells.types = read_integers(need_array(data, "types"), encoding_, cell_count_);
  cells.connectivity = read_integers(*cells.array, encoding_, std::nullopt);
  std::int64_t begin = 0;
  for (std::size_t c = 0; c < cell_count_; ++c) {
    const std::int64_t end = cells.offsets[c];
    if (end < begin || end > std::ssize(cells.connectivity))
      fail(*cells.array, "cell " + std::to_string(c) + " ends at entry " + std::to_string(end) + " of " +
                             std::to_string(cells.connectivity.size()) + ", and begins at " +
                             std::to_string(begin));
    begin = end;
  }
  return cells;
}

std::vector<std::int64_t> VtuGrid::read_cell_types() const {
  return read_integers(need_array(need(*piece_, "Cells"), "types"), encoding_, cell_count_);
}

std::vector<Marker> VtuGrid::read_vertex_markers() const {
  const XmlElement* data = piece_->child("PointData");
  const auto numbers = find_numbers(data, vtu_names::vertex_marker, point_count_);
  if (!numbers) return {};
  return markers(*find_array(data, vtu_names::vertex_marker), *numbers);
}

std::vector<Marker> VtuGrid::read_cell_markers() const {
  for (const char* name : cell_marker_names)
    if (const auto numbers = find_numbers(cell_data(), name, cell_count_))
      return markers(*find_array(cell_data(), name), *numbers);
  return {};
}

std::vector<double> VtuGrid::read_regions() const {
  const XmlElement* array = find_array(cell_data(), vtu_names::region);
  if (array == nullptr || array->attribute("NumberOfComponents", "1") != "1") return {};
  return read_doubles(*array, encoding_, cell_count_);
}

std::vector<std::int64_t> VtuGrid::read_rows(const XmlElement& array, std::size_t width) const {
  std::vector<std::int64_t> rows = read_integers(array, encoding_, std::nullopt);
  if (rows.size() % width != 0)
    fail(array, "the entries do not come in rows of " + std::to_string(width) + " numbers");
  return rows;
}

std::map<Marker, std::string> VtuGrid::read_marker_names() const {
  const XmlElement* numbers_array = find_array(field_data_, vtu_names::marker_numbers);
  const XmlElement* names_array = find_array(field_data_, vtu_names::marker_names);
  if (numbers_array == nullptr || names_array == nullptr) return {};
  const auto numbers = read_integers(*numbers_array, encoding_, std::nullopt);
  std::vector<std::string> names(1);
  for (const std::int64_t byte : read_integers(*names_array, encoding_, std::nullopt)) {
    if (byte == 0) {
      names.emplace_back();
    } else {
      names.back() += static_cast<char>(byte);
    }
  }
  if (names.size() != numbers.size() + 1)
    fail(*names_array, "the numbers of markers and of their names differ");
  std::map<Marker, std::string> result;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    result.insert_or_assign(marker(*numbers_array, numbers[i]), names[i]);
  return result;
}

/// The numbers of one array, without the third component that write_vtu adds to two.
template <class Field>
Field VtuGrid::read_field(const XmlElement& array, std::size_t rows) const {
  Field field{array.attribute("Name"), 1, {}};
  const std::string text = array.attribute("NumberOfComponents", "1");
  TextScanner scan(text, source_, {.lines_before = array.line - 1});
  scan.need_line("the number of components");
  const std::int64_t components = scan.integer("the number of components");
  if (components < 1 || components > most_components)
    fail(array, "the field " + in_quotes(field.name) + " has " + std::to_string(components) + " components",
         "1 to " + std::to_string(most_components) + " can be read");
  field.components = static_cast<std::size_t>(components);
  field.values = read_field_values(array, encoding_, field.components * rows);
  if (components == 3 && array.attribute(vtu_names::components) == "2") {
    for (std::size_t i = 0; i < rows; ++i)
      std::copy_n(field.values.begin() + static_cast<std::ptrdiff_t>(3 * i), 2,
                  field.values.begin() + static_cast<std::ptrdiff_t>(2 * i));
    field.components = 2;
    field.values.resize(2 * rows);
  }
  return field;
}

template <class Field>
std::vector<Field> VtuGrid::read_fields(const XmlElement* data, std::size_t rows, const std::string& kept,
                                        std::vector<std::string>& warnings) const {
  std::vector<Field> fields;
  std::set<std::string> names;
  if (data == nullptr) return fields;
  for (const XmlElement& array : data->children) {
    if (array.name != "DataArray" && array.name != "Array") continue;
    const std::string name = array.attribute("Name");
    const bool is_number = array.name == "DataArray" && array.attribute("type") != "String";
    if (name == kept && names.insert(name).second) continue;  // the mesh has it
    const char* reason = !is_number                   ? "it holds no numbers"
                         : name.empty()               ? "it has no name"
                         : !names.insert(name).second ? "another one has this name"
                                                      : nullptr;
    if (reason != nullptr) {
      warnings.push_back(at_line(source_, array.line) + ": the array " + in_quotes(name) +
                         " was left out: " + reason);
    } else {
      fields.push_back(read_field<Field>(array, rows));
    }
  }
  return fields;
}

std::vector<PointField> VtuGrid::read_point_fields(std::vector<std::string>& warnings) const {
  return read_fields<PointField>(piece_->child("PointData"), point_count_, vtu_names::vertex_marker,
                                 warnings);
}
std::vector<CellField> VtuGrid::read_cell_fields(std::vector<std::string>& warnings) const {
  return read_fields<CellField>(cell_data(), cell_count_, vtu_names::region, warnings);
}

std::vector<CellField> VtuGrid::read_cell_fields(const VtuCells& cells, std::span<const std::int64_t> types,
                                                 std::vector<std::string>& warnings) const {
  std::vector<CellField> fields = read_cell_fields(warnings);
  for (CellField& field : fields) {
    std::size_t kept = 0;
    for (std::size_t c = 0; c < cells.count(); ++c) {
      if (std::find(types.begin(), types.end(), cells.types[c]) == types.end()) continue;
      const auto row = field.values.begin() + static_cast<std::ptrdiff_t>(c * field.components);
      std::copy_n(row, field.components,
                  field.values.begin() + static_cast<std::ptrdiff_t>(kept++ * field.components));
    }
    field.values.resize(kept * field.components);
  }
  return fields;
}

PointField VtuGrid::read_field(const std::string& name) const {
  const XmlElement* data = piece_->child("PointData");
  const XmlElement* array = find_array(data, name);
  if (array == nullptr)
    fail(data != nullptr ? *data : *piece_, "there is no point field " + in_quotes(name), field_names(data));
  PointField field = read_field<PointField>(*array, point_count_);
  if (field.components > 3)
    fail(*array, "the field " + in_quotes(name) + " has " + std::to_string(field.components) + " components",
         "1 to 3 can be read");
  for (std::size_t i = 0; i < field.values.size(); ++i)
    if (!std::isfinite(field.values[i]))
      fail(*array, "the field " + in_quotes(name) + " is not finite at vertex " +
                       std::to_string(i / field.components));
  return field;
}

}  // namespace leonhard::io
