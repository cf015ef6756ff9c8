// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/formats/vtk_array.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/formats/xml.hpp"
#include "leonhard/mesh/pslg.hpp"

/// What the grids of the plane and of space have in common. Not meant for callers of the room.
namespace leonhard::io {

/// The cells of a grid.
struct VtuCells {
  const XmlElement* array = nullptr;  ///< the connectivity, for errors
  std::vector<std::int64_t> types, connectivity, offsets;

  [[nodiscard]] std::size_t count() const { return types.size(); }
  /// The vertices of a cell, whose range is not yet known.
  [[nodiscard]] std::span<const std::int64_t> vertices(std::size_t c) const {
    const std::int64_t begin = c == 0 ? 0 : offsets[c - 1];
    return std::span(connectivity)
        .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(offsets[c] - begin));
  }
};

/// The one piece of a .vtu file. Everything throws InputError that names the line of the element at fault.
class VtuGrid {
 public:
  /// Checks what the file is and finds its piece. root and source must outlive the grid.
  VtuGrid(const XmlElement& root, const std::string& source);

  [[nodiscard]] const XmlElement& piece() const { return *piece_; }
  [[nodiscard]] const XmlElement* field_data() const { return field_data_; }
  [[nodiscard]] const XmlElement* cell_data() const { return piece_->child("CellData"); }
  [[nodiscard]] std::size_t point_count() const { return point_count_; }

  [[nodiscard]] const XmlElement& points_array() const;
  [[nodiscard]] std::vector<Point3> read_points() const;
  /// Of a mesh in a plane z = const.
  [[nodiscard]] std::vector<Point2> read_plane_points() const;
  /// Offsets are in order and within the connectivity.
  [[nodiscard]] VtuCells read_cells() const;
  /// The types of the cells alone.
  [[nodiscard]] std::vector<std::int64_t> read_cell_types() const;
  /// One a vertex, or none.
  [[nodiscard]] std::vector<Marker> read_vertex_markers() const;
  /// One a cell under whatever name programs keep markers of cells, or none.
  [[nodiscard]] std::vector<Marker> read_cell_markers() const;
  /// One a cell, or none.
  [[nodiscard]] std::vector<double> read_regions() const;
  /// Names that write_vtu wrote, or none.
  [[nodiscard]] std::map<Marker, std::string> read_marker_names() const;
  /// Rows of whole numbers.
  [[nodiscard]] std::vector<std::int64_t> read_rows(const XmlElement& array, std::size_t width) const;
  /// A field whose values are all finite.
  [[nodiscard]] PointField read_field(const std::string& name) const;
  /// All fields of points and of cells but those that carry the mesh; what is left out the warnings say.
  [[nodiscard]] std::vector<PointField> read_point_fields(std::vector<std::string>& warnings) const;
  [[nodiscard]] std::vector<CellField> read_cell_fields(std::vector<std::string>& warnings) const;
  /// Those of cells without the rows of cells of other types, such as lines on the boundary.
  [[nodiscard]] std::vector<CellField> read_cell_fields(const VtuCells& cells,
                                                        std::span<const std::int64_t> types,
                                                        std::vector<std::string>& warnings) const;

  [[nodiscard]] static const XmlElement* find_array(const XmlElement* data, std::string_view name);
  [[nodiscard]] VertexId vertex(const XmlElement& array, std::int64_t id) const;   ///< which must exist
  [[nodiscard]] Marker marker(const XmlElement& array, std::int64_t value) const;  ///< which must fit
  void check_vertex_count(const VtuCells& cells, std::size_t c, std::size_t expected) const;
  [[noreturn]] void fail(const XmlElement& element, std::string problem, std::string remedy = {}) const;

 private:
  const XmlElement& need(const XmlElement& parent, std::string_view name) const;
  const XmlElement& need_array(const XmlElement& data, std::string_view name) const;
  std::size_t read_count(const XmlElement& element, const char* attribute) const;
  std::optional<std::vector<std::int64_t>> find_numbers(const XmlElement* data, std::string_view name,
                                                        std::size_t count) const;
  template <class Field>
  std::vector<Field> read_fields(const XmlElement* data, std::size_t rows, const std::string& kept,
                                 std::vector<std::string>& warnings) const;
  template <class Field>
  Field read_field(const XmlElement& array, std::size_t rows) const;
  std::vector<Marker> markers(const XmlElement& array, const std::vector<std::int64_t>& numbers) const;

  const std::string& source_;
  VtkEncoding encoding_;
  const XmlElement* piece_ = nullptr;
  const XmlElement* field_data_ = nullptr;
  std::size_t point_count_ = 0, cell_count_ = 0;
};

}  // namespace leonhard::io
