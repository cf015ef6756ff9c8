// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/gmsh.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/formats/gmsh_write.hpp"
#include "leonhard/mesh/io/formats/whole_regions.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

// ---- reading ----

/// Lists of cells whose nodes count as used, and how many corners each has.
using Lists = std::vector<std::pair<std::vector<GmshCell>*, std::size_t>>;

/// Drops the nodes that no cell of the lists uses and renumbers the others; files keep the nodes of the geometry.
void drop_unused_nodes(GmshData& data, const Lists& lists) {
  std::vector<bool> used(data.points.size(), false);
  for (const auto& [cells, corners] : lists)
    for (const GmshCell& cell : *cells)
      for (std::size_t k = 0; k < corners; ++k) used[cell.corners[k].index()] = true;
  const auto kept = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  if (kept == data.points.size() || kept == 0) return;  // without cells there is more to say than that
  data.warnings.push_back(std::to_string(data.points.size() - kept) +
                          " nodes that no cell uses were left out, and the others renumbered");
  std::vector<VertexId> new_id(data.points.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    new_id[i] = VertexId::from(next);
    data.points[next++] = data.points[i];
  }
  data.points.resize(next);
  for (const auto& [cells, corners] : lists)
    for (GmshCell& cell : *cells)
      for (std::size_t k = 0; k < corners; ++k) cell.corners[k] = new_id[cell.corners[k].index()];
}

/// Names of the groups of one dimension; those of others have no place in a mesh, which a warning tells.
std::map<Marker, std::string> marker_names_of(GmshData& data, int dimension) {
  std::map<Marker, std::string> names;
  std::string lost;
  for (auto& [group, name] : data.names) {
    if (group.first == dimension) {
      names.emplace(group.second, std::move(name));
    } else if (group.first == dimension + 1) {
      lost += (lost.empty() ? "" : ", ") + std::to_string(group.second) + " \"" + name + "\"";
    }
  }
  if (!lost.empty()) data.warnings.push_back("names of regions have no place in a mesh: " + lost);
  return names;
}

/// Ids are no longer the file's numbers.
constexpr const char* note = "here vertices are numbered from 0 in the order of the file's nodes";

void refuse_points_off_the_plane(const std::vector<Point3>& points, const std::string& source) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].z != points[0].z)
      throw InputError(source,
                       "node " + std::to_string(i) + " (from 0) is at " + mesh::words(points[i]) +
                           ", off the plane z = " + mesh::words(points[0].z) + " of the first",
                       "only meshes in a plane z = const can be read as triangle meshes");
}

/// data.points is left to the caller.
template <int Dim>
MeshSoup<Dim> soup_of(GmshData& data, const std::string& source) {
  MeshSoup<Dim> soup;
  soup.source = source;
  soup.note = note;
  soup.marker_names = marker_names_of(data, Dim - 1);
  const auto add_cells = [&](const std::vector<GmshCell>& cells, std::uint32_t corners) {
    for (const GmshCell& cell : cells) {
      soup.cells.push_back({cell.corners, corners, cell.line});
      soup.cell_regions.push_back(cell.group);
    }
  };
  if (Dim == 2) add_cells(data.triangles, 3), add_cells(data.quadrilaterals, 4);
  if (Dim == 3) add_cells(data.tetrahedra, 4);
  for (const GmshCell& facet : Dim == 2 ? data.lines : data.triangles) {
    soup.facets.push_back({{}, facet.group, facet.line});
    std::copy_n(facet.corners.begin(), Dim, soup.facets.back().corners.begin());
  }
  return soup;
}

template <class File>
File with_warnings(File file, const std::vector<std::string>& first) {
  file.warnings.insert(file.warnings.begin(), first.begin(), first.end());
  return file;
}

// ---- writing ----

Marker checked_group(Marker marker) {
  if (marker < 0)
    throw InputError("marker " + std::to_string(marker),
                     "is negative, and Gmsh takes the sign for a direction", "number markers from 0");
  return marker;
}

void add_names(GmshData& data, const std::map<Marker, std::string>& names, int dimension) {
  for (const auto& [marker, name] : names) {
    const bool is_plain = std::none_of(name.begin(), name.end(), [](char c) {
      return c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    });
    if (!is_plain)
      throw InputError("marker " + std::to_string(marker),
                       "its name " + in_quotes(name) + " holds a quotation mark or a control character",
                       "choose a name that a .msh file can hold");
    data.names.emplace(std::pair(dimension, checked_group(marker)), name);
  }
}

template <std::size_t count>
GmshCell cell_of(const std::array<VertexId, count>& corners, Marker group) {
  GmshCell cell{{}, group};
  std::copy(corners.begin(), corners.end(), cell.corners.begin());
  return cell;
}

Point3 in_space(Point2 p) { return {p.x, p.y, 0}; }
const Point3& in_space(const Point3& p) { return p; }

template <int Dim>
GmshData data_of(const SimplexMesh<Dim>& mesh) {
  GmshData data;
  for (const auto& p : mesh.points) data.points.push_back(in_space(p));
  add_names(data, mesh.marker_names, Dim - 1);
  for (const auto* facets : {&mesh.boundary, &mesh.inner_facets()})
    for (const auto& facet : *facets)
      (Dim == 2 ? data.lines : data.triangles)
          .push_back(cell_of(Simplex<Dim>::corners_of(facet), checked_group(facet.marker)));
  const std::vector<Marker> regions = whole_regions(mesh.regions, 0);
  for (const auto t : mesh.corners.ids())
    (Dim == 2 ? data.triangles : data.tetrahedra)
        .push_back(cell_of(mesh.corners[t], regions.empty() ? 0 : regions[t.index()]));
  return data;
}

}  // namespace

TetMeshFile parse_tet_gmsh(std::string_view bytes, const std::string& source) {
  GmshData data = parse_gmsh_data(bytes, source);
  if (!data.quadrilaterals.empty())
    throw InputError(source, "the file has quadrilaterals", "a tetrahedral mesh has none");
  drop_unused_nodes(data, {{&data.tetrahedra, 4}, {&data.triangles, 3}});
  MeshSoup<3> soup = soup_of<3>(data, source);
  soup.points = PerId<VertexId, Point3>(std::move(data.points));
  return with_warnings(assemble(std::move(soup), FacetRule::fill_in_the_boundary), data.warnings);
}

MeshFile parse_gmsh(std::string_view bytes, const std::string& source) {
  GmshData data = parse_gmsh_data(bytes, source);
  if (!data.tetrahedra.empty())
    throw InputError(source, "the file has tetrahedra: it is a mesh of space", "give a mesh of triangles");
  drop_unused_nodes(data, {{&data.triangles, 3}, {&data.quadrilaterals, 4}, {&data.lines, 2}});
  refuse_points_off_the_plane(data.points, source);
  MeshSoup<2> soup = soup_of<2>(data, source);
  for (const Point3& p : data.points) soup.points.push_back({p.x, p.y});
  return with_warnings(assemble(std::move(soup), FacetRule::fill_in_the_boundary), data.warnings);
}

TetMeshFile read_tet_gmsh(const std::filesystem::path& path) {
  return parse_tet_gmsh(read_whole_file(path), path.string());
}
MeshFile read_gmsh(const std::filesystem::path& path) {
  return parse_gmsh(read_whole_file(path), path.string());
}

std::string format_gmsh(const TetMesh& mesh, const GmshForm& form) {
  return format_gmsh_data(data_of(mesh), form);
}
std::string format_gmsh(const TriangleMesh& mesh, const GmshForm& form) {
  return format_gmsh_data(data_of(mesh), form);
}

void write_gmsh(const std::filesystem::path& path, const TetMesh& mesh, const GmshForm& form) {
  write_file_atomically(path, format_gmsh(mesh, form));
}
void write_gmsh(const std::filesystem::path& path, const TriangleMesh& mesh, const GmshForm& form) {
  write_file_atomically(path, format_gmsh(mesh, form));
}

}  // namespace leonhard::io
