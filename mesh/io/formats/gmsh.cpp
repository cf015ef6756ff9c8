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
#include "leonhard/mesh/io/soup/cell_soup.hpp"
#include "leonhard/mesh/io/soup/tet_soup.hpp"
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

TetSoup tet_soup_of(GmshData& data, const std::string& source) {
  TetSoup soup;
  soup.source = source;
  soup.note = note;
  soup.marker_names = marker_names_of(data, 2);
  soup.points = PerId<VertexId, Point3>(std::move(data.points));
  for (const GmshCell& cell : data.tetrahedra) {
    soup.cells.push_back({cell.corners, cell.line});
    soup.cell_regions.push_back(cell.group);
  }
  for (const GmshCell& face : data.triangles)
    soup.faces.push_back({{face.corners[0], face.corners[1], face.corners[2]}, face.group, face.line});
  return soup;
}

void refuse_points_off_the_plane(const std::vector<Point3>& points, const std::string& source) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].z != points[0].z)
      throw InputError(source,
                       "node " + std::to_string(i) + " (from 0) is at " + mesh::words(points[i]) +
                           ", off the plane z = " + mesh::words(points[0].z) + " of the first",
                       "only meshes in a plane z = const can be read as triangle meshes");
}

CellSoup cell_soup_of(GmshData& data, const std::string& source) {
  CellSoup soup;
  soup.source = source;
  soup.note = note;
  soup.marker_names = marker_names_of(data, 1);
  for (const Point3& p : data.points) soup.points.push_back({p.x, p.y});
  const auto add = [&](const std::vector<GmshCell>& cells, std::uint32_t corners) {
    for (const GmshCell& cell : cells) {
      soup.cells.push_back({cell.corners, corners, cell.line});
      soup.cell_regions.push_back(cell.group);
    }
  };
  add(data.triangles, 3);
  add(data.quadrilaterals, 4);
  for (const GmshCell& edge : data.lines)
    soup.edges.push_back({edge.corners[0], edge.corners[1], edge.group});
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

GmshData data_of(const TetMesh& mesh) {
  GmshData data;
  data.points = mesh.points.flat();
  add_names(data, mesh.marker_names, 2);
  for (const std::vector<MarkedFace>* faces : {&mesh.boundary, &mesh.interfaces})
    for (const MarkedFace& face : *faces)
      data.triangles.push_back(
          {{face.corners[0], face.corners[1], face.corners[2]}, checked_group(face.marker)});
  const std::vector<Marker> regions = whole_regions(mesh.regions, 0);
  for (const TetId t : mesh.corners.ids())
    data.tetrahedra.push_back({mesh.corners[t], regions.empty() ? 0 : regions[t.index()]});
  return data;
}

GmshData data_of(const TriangleMesh& mesh) {
  GmshData data;
  for (const Point2 p : mesh.points) data.points.push_back({p.x, p.y, 0});
  add_names(data, mesh.marker_names, 1);
  for (const std::vector<MarkedEdge>* edges : {&mesh.boundary, &mesh.constraints})
    for (const MarkedEdge& edge : *edges)
      data.lines.push_back({{edge.from, edge.to}, checked_group(edge.marker)});
  const std::vector<Marker> regions = whole_regions(mesh.regions, 0);
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& c = mesh.corners[t];
    data.triangles.push_back({{c[0], c[1], c[2]}, regions.empty() ? 0 : regions[t.index()]});
  }
  return data;
}

}  // namespace

TetMeshFile parse_tet_gmsh(std::string_view bytes, const std::string& source) {
  GmshData data = parse_gmsh_data(bytes, source);
  if (!data.quadrilaterals.empty())
    throw InputError(source, "the file has quadrilaterals", "a tetrahedral mesh has none");
  drop_unused_nodes(data, {{&data.tetrahedra, 4}, {&data.triangles, 3}});
  TetSoup soup = tet_soup_of(data, source);
  return with_warnings(assemble(std::move(soup), FaceRule::fill_in_the_boundary), data.warnings);
}

MeshFile parse_gmsh(std::string_view bytes, const std::string& source) {
  GmshData data = parse_gmsh_data(bytes, source);
  if (!data.tetrahedra.empty())
    throw InputError(source, "the file has tetrahedra: it is a mesh of space", "give a mesh of triangles");
  drop_unused_nodes(data, {{&data.triangles, 3}, {&data.quadrilaterals, 4}, {&data.lines, 2}});
  refuse_points_off_the_plane(data.points, source);
  CellSoup soup = cell_soup_of(data, source);
  return with_warnings(assemble(std::move(soup), EdgeRule::fill_in_the_boundary), data.warnings);
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
