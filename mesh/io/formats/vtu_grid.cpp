// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/vtk_array.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/formats/xml.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {
namespace {

/// No field of anybody has more, and no product with a number of vertices overflows.
constexpr std::int64_t most_components = 1000;

/// One piece of a .vtu file. Everything throws InputError that names the line of the element at fault.
class VtuPiece {
 public:
  VtuPiece(const XmlElement& piece, const VtkEncoding& encoding) : piece_(piece), encoding_(encoding) {
    point_count_ = read_count("NumberOfPoints");
    cell_count_ = read_count("NumberOfCells");
  }

  VtkGrid read() const {
    VtkGrid grid;
    if (point_count_ > 0) grid.points = read_points(grid.points_line);
    if (cell_count_ > 0) read_cells(grid);
    grid.point_arrays = read_arrays(piece_.child("PointData"), point_count_, grid.warnings);
    grid.cell_arrays = read_arrays(piece_.child("CellData"), cell_count_, grid.warnings);
    return grid;
  }

 private:
  [[noreturn]] void fail(const XmlElement& element, std::string problem, std::string remedy = {}) const {
    throw InputError(at_line(encoding_.source, element.line), std::move(problem), std::move(remedy));
  }

  const XmlElement& need(const XmlElement& parent, std::string_view name) const {
    const XmlElement* child = parent.child(name);
    if (child == nullptr)
      fail(parent, "the element <" + std::string(parent.name) + "> has no <" + std::string(name) + ">",
           "the file was cut short, or is no grid of VTK");
    return *child;
  }

  const XmlElement& need_array(const XmlElement& data, std::string_view name) const {
    const auto found = std::find_if(data.children.begin(), data.children.end(), [&](const XmlElement& child) {
      return child.name == "DataArray" && child.attribute("Name") == name;
    });
    if (found == data.children.end())
      fail(data, "the element <" + std::string(data.name) + "> has no array " + in_quotes(name));
    return *found;
  }

  /// Whether the file can hold so many is known to the arrays; the bound keeps later sums from overflowing.
  std::size_t read_count(const char* attribute) const {
    const std::string text = piece_.attribute(attribute);
    TextScanner scan(text, encoding_.source, {.lines_before = piece_.line - 1});
    scan.need_line(attribute);
    const std::int64_t count = scan.integer(attribute);
    if (count < 0 || count >= std::int64_t{std::numeric_limits<IdRaw>::max() / 4})
      fail(piece_, std::string(attribute) + " is " + std::to_string(count) + ", which no mesh can have");
    return static_cast<std::size_t>(count);
  }

  std::vector<Point3> read_points(std::size_t& line) const {
    const XmlElement& array = need(need(piece_, "Points"), "DataArray");
    line = array.line;
    if (array.attribute("NumberOfComponents") != "3") fail(array, "points have other than 3 components");
    const std::vector<double> coordinates = read_doubles(array, encoding_, 3 * point_count_);
    std::vector<Point3> points;
    points.reserve(point_count_);
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    return points;
  }

  void read_cells(VtkGrid& grid) const {
    const XmlElement& data = need(piece_, "Cells");
    const XmlElement& connectivity = need_array(data, "connectivity");
    grid.cells_line = connectivity.line;
    grid.offsets = read_integers(need_array(data, "offsets"), encoding_, cell_count_);
    grid.types = read_integers(need_array(data, "types"), encoding_, cell_count_);
    grid.connectivity = read_integers(connectivity, encoding_, std::nullopt);
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < cell_count_; ++c) {
      const std::int64_t end = grid.offsets[c];
      if (end < begin || end > std::ssize(grid.connectivity))
        fail(connectivity, "cell " + std::to_string(c) + " ends at entry " + std::to_string(end) + " of " +
                               std::to_string(grid.connectivity.size()) + ", and begins at " +
                               std::to_string(begin));
      begin = end;
    }
    for (const std::int64_t v : grid.connectivity)
      if (v < 0 || static_cast<std::uint64_t>(v) >= point_count_)
        fail(connectivity, "vertex " + std::to_string(v) + " does not exist, the file has vertices 0 to " +
                               std::to_string(static_cast<std::int64_t>(point_count_) - 1));
  }

  /// The numbers of one array, without the third component that write_vtu adds to two.
  VtkNumbers read_numbers_of(const XmlElement& array, std::size_t rows) const {
    VtkNumbers numbers{
        array.attribute("Name"), 1, !array.attribute("type").starts_with("Float"), {}, array.line};
    const std::string text = array.attribute("NumberOfComponents", "1");
    TextScanner scan(text, encoding_.source, {.lines_before = array.line - 1});
    scan.need_line("the number of components");
    const std::int64_t components = scan.integer("the number of components");
    if (components < 1 || components > most_components)
      fail(array,
           "the field " + in_quotes(numbers.name) + " has " + std::to_string(components) + " components",
           "1 to " + std::to_string(most_components) + " can be read");
    numbers.components = static_cast<std::size_t>(components);
    numbers.values = read_field_values(array, encoding_, numbers.components * rows);
    if (components == 3 && array.attribute(vtu_names::components) == "2") {
      for (std::size_t i = 0; i < rows; ++i)
        std::copy_n(numbers.values.begin() + static_cast<std::ptrdiff_t>(3 * i), 2,
                    numbers.values.begin() + static_cast<std::ptrdiff_t>(2 * i));
      numbers.components = 2;
      numbers.values.resize(2 * rows);
    }
    return numbers;
  }

  std::vector<VtkNumbers> read_arrays(const XmlElement* data, std::size_t rows,
                                      std::vector<std::string>& warnings) const {
    std::vector<VtkNumbers> arrays;
    std::set<std::string> names;
    if (data == nullptr) return arrays;
    for (const XmlElement& array : data->children) {
      if (array.name != "DataArray" && array.name != "Array") continue;
      const std::string name = array.attribute("Name");
      const bool is_number = array.name == "DataArray" && array.attribute("type") != "String";
      const char* reason = !is_number                   ? "it holds no numbers"
                           : name.empty()               ? "it has no name"
                           : !names.insert(name).second ? "another one has this name"
                                                        : nullptr;
      if (reason != nullptr) {
        warnings.push_back(at_line(encoding_.source, array.line) + ": the array " + in_quotes(name) +
                           " was left out: " + reason);
      } else {
        arrays.push_back(read_numbers_of(array, rows));
      }
    }
    return arrays;
  }

  const XmlElement& piece_;
  const VtkEncoding& encoding_;
  std::size_t point_count_ = 0, cell_count_ = 0;
};

/// What write_vtu adds to a file.
class VtuFieldData {
 public:
  VtuFieldData(const XmlElement& data, const VtkEncoding& encoding) : data_(data), encoding_(encoding) {}

  void read(VtkGrid& grid) const {
    if (const XmlElement* facets = find(vtu_names::facets)) {
      const auto counts = read_integers(*facets, encoding_, std::nullopt);
      grid.own_facets = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    }
    grid.marker_names = names(vtu_names::marker_numbers, vtu_names::marker_names);
    grid.region_names = names(vtu_names::region_numbers, vtu_names::region_names);
  }

 private:
  [[noreturn]] void fail(const XmlElement& element, const std::string& problem) const {
    throw InputError(at_line(encoding_.source, element.line), problem, "the file was damaged");
  }

  const XmlElement* find(std::string_view name) const {
    const auto found =
        std::find_if(data_.children.begin(), data_.children.end(), [&](const XmlElement& child) {
          return child.name == "DataArray" && child.attribute("Name") == name;
        });
    return found == data_.children.end() ? nullptr : &*found;
  }

  std::map<Marker, std::string> names(std::string_view numbers_name, std::string_view bytes_name) const {
    const XmlElement *numbers_array = find(numbers_name), *bytes_array = find(bytes_name);
    if (numbers_array == nullptr || bytes_array == nullptr) return {};
    const auto numbers = read_integers(*numbers_array, encoding_, std::nullopt);
    std::vector<std::string> words(1);
    for (const std::int64_t byte : read_integers(*bytes_array, encoding_, std::nullopt)) {
      if (byte == 0) {
        words.emplace_back();
      } else {
        words.back() += static_cast<char>(byte);
      }
    }
    if (words.size() != numbers.size() + 1)
      fail(*bytes_array, "the numbers of markers and of their names differ");
    std::map<Marker, std::string> result;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] < std::numeric_limits<Marker>::min() || numbers[i] > std::numeric_limits<Marker>::max())
        fail(*numbers_array, "the marker " + std::to_string(numbers[i]) + " does not fit 32 bits");
      result.insert_or_assign(static_cast<Marker>(numbers[i]), words[i]);
    }
    return result;
  }

  const XmlElement& data_;
  const VtkEncoding& encoding_;
};

const XmlElement& need_root(const XmlElement& root, const char* type, const std::string& source) {
  if (root.name == "VTKFile" && root.attribute("type") == type)
    if (const XmlElement* grid = root.child(type)) return *grid;
  throw InputError(at_line(source, root.line),
                   std::string("this is no unstructured grid of VTK (<VTKFile type=\"") + type + "\">)",
                   "give a .vtu file");
}

/// Pieces one after another.
class PieceJoiner {
 public:
  void add(VtkGrid&& piece) {
    first_points_.push_back(grid_.points.size());
    append_piece(grid_, std::move(piece));
  }
  VtkGrid finish() && {
    if (first_points_.size() > 1) join_pieces(grid_, first_points_);
    return std::move(grid_);
  }

 private:
  VtkGrid grid_;
  std::vector<std::size_t> first_points_;
};

}  // namespace

VtkGrid parse_vtu_grid(std::string_view bytes, const std::string& source) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  const XmlElement& grid = need_root(root, "UnstructuredGrid", source);
  const VtkEncoding encoding = vtk_encoding(root, source);
  PieceJoiner joiner;
  std::size_t pieces = 0;
  for (const XmlElement& child : grid.children) {
    if (child.name != "Piece") continue;
    VtkGrid piece = VtuPiece(child, encoding).read();
    if (const XmlElement* data = grid.child("FieldData"); data != nullptr && pieces == 0)
      VtuFieldData(*data, encoding).read(piece);
    joiner.add(std::move(piece));
    ++pieces;
  }
  if (pieces == 0)
    throw InputError(at_line(source, grid.line), "the element <UnstructuredGrid> has no <Piece>",
                     "the file was cut short, or is no grid of VTK");
  return std::move(joiner).finish();
}

VtkGrid read_pvtu_grid(std::string_view bytes, const std::string& source,
                       const std::filesystem::path& folder) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  const XmlElement& grid = need_root(root, "PUnstructuredGrid", source);
  PieceJoiner joiner;
  std::size_t pieces = 0;
  for (const XmlElement& child : grid.children) {
    if (child.name != "Piece") continue;
    ++pieces;
    const std::string name = child.attribute("Source");
    if (name.empty())
      throw InputError(at_line(source, child.line), "a <Piece> names no file (Source=)",
                       "the file was damaged");
    const std::filesystem::path path = folder / name;
    joiner.add(parse_vtu_grid(read_whole_file(path), path.string()));
  }
  if (pieces == 0)
    throw InputError(at_line(source, grid.line), "the file names no pieces", "it was cut short");
  return std::move(joiner).finish();
}

}  // namespace leonhard::io
