// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/gmsh.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/field_checks.hpp"
#include "leonhard/mesh/io/formats/gmsh_data.hpp"
#include "leonhard/mesh/io/formats/gmsh_soup.hpp"
#include "leonhard/mesh/io/formats/gmsh_write.hpp"
#include "leonhard/mesh/io/formats/surface_write.hpp"
#include "leonhard/mesh/io/formats/whole_regions.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

// ---- reading ----

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Values in the order of vertices or cells; none if some have no value.
///
/// has  rows that need no value
template <class Field, class IndexOf>
std::optional<Field> dense_field(const GmshValues& from, std::vector<bool> has, const IndexOf& index_of) {
  Field field{from.name, from.components, std::vector<double>(has.size() * from.components)};
  for (std::size_t i = 0; i < from.rows.size(); ++i) {
    const std::size_t row = index_of(from.rows[i]);
    if (row == none) continue;
    has[row] = true;
    std::copy_n(from.values.begin() + static_cast<std::ptrdiff_t>(i * from.components), from.components,
                field.values.begin() + static_cast<std::ptrdiff_t>(row * from.components));
  }
  if (std::find(has.begin(), has.end(), false) != has.end()) return std::nullopt;
  return field;
}

/// The file's values as fields of a soup; those that it cannot have a warning tells.
///
/// used   points that cells of the soup use: the others need no value
/// cells  those of the soup, in its order
template <class Soup>
void take_fields(GmshData& data, const std::vector<bool>& used, const std::vector<GmshCell>& cells,
                 Soup& soup) {
  std::vector<std::pair<std::uint64_t, std::size_t>> cell_of_tag;
  if (!data.values.empty()) {
    for (const GmshCell& cell : cells) cell_of_tag.emplace_back(cell.tag, cell_of_tag.size());
    std::sort(cell_of_tag.begin(), cell_of_tag.end());
  }
  const auto vertex = [](std::uint64_t row) { return row; };
  const auto cell = [&](std::uint64_t tag) {
    const auto found =
        std::lower_bound(cell_of_tag.begin(), cell_of_tag.end(), std::pair(tag, std::size_t{0}));
    return found != cell_of_tag.end() && found->first == tag ? found->second : none;
  };
  std::set<std::pair<bool, std::string>> names;
  for (const GmshValues& from : data.values) {
    const auto leave_out = [&](const char* reason) {
      data.warnings.push_back(std::string("values of ") + (from.of_nodes ? "nodes " : "elements ") +
                              in_quotes(from.name) + " were left out: " + reason);
    };
    if (from.name.empty()) {
      leave_out("they have no name");
    } else if (!names.emplace(from.of_nodes, from.name).second) {
      leave_out("others have this name");
    } else if (from.of_nodes) {
      std::vector<bool> unused = used;
      unused.flip();
      auto field = dense_field<PointField>(from, std::move(unused), vertex);
      field ? soup.point_fields.push_back(std::move(*field)) : leave_out("not every vertex has one");
    } else {
      auto field = dense_field<CellField>(from, std::vector<bool>(cell_of_tag.size(), false), cell);
      field ? soup.cell_fields.push_back(std::move(*field)) : leave_out("not every cell has one");
    }
  }
}

/// Names of the groups of one dimension.
std::map<Marker, std::string> names_of_groups(const GmshData& data, int dimension) {
  std::map<Marker, std::string> names;
  for (const auto& [group, name] : data.names)
    if (group.first == dimension) names.emplace(group.second, name);
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

/// Cells of several kinds, by their numbers in the file if they have different ones.
struct KindedCells {
  std::vector<GmshCell> cells;
  std::vector<CellKind> kinds;

  explicit KindedCells(std::initializer_list<std::pair<CellKind, const std::vector<GmshCell>*>> lists) {
    std::vector<std::pair<CellKind, const GmshCell*>> all;
    for (const auto& [kind, list] : lists)
      for (const GmshCell& cell : *list) all.emplace_back(kind, &cell);
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.second->tag < b.second->tag; });
    for (const auto& [kind, cell] : all) kinds.push_back(kind), cells.push_back(*cell);
  }
};

template <int Dim>
KindedCells cells_of_dimension(const GmshData& data) {
  if constexpr (Dim == 2) {
    return KindedCells(
        {{CellKind::triangle, &data.triangles}, {CellKind::quadrilateral, &data.quadrilaterals}});
  } else {
    return KindedCells({{CellKind::tetrahedron, &data.tetrahedra},
                        {CellKind::hexahedron, &data.hexahedra},
                        {CellKind::prism, &data.prisms},
                        {CellKind::pyramid, &data.pyramids}});
  }
}

void refuse_cells_of_space(const GmshData& data, const std::string& source) {
  for (const auto* list : {&data.tetrahedra, &data.hexahedra, &data.prisms, &data.pyramids})
    if (!list->empty()) throw InputError(source, "the file has cells of space", "give a mesh of the plane");
}

// ---- writing ----

Marker checked_group(Marker marker) {
  if (marker < 0)
    throw InputError("marker " + std::to_string(marker),
                     "is negative, and Gmsh takes the sign for a direction",
                     "number markers from 0: leonhard convert --renumber-markers does");
  return marker;
}

bool fits_into_quotes(const std::string& name) {
  return std::none_of(name.begin(), name.end(),
                      [](char c) { return c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

void add_names(GmshData& data, const std::map<Marker, std::string>& names, int dimension) {
  for (const auto& [marker, name] : names) {
    if (!fits_into_quotes(name))
      throw InputError("marker " + std::to_string(marker),
                       "its name " + in_quotes(name) + " holds a quotation mark or a control character",
                       "choose a name that a .msh file can hold");
    data.names.emplace(std::pair(dimension, checked_group(marker)), name);
  }
}

/// The fields of vertices or of cells, the first of which has the tag `first`; Gmsh knows 1, 3 and 9 components.
template <class Field>
void add_fields(GmshData& data, const std::vector<Field>& fields, std::size_t count, std::size_t first) {
  check_fields(fields, count, {});
  for (const Field& field : fields) {
    const std::size_t n = field.components, written = n == 2 ? 3 : n;
    if (!fits_into_quotes(field.name) || (written != 1 && written != 3 && written != 9))
      throw InputError("field " + in_quotes(field.name),
                       written != 1 && written != 3 && written != 9
                           ? "it has " + std::to_string(n) + " components, and Gmsh knows 1, 3 and 9"
                           : "its name holds a quotation mark or a control character",
                       "change it, or write a .vtu file");
    GmshValues values{std::is_same_v<Field, PointField>, field.name, written, {}, {}};
    for (std::size_t i = 0; i < count; ++i) {
      values.rows.push_back(first + i);
      const auto row = field.values.begin() + static_cast<std::ptrdiff_t>(i * n);
      values.values.insert(values.values.end(), row, row + static_cast<std::ptrdiff_t>(n));
      values.values.resize((i + 1) * written);
    }
    data.values.push_back(std::move(values));
  }
}

template <class Corners>
GmshCell cell_of(const Corners& corners, Marker group) {
  GmshCell cell{};
  cell.group = group;
  std::copy(corners.begin(), corners.end(), cell.corners.begin());
  return cell;
}

Point3 node_of(Point2 p) { return {p.x, p.y, 0}; }
const Point3& node_of(const Point3& p) { return p; }

/// A number that no group of a dimension has, for cells without one.
Marker free_group(const GmshData& data, const std::set<Marker>& used, int dimension) {
  Marker group = 1;
  while (used.contains(group) || data.names.contains({dimension, group})) ++group;
  return group;
}

/// Gmsh drops elements in no group when it saves a mesh: those of dimension Dim - 1 and Dim that have none get one.
void group_the_ungrouped(GmshData& data, int dimension_of_cells) {
  const std::array<std::pair<int, std::vector<GmshCell>*>, 7> lists{{{1, &data.lines},
                                                                     {2, &data.triangles},
                                                                     {2, &data.quadrilaterals},
                                                                     {3, &data.tetrahedra},
                                                                     {3, &data.hexahedra},
                                                                     {3, &data.prisms},
                                                                     {3, &data.pyramids}}};
  for (const int dimension : {dimension_of_cells - 1, dimension_of_cells}) {
    std::set<Marker> used;
    for (const auto& [of_list, list] : lists)
      if (of_list == dimension)
        for (const GmshCell& cell : *list) used.insert(cell.group);
    if (!used.contains(0)) continue;
    const Marker group = free_group(data, used, dimension);
    data.names.emplace(std::pair(dimension, group), gmsh_name_of_none(dimension == dimension_of_cells));
    for (const auto& [of_list, list] : lists)
      if (of_list == dimension)
        for (GmshCell& cell : *list)
          if (cell.group == 0) cell.group = group;
  }
}

template <int Dim>
GmshData data_of(const SimplexMesh<Dim>& mesh) {
  GmshData data;
  for (const auto& p : mesh.points) data.points.push_back(node_of(p));
  add_names(data, mesh.marker_names, Dim - 1);
  add_names(data, mesh.region_names, Dim);
  for (const auto* facets : {&mesh.boundary, &mesh.inner_facets()})
    for (const auto& facet : *facets)
      (Dim == 2 ? data.lines : data.triangles)
          .push_back(cell_of(Simplex<Dim>::corners_of(facet), checked_group(facet.marker)));
  const std::vector<Marker> regions = whole_regions(mesh.regions, 0);
  for (const auto t : mesh.corners.ids())
    (Dim == 2 ? data.triangles : data.tetrahedra)
        .push_back(cell_of(mesh.corners[t], regions.empty() ? 0 : regions[t.index()]));
  group_the_ungrouped(data, Dim);
  return data;
}

std::vector<GmshCell>& list_of_kind(GmshData& data, CellKind kind) {
  switch (kind) {
    case CellKind::triangle:
      return data.triangles;
    case CellKind::quadrilateral:
      return data.quadrilaterals;
    case CellKind::tetrahedron:
      return data.tetrahedra;
    case CellKind::pyramid:
      return data.pyramids;
    case CellKind::prism:
      return data.prisms;
    case CellKind::hexahedron:
      break;
  }
  return data.hexahedra;
}

/// Numbers tell the mesh's order of cells of different kinds.
template <int Dim>
GmshData data_of(const MixedMesh<Dim>& mesh) {
  mesh::require_ids_in_range(mesh);
  GmshData data;
  for (const auto& p : mesh.points) data.points.push_back(node_of(p));
  add_names(data, mesh.marker_names, Dim - 1);
  add_names(data, mesh.region_names, Dim);
  std::uint64_t number = 0;
  const auto add = [&](std::vector<GmshCell>& list, const auto& corners, Marker group) {
    list.push_back(cell_of(corners, group));
    list.back().tag = ++number;
  };
  for (const auto* facets : {&mesh.boundary, &mesh.inner_facets})
    for (const auto& [corners, marker] : *facets)
      add(Dim == 2              ? data.lines
          : corners.size() == 3 ? data.triangles
                                : data.quadrilaterals,
          corners, checked_group(marker));
  const std::vector<Marker> regions = whole_regions(mesh.regions, 0);
  for (const CellId cell : mesh.kinds.ids())
    add(list_of_kind(data, mesh.kinds[cell]), mesh.corners_of(cell), regions[cell.index()]);
  group_the_ungrouped(data, Dim);
  return data;
}

}  // namespace

template <int Dim>
MeshSoup<Dim> gmsh_soup(GmshData&& data, const std::string& source) {
  if constexpr (Dim == 2) {
    refuse_cells_of_space(data, source);
    refuse_points_off_the_plane(data.points, source);
  }
  MeshSoup<Dim> soup;
  soup.source = source;
  soup.note = note;
  const KindedCells cells = cells_of_dimension<Dim>(data);
  std::vector<bool> used(data.points.size(), false);
  for (std::size_t c = 0; c < cells.cells.size(); ++c) {
    const GmshCell& cell = cells.cells[c];
    const auto corners = std::span(cell.corners).first(shape_of(cells.kinds[c]).corner_count);
    for (const VertexId v : corners) used[v.index()] = true;
    soup.mesh.regions[soup.add_cell(cells.kinds[c], corners, cell.line)] = cell.group;
  }
  take_fields(data, used, cells.cells, soup);
  soup.mesh.marker_names = names_of_groups(data, Dim - 1);
  soup.mesh.region_names = names_of_groups(data, Dim);
  if constexpr (Dim == 2) {
    for (const GmshCell& line : data.lines)
      soup.add_facet(std::span(line.corners).first(2), line.group, line.line);
    for (const Point3& p : data.points) soup.mesh.points.push_back({p.x, p.y});
  } else {
    const KindedCells faces = cells_of_dimension<2>(data);
    for (std::size_t f = 0; f < faces.cells.size(); ++f)
      soup.add_facet(std::span(faces.cells[f].corners).first(shape_of(faces.kinds[f]).corner_count),
                     faces.cells[f].group, faces.cells[f].line);
    soup.mesh.points = PerId<VertexId, Point3>(std::move(data.points));
  }
  soup.warnings = std::move(data.warnings);
  return soup;
}

std::string format_gmsh_surface(const SurfaceFile& surface) {
  GmshData data;
  data.points = surface.set.points;
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const auto polygon = surface.polygon(i);
    if (polygon.size() != 3 && polygon.size() != 4)
      throw InputError("polygon " + std::to_string(i),
                       "it has " + std::to_string(polygon.size()) + " corners",
                       "a .msh of ours has triangles and quadrilaterals; write .off, .obj, .ply or .stl");
    auto& list = polygon.size() == 3 ? data.triangles : data.quadrilaterals;
    list.push_back(cell_of(polygon, surface.markers.empty() ? 0 : checked_group(surface.markers[i])));
    list.back().tag = i + 1;
  }
  group_the_ungrouped(data, 3);
  return format_gmsh_data(data, {GmshVersion::v4_1, false});
}

int dimension_of(const GmshData& data) {
  for (const auto* list : {&data.tetrahedra, &data.hexahedra, &data.prisms, &data.pyramids})
    if (!list->empty()) return 3;
  return std::all_of(data.points.begin(), data.points.end(),
                     [&](const Point3& p) { return p.z == data.points[0].z; })
             ? 2
             : 3;
}

template MeshSoup<2> gmsh_soup(GmshData&&, const std::string&);
template MeshSoup<3> gmsh_soup(GmshData&&, const std::string&);

TetMeshFile parse_tet_gmsh(std::string_view bytes, const std::string& source) {
  return assemble_simplices(gmsh_soup<3>(parse_gmsh_data(bytes, source), source));
}
MeshFile parse_gmsh(std::string_view bytes, const std::string& source) {
  return assemble_simplices(gmsh_soup<2>(parse_gmsh_data(bytes, source), source));
}
template <int Dim>
MixedMeshFile<Dim> parse_mixed_gmsh(std::string_view bytes, const std::string& source) {
  return assemble_mixed(gmsh_soup<Dim>(parse_gmsh_data(bytes, source), source));
}
template <int Dim>
MixedMeshFile<Dim> read_mixed_gmsh(const std::filesystem::path& path) {
  return parse_mixed_gmsh<Dim>(read_whole_file(path), path.string());
}

template MixedMeshFile<2> parse_mixed_gmsh<2>(std::string_view, const std::string&);
template MixedMeshFile<3> parse_mixed_gmsh<3>(std::string_view, const std::string&);
template MixedMeshFile<2> read_mixed_gmsh<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_gmsh<3>(const std::filesystem::path&);

TetMeshFile read_tet_gmsh(const std::filesystem::path& path) {
  return parse_tet_gmsh(read_whole_file(path), path.string());
}
MeshFile read_gmsh(const std::filesystem::path& path) {
  return parse_gmsh(read_whole_file(path), path.string());
}

namespace {

template <int Dim>
std::size_t inner_facet_count(const SimplexMesh<Dim>& mesh) {
  return mesh.inner_facets().size();
}
template <int Dim>
std::size_t inner_facet_count(const MixedMesh<Dim>& mesh) {
  return mesh.inner_facets.size();
}

/// Cells are numbered from 1, those of the boundary and inside it first.
template <class Mesh>
std::string format(const Mesh& mesh, const GmshForm& form, const std::vector<PointField>& point_fields,
                   const std::vector<CellField>& cell_fields) {
  GmshData data = data_of(mesh);
  const std::size_t facets = mesh.boundary.size() + inner_facet_count(mesh);
  add_fields(data, point_fields, mesh.vertex_count(), 0);
  add_fields(data, cell_fields, mesh.cell_count(), facets + 1);
  return format_gmsh_data(data, form);
}

}  // namespace

std::string format_gmsh(const TetMesh& mesh, const GmshForm& form,
                        const std::vector<PointField>& point_fields,
                        const std::vector<CellField>& cell_fields) {
  return format(mesh, form, point_fields, cell_fields);
}
std::string format_gmsh(const TriangleMesh& mesh, const GmshForm& form,
                        const std::vector<PointField>& point_fields,
                        const std::vector<CellField>& cell_fields) {
  return format(mesh, form, point_fields, cell_fields);
}

void write_gmsh(const std::filesystem::path& path, const TetMesh& mesh, const GmshForm& form,
                const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format(mesh, form, point_fields, cell_fields));
}
void write_gmsh(const std::filesystem::path& path, const TriangleMesh& mesh, const GmshForm& form,
                const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format(mesh, form, point_fields, cell_fields));
}

std::string format_gmsh(const MixedMesh<2>& mesh, const GmshForm& form,
                        const std::vector<PointField>& point_fields,
                        const std::vector<CellField>& cell_fields) {
  return format(mesh, form, point_fields, cell_fields);
}
void write_gmsh(const std::filesystem::path& path, const MixedMesh<2>& mesh, const GmshForm& form,
                const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format(mesh, form, point_fields, cell_fields));
}
std::string format_gmsh(const MixedMesh<3>& mesh, const GmshForm& form,
                        const std::vector<PointField>& point_fields,
                        const std::vector<CellField>& cell_fields) {
  return format(mesh, form, point_fields, cell_fields);
}
void write_gmsh(const std::filesystem::path& path, const MixedMesh<3>& mesh, const GmshForm& form,
                const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  write_file_atomically(path, format(mesh, form, point_fields, cell_fields));
}

}  // namespace leonhard::io
