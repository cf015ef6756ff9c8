// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "leonhard/mesh/io/formats/vtu_grid.hpp"
#include "leonhard/mesh/io/formats/vtu_names.hpp"
#include "leonhard/mesh/io/soup/mixed_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {
namespace {

/// The corners of cells that are facets of the mesh: of type 3 in the plane, 5 and 9 in space; 0 for others.
template <int Dim>
std::size_t facet_corners_of_type(std::int64_t type) {
  if (Dim == 2) return type == vtk_line ? 2 : 0;
  return type == vtk_triangle ? 3 : type == vtk_quadrilateral ? 4 : 0;
}

/// Types that are passed over, and how many vertices they have: points, and in space lines.
template <int Dim>
std::size_t corners_of_ignored_type(std::int64_t type) {
  return type == vtk_vertex ? 1 : Dim == 3 && type == vtk_line ? 2 : 0;
}

/// The vertices of a cell, which exist.
std::vector<VertexId> vertices_of_cell(const VtuGrid& grid, const VtuCells& cells, std::size_t c,
                                       std::size_t count) {
  grid.check_vertex_count(cells, c, count);
  std::vector<VertexId> ids;
  for (const std::int64_t v : cells.vertices(c)) ids.push_back(grid.vertex(*cells.array, v));
  return ids;
}

template <int Dim>
void read_mixed_cells(const VtuGrid& grid, MixedSoup<Dim>& soup) {
  const VtuCells cells = grid.read_cells();
  const std::vector<Marker> markers = grid.read_cell_markers();
  const std::vector<double> regions = grid.read_regions();
  for (std::size_t c = 0; c < cells.count(); ++c) {
    const std::int64_t type = cells.types[c];
    const auto kind = kind_of_vtk_type(type);
    if (kind && shape_of(*kind).dimension == Dim) {
      // Prisms stand on either base; assemble turns those over that have it outwards.
      const CellId cell =
          soup.mesh.add_cell(*kind, vertices_of_cell(grid, cells, c, shape_of(*kind).corner_count));
      if (!regions.empty()) soup.mesh.regions[cell] = regions[c];
    } else if (const std::size_t count = facet_corners_of_type<Dim>(type); count != 0) {
      soup.mesh.boundary.push_back(
          {MixedFacet<Dim>(vertices_of_cell(grid, cells, c, count)), markers.empty() ? 1 : markers[c]});
    } else if (const std::size_t ignored = corners_of_ignored_type<Dim>(type); ignored != 0) {
      grid.check_vertex_count(cells, c, ignored);
    } else {
      grid.fail(
          *cells.array, "cell " + std::to_string(c) + " has the type " + std::to_string(type),
          Dim == 2
              ? "only triangles (5), quadrilaterals (9), and lines (3) on the boundary can be read"
              : "only tetrahedra (10), hexahedra (12), prisms (13) and pyramids (14), and triangles (5) and "
                "quadrilaterals (9) on the boundary or inside, can be read");
    }
  }
  std::vector<std::int64_t> types;
  for (std::size_t kind = 0; kind < cell_kind_count; ++kind)
    if (shape_of(static_cast<CellKind>(kind)).dimension == Dim) types.push_back(vtk_types[kind]);
  soup.cell_fields = grid.read_cell_fields(cells, types, soup.warnings);
}

/// Rows of a facet's vertices, of which the last is -1 where it has three, and its marker.
template <int Dim>
void read_mixed_facets(const VtuGrid& grid, const XmlElement& array,
                       std::vector<MarkedMixedFacet<Dim>>& facets) {
  const std::size_t corners = Dim == 3 && array.attribute("NumberOfComponents") == "5" ? 4 : Dim;
  const std::vector<std::int64_t> rows = grid.read_rows(array, corners + 1);
  for (std::size_t i = 0; i < rows.size(); i += corners + 1) {
    std::vector<VertexId> vertices;
    for (std::size_t k = 0; k < corners; ++k)
      if (k < Dim || rows[i + k] != -1) vertices.push_back(grid.vertex(array, rows[i + k]));
    facets.push_back({MixedFacet<Dim>(vertices), grid.marker(array, rows[i + corners])});
  }
}

/// What write_vtu wrote of the boundary and the inner facets, in place of what the cells say.
/// returns whether the file has it
template <int Dim>
bool read_mixed_boundary(const VtuGrid& grid, MixedMesh<Dim>& mesh) {
  const XmlElement* boundary = VtuGrid::find_array(grid.field_data(), vtu_names::boundary);
  mesh.marker_names = grid.read_marker_names();
  if (boundary == nullptr) return false;
  mesh.boundary.clear();
  read_mixed_facets<Dim>(grid, *boundary, mesh.boundary);
  const char* inner_facets = Dim == 2 ? vtu_names::constraints : vtu_names::interfaces;
  if (const XmlElement* inner = VtuGrid::find_array(grid.field_data(), inner_facets))
    read_mixed_facets<Dim>(grid, *inner, mesh.boundary);
  return true;
}

}  // namespace

template <int Dim>
MixedMeshFile<Dim> parse_mixed_vtu(std::string_view bytes, const std::string& source) {
  const XmlElement root = parse_xml(bytes, source, "AppendedData");
  const VtuGrid grid(root, source);
  MixedSoup<Dim> soup;
  soup.source = source;
  soup.prisms_turn_either_way = true;
  if constexpr (Dim == 2) {
    soup.mesh.points = PerId<VertexId, Point2>(grid.read_plane_points());
  } else {
    soup.mesh.points = PerId<VertexId, Point3>(grid.read_points());
  }
  read_mixed_cells(grid, soup);
  soup.mesh.vertex_markers = PerId<VertexId, Marker>(grid.read_vertex_markers());
  soup.point_fields = grid.read_point_fields(soup.warnings);
  const bool knows_boundary = read_mixed_boundary(grid, soup.mesh);
  MixedMeshFile<Dim> file = assemble(std::move(soup), knows_boundary ? FacetRule::boundary_and_inner_facets
                                                                     : FacetRule::fill_in_the_boundary);
  const bool has_marker_1 = std::any_of(file.mesh.boundary.begin(), file.mesh.boundary.end(),
                                        [](const auto& facet) { return facet.marker == 1; });
  if (!knows_boundary && has_marker_1) file.mesh.marker_names.try_emplace(1, "boundary");
  return file;
}

template <int Dim>
MixedMeshFile<Dim> read_mixed_vtu(const std::filesystem::path& path) {
  return parse_mixed_vtu<Dim>(read_whole_file(path), path.string());
}

template MixedMeshFile<2> parse_mixed_vtu<2>(std::string_view, const std::string&);
template MixedMeshFile<3> parse_mixed_vtu<3>(std::string_view, const std::string&);
template MixedMeshFile<2> read_mixed_vtu<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_vtu<3>(const std::filesystem::path&);

}  // namespace leonhard::io
