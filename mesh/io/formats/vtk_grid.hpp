// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

/// What the unstructured grids of VTK state, whatever file they come from. Not meant for callers of the room.
namespace leonhard::io {

/// Numbers of points or cells, row after row.
struct VtkNumbers {
  std::string name;
  std::size_t components = 1;
  bool is_whole = false;  ///< of an integer type
  std::vector<double> values;
  std::size_t line = 0;  ///< of the file, for errors; 0: unknown
};

/// A grid: vertices exist, offsets are in order, arrays have their rows.
struct VtkGrid {
  std::vector<Point3> points;
  std::vector<std::int64_t> types, connectivity, offsets;  ///< a cell ends at its offset
  std::vector<VtkNumbers> point_arrays, cell_arrays;
  std::optional<std::int64_t> own_facets;                    ///< ours: how many cells are facets
  std::map<Marker, std::string> marker_names, region_names;  ///< ours
  std::vector<std::string> warnings;
  std::size_t points_line = 0, cells_line = 0;  ///< of the file, for errors; 0: unknown

  [[nodiscard]] std::size_t cell_count() const { return types.size(); }
  [[nodiscard]] std::span<const std::int64_t> vertices(std::size_t c) const {
    const std::int64_t begin = c == 0 ? 0 : offsets[c - 1];
    return std::span(connectivity)
        .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(offsets[c] - begin));
  }
};

/// A .vtu text: all its pieces, joined. throws InputError as read_vtu
[[nodiscard]] VtkGrid parse_vtu_grid(std::string_view bytes, const std::string& source);

/// A .pvtu text and the .vtu files that it names, joined.
/// folder  of the .pvtu, from which the names of the others count
[[nodiscard]] VtkGrid read_pvtu_grid(std::string_view bytes, const std::string& source,
                                     const std::filesystem::path& folder);

/// A legacy .vtk text or binary of the versions 2 to 5: DATASET UNSTRUCTURED_GRID, or POLYDATA with its polygons, lines and
/// strips. throws InputError naming the line or byte
[[nodiscard]] VtkGrid parse_legacy_vtk(std::string_view bytes, const std::string& source);

/// Append a piece to a grid. Fields that one of the two does not have are dropped, which a warning tells; cells that are
/// copies of another piece's (vtkGhostType) too.
void append_piece(VtkGrid& grid, VtkGrid&& piece);

/// Points of equal coordinates that come from different pieces become one, if no piece has two of them there.
///
/// first_points  the first point of each piece
void join_pieces(VtkGrid& grid, const std::vector<std::size_t>& first_points);

/// 3 if the grid has cells of space or its points do not lie in a plane z = const, else 2.
[[nodiscard]] int dimension_of(const VtkGrid& grid);

/// The grid as a soup. Cells of any order are taken by their corners, pixels and voxels in the order of quadrilaterals and
/// hexahedra, strips as their triangles; cells of the dimension below are facets; points, and in space lines, are passed over.
/// throws InputError: points off the plane z = const (Dim = 2), cells of other types or of too few vertices
template <int Dim>
[[nodiscard]] MeshSoup<Dim> vtk_soup(VtkGrid&& grid, const std::string& source);

}  // namespace leonhard::io
