// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

/// Names under which other programs keep the number of the physical group that a cell belongs to.
constexpr std::array foreign_groups{"gmsh:physical", "medit:ref", "CellEntityIds"};

const VtkNumbers* find_whole(const std::vector<VtkNumbers>& arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const VtkNumbers& array) {
    return array.name == name && array.components == 1 && array.is_whole;
  });
  return found == arrays.end() ? nullptr : &*found;
}

/// A whole number without an exponent.
std::string fixed_words(double value) {
  return std::abs(value) < 0x1p53 ? std::to_string(static_cast<std::int64_t>(value)) : mesh::words(value);
}

Marker as_marker(const VtkNumbers& array, double value, const std::string& source) {
  if (!(value >= std::numeric_limits<Marker>::min() && value <= std::numeric_limits<Marker>::max()))
    throw InputError(array.line == 0 ? source : at_line(source, array.line),
                     "the array " + in_quotes(array.name) + " holds " + fixed_words(value) +
                         ", which does not fit 32 bits",
                     "number groups and markers with 32 bits");
  return static_cast<Marker>(value);
}

double as_region(const VtkNumbers& array, double value, const std::string& source) {
  if (!std::isfinite(value))
    throw InputError(
        array.line == 0 ? source : at_line(source, array.line),
        "the array " + in_quotes(array.name) + " holds " + mesh::words(value) + ", which is no region",
        "number regions with finite numbers, or give the array another name");
  return value;
}

template <int Dim>
class VtkSoupMaker {
 public:
  VtkSoupMaker(VtkGrid&& grid, const std::string& source) : grid_(grid) {
    soup_.source = source;
    soup_.prisms_turn_either_way = true;
    groups_ = find_groups();
    markers_ = find_whole(grid.cell_arrays, vtu_names::other_cell_marker);
    if (markers_ == nullptr) markers_ = find_whole(grid.cell_arrays, vtu_names::cell_marker);
    has_own_markers_ = markers_ != nullptr;
    if (markers_ == nullptr) markers_ = groups_;
    for (const VtkNumbers& array : grid.cell_arrays)
      if (array.name == vtu_names::region && array.components == 1) regions_ = &array;
    if (regions_ == nullptr) regions_ = groups_;
  }

  MeshSoup<Dim> make() {
    add_points();
    for (std::size_t c = 0; c < grid_.cell_count(); ++c) add_cell(c);
    take_own_facets();
    take_point_arrays();
    take_cell_arrays();
    if (of_higher_order_ > 0)
      grid_.warnings.push_back(std::to_string(of_higher_order_) +
                               " cells are of higher order; they were read by their corners");
    soup_.warnings = std::move(grid_.warnings);
    soup_.mesh.region_names = std::move(grid_.region_names);
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    fail_at(grid_.cells_line, problem, remedy);
  }
  [[noreturn]] void fail_at(std::size_t line, const std::string& problem, const std::string& remedy) const {
    throw InputError(line == 0 ? soup_.source : at_line(soup_.source, line), problem, remedy);
  }

  const VtkNumbers* find_groups() const {
    for (const char* name : foreign_groups)
      if (const VtkNumbers* array = find_whole(grid_.cell_arrays, name)) return array;
    return nullptr;
  }

  void add_points() {
    soup_.mesh.points.reserve(grid_.points.size());
    for (std::size_t i = 0; i < grid_.points.size(); ++i) {
      const Point3& p = grid_.points[i];
      if constexpr (Dim == 3) {
        soup_.mesh.points.push_back(p);
      } else {
        if (p.z != grid_.points[0].z)
          fail_at(grid_.points_line,
                  "point " + std::to_string(i) + " has z = " + mesh::words(p.z) +
                      " unlike the first, which has z = " + mesh::words(grid_.points[0].z),
                  "only meshes in a plane z = const can be read");
        soup_.mesh.points.push_back({p.x, p.y});
      }
    }
  }

  // ---- cells ----

  /// The first corners of a cell, in CellKind's order.
  std::array<VertexId, most_cell_corners> corners_of(std::size_t c, std::size_t count) {
    const auto vertices = grid_.vertices(c);
    if (vertices.size() < count)
      fail("cell " + std::to_string(c) + " of type " + std::to_string(grid_.types[c]) + " has " +
               std::to_string(vertices.size()) + " vertices",
           "it needs " + std::to_string(count) + " or more");
    std::array<VertexId, most_cell_corners> corners{};
    for (std::size_t i = 0; i < count; ++i)
      corners[i] = VertexId::from(static_cast<std::size_t>(vertices[i]));
    const std::int64_t type = grid_.types[c];
    if (type == vtk_pixel || type == vtk_voxel) std::swap(corners[2], corners[3]);
    if (type == vtk_voxel) std::swap(corners[6], corners[7]);
    if (vertices.size() > count) ++of_higher_order_;
    return corners;
  }

  void add_cell(std::size_t c) {
    const std::int64_t type = grid_.types[c];
    if (type == vtk_vertex || type == vtk_poly_vertex) return;
    if (type == vtk_triangle_strip) return add_strip(c);
    if (type == vtk_poly_line) return add_poly_line(c);
    if (type == vtk_polygon) return add_polygon(c);
    const auto kind = vtk_kind_of(type);
    if (!kind || kind->dimension > Dim)
      fail("cell " + std::to_string(c) + " has the type " + std::to_string(type) +
               (kind ? ", which is a cell of space" : ""),
           kind ? "give a mesh of the plane"
                : "cells of VTK's linear, quadratic and Lagrange types can be read, and strips, pixels and "
                  "voxels");
    const auto corners = corners_of(c, kind->corner_count);
    add(c, std::span<const VertexId>(corners.data(), kind->corner_count), kind->kind, kind->dimension);
  }

  /// A cell, a facet, or a line in space, which is passed over.
  void add(std::size_t c, std::span<const VertexId> corners, std::optional<CellKind> kind, int dimension) {
    if (dimension == Dim) {
      const CellId cell = soup_.mesh.add_cell(*kind, corners);
      if (regions_ != nullptr)
        soup_.mesh.regions[cell] = as_region(*regions_, regions_->values[c], soup_.source);
      cell_rows_.push_back(c);
    } else if (dimension == Dim - 1) {
      has_unmarked_facets_ = has_unmarked_facets_ || markers_ == nullptr;
      soup_.mesh.boundary.push_back(
          {MixedFacet<Dim>(corners),
           markers_ == nullptr ? 1 : as_marker(*markers_, markers_->values[c], soup_.source)});
    }
  }

  void add_strip(std::size_t c) {
    const auto vertices = grid_.vertices(c);
    for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
      std::array<VertexId, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = VertexId::from(static_cast<std::size_t>(vertices[i + k]));
      if (i % 2 == 1) std::swap(corners[1], corners[2]);
      add(c, corners, CellKind::triangle, 2);
    }
  }

  void add_poly_line(std::size_t c) {
    const auto vertices = grid_.vertices(c);
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      add(c,
          std::array{VertexId::from(static_cast<std::size_t>(vertices[i])),
                     VertexId::from(static_cast<std::size_t>(vertices[i + 1]))},
          std::nullopt, 1);
  }

  void add_polygon(std::size_t c) {
    const std::size_t count = grid_.vertices(c).size();
    if (count != 3 && count != 4)
      fail("cell " + std::to_string(c) + " is a polygon of " + std::to_string(count) + " corners",
           "cells of the plane have three or four");
    const auto corners = corners_of(c, count);
    add(c, std::span<const VertexId>(corners.data(), count),
        count == 3 ? CellKind::triangle : CellKind::quadrilateral, 2);
  }

  /// A file of write_vtu that still has the facets that it was written with keeps them as they are.
  void take_own_facets() {
    soup_.mesh.marker_names = std::move(grid_.marker_names);
    soup_.facets_as_they_are = grid_.own_facets == std::ssize(soup_.mesh.boundary);
    if (has_unmarked_facets_) soup_.mesh.marker_names.try_emplace(1, "boundary");
  }

  // ---- fields ----

  void take_point_arrays() {
    for (VtkNumbers& array : grid_.point_arrays) {
      const bool is_marker =
          array.name == vtu_names::vertex_marker && array.components == 1 && array.is_whole;
      if (!is_marker) {
        soup_.point_fields.push_back({std::move(array.name), array.components, std::move(array.values)});
        continue;
      }
      for (const double value : array.values)
        soup_.mesh.vertex_markers.push_back(as_marker(array, value, soup_.source));
    }
  }

  /// The rows of the soup's cells, not those of lines on the boundary. What has become markers or regions is no field.
  void take_cell_arrays() {
    for (const VtkNumbers& array : grid_.cell_arrays) {
      if (&array == regions_ || (&array == markers_ && has_own_markers_)) continue;
      CellField field{array.name, array.components, {}};
      field.values.reserve(cell_rows_.size() * array.components);
      for (const std::size_t row : cell_rows_) {
        const auto begin = array.values.begin() + static_cast<std::ptrdiff_t>(row * array.components);
        field.values.insert(field.values.end(), begin, begin + static_cast<std::ptrdiff_t>(array.components));
      }
      soup_.cell_fields.push_back(std::move(field));
    }
  }

  VtkGrid& grid_;
  MeshSoup<Dim> soup_;
  const VtkNumbers *groups_ = nullptr, *markers_ = nullptr, *regions_ = nullptr;
  std::vector<std::size_t> cell_rows_;  ///< in the file, of each of the soup's cells
  std::size_t of_higher_order_ = 0;
  bool has_unmarked_facets_ = false, has_own_markers_ = false;
};

}  // namespace

template <int Dim>
MeshSoup<Dim> vtk_soup(VtkGrid&& grid, const std::string& source) {
  return VtkSoupMaker<Dim>(std::move(grid), source).make();
}

template MeshSoup<2> vtk_soup(VtkGrid&&, const std::string&);
template MeshSoup<3> vtk_soup(VtkGrid&&, const std::string&);

}  // namespace leonhard::io
