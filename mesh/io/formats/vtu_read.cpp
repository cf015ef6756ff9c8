// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "leonhard/mesh/io/formats/vtu_grid.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

namespace {

/// A cell's vertices as ids that exist.
template <std::size_t count>
std::array<VertexId, count> ids_of(const VtuGrid& grid, const VtuCells& cells, std::size_t c) {
  grid.check_vertex_count(cells, c, count);
  std::array<VertexId, count> ids;
  for (std::size_t i = 0; i < count; ++i) ids[i] = grid.vertex(*cells.array, cells.vertices(c)[i]);
  return ids;
}

/// Rows of a facet's vertices and its marker.
template <int Dim>
void read_facets(const VtuGrid& grid, const XmlElement& array, std::vector<SoupFacet<Dim>>& facets) {
  const std::vector<std::int64_t> rows = grid.read_rows(array, Dim + 1);
  for (std::size_t i = 0; i < rows.size(); i += Dim + 1) {
    SoupFacet<Dim> facet;
    for (std::size_t k = 0; k < Dim; ++k) facet.corners[k] = grid.vertex(array, rows[i + k]);
    facet.marker = grid.marker(array, rows[i + Dim]);
    facets.push_back(facet);
  }
}

/// What write_vtu wrote of the boundary and the inner facets, in place of what the cells say.
/// returns whether the file has it
template <int Dim>
bool read_boundary(const VtuGrid& grid, MeshSoup<Dim>& soup) {
  const XmlElement* boundary = VtuGrid::find_array(grid.field_data(), vtu_names::boundary);
  soup.marker_names = grid.read_marker_names();
  if (boundary == nullptr) return false;
  soup.facets.clear();
  read_facets<Dim>(grid, *boundary, soup.facets);
  const char* inner_facets = Dim == 2 ? vtu_names::constraints : vtu_names::interfaces;
  if (const XmlElement* inner = VtuGrid::find_array(grid.field_data(), inner_facets))
    read_facets<Dim>(grid, *inner, soup.facets);
  return true;
}

/// A soup with its points and cells, completed and assembled. Files of other programs: marked cells of the boundary got 1
/// where they have no marker, and so did facets without cells.
template <int Dim>
SimplexMeshFile<Dim> finish(const VtuGrid& grid, MeshSoup<Dim>&& soup) {
  soup.vertex_markers = grid.read_vertex_markers();
  soup.point_fields = grid.read_point_fields(soup.warnings);
  const bool knows_boundary = read_boundary(grid, soup);
  SimplexMeshFile<Dim> file = assemble(std::move(soup), knows_boundary ? FacetRule::boundary_and_inner_facets
                                                                       : FacetRule::fill_in_the_boundary);
  const auto has_marker_1 = [](const auto& facet) { return facet.marker == 1; };
  if (!knows_boundary && std::any_of(file.mesh.boundary.begin(), file.mesh.boundary.end(), has_marker_1))
    file.mesh.marker_names.try_emplace(1, "boundary");
  return file;
}

// ---- the plane ----

void read_triangle_cells(const VtuGrid& grid, MeshSoup<2>& soup) {
  const VtuCells cells = grid.read_cells();
  const std::vector<Marker> markers = grid.read_cell_markers();
  const std::vector<double> regions = grid.read_regions();
  for (std::size_t c = 0; c < cells.count(); ++c) {
    const std::int64_t type = cells.types[c];
    if (type == vtk_vertex) {
      grid.check_vertex_count(cells, c, 1);
    } else if (type == vtk_line) {
      soup.facets.push_back({ids_of<2>(grid, cells, c), markers.empty() ? 1 : markers[c]});
    } else if (type == vtk_triangle) {
      const auto [i, j, k] = ids_of<3>(grid, cells, c);
      soup.cells.push_back({{i, j, k}, 3});
    } else if (type == vtk_quadrilateral) {
      soup.cells.push_back({ids_of<4>(grid, cells, c), 4});
    } else {
      grid.fail(*cells.array, "cell " + std::to_string(c) + " has the type " + std::to_string(type),
                "only triangles (5), quadrilaterals (9), and lines (3) on the boundary can be read");
    }
    const bool is_cell = type == vtk_triangle || type == vtk_quadrilateral;
    if (is_cell && !regions.empty()) soup.cell_regions.push_back(regions[c]);
  }
  soup.cell_fields = grid.read_cell_fields(cells, std::array{vtk_triangle, vtk_quadrilateral}, soup.warnings);
}

// ---- space ----

void read_tet_cells(const VtuGrid& grid, MeshSoup<3>& soup) {
  const VtuCells cells = grid.read_cells();
  const std::vector<Marker> markers = grid.read_cell_markers();
  const std::vector<double> regions = grid.read_regions();
  for (std::size_t c = 0; c < cells.count(); ++c) {
    const std::int64_t type = cells.types[c];
    if (type == vtk_vertex) {
      grid.check_vertex_count(cells, c, 1);
    } else if (type == vtk_line) {
      grid.check_vertex_count(cells, c, 2);
    } else if (type == vtk_triangle) {
      soup.facets.push_back({ids_of<3>(grid, cells, c), markers.empty() ? 1 : markers[c]});
    } else if (type == vtk_tetrahedron) {
      soup.cells.push_back({ids_of<4>(grid, cells, c), 4});
      if (!regions.empty()) soup.cell_regions.push_back(regions[c]);
    } else {
      const char* name = type == 12   ? " (hexahedron)"
                         : type == 13 ? " (prism)"
                         : type == 14 ? " (pyramid)"
                                      : "";
      grid.fail(*cells.array, "cell " + std::to_string(c) + " has the type " + std::to_string(type) + name,
                "only tetrahedra (10), and triangles (5) on the boundary or inside, can be read");
    }
  }
  soup.cell_fields = grid.read_cell_fields(cells, std::array{vtk_tetrahedron}, soup.warnings);
}

}  // namespace

MeshFile parse_vtu(std::string_view bytes, const std::string& source) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  const VtuGrid grid(root, source);
  MeshSoup<2> soup;
  soup.source = source;
  soup.points = PerId<VertexId, Point2>(grid.read_plane_points());
  read_triangle_cells(grid, soup);
  return finish(grid, std::move(soup));
}

TetMeshFile parse_tet_vtu(std::string_view bytes, const std::string& source) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  const VtuGrid grid(root, source);
  MeshSoup<3> soup;
  soup.source = source;
  soup.points = PerId<VertexId, Point3>(grid.read_points());
  read_tet_cells(grid, soup);
  return finish(grid, std::move(soup));
}

MeshFile read_vtu(const std::filesystem::path& path) {
  return parse_vtu(read_whole_file(path), path.string());
}

TetMeshFile read_tet_vtu(const std::filesystem::path& path) {
  return parse_tet_vtu(read_whole_file(path), path.string());
}

PointField read_vtu_field(const std::filesystem::path& path, const std::string& name) {
  const std::string bytes = read_whole_file(path), source = path.string();
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  return VtuGrid(root, source).read_field(name);
}

}  // namespace leonhard::io
