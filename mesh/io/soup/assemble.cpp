// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/soup/back_to_back.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/soup/soup_cells.hpp"
#include "leonhard/mesh/io/soup/soup_checks.hpp"
#include "leonhard/mesh/io/soup/soup_vertices.hpp"
#include "leonhard/mesh/mixed_topology.hpp"
#include "leonhard/mesh/split_cells.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::io {
namespace {

/// All that can be mended before the whole is looked at.
template <int Dim>
void mend(MeshSoup<Dim>& soup, const ReadOptions& options, QuadrilateralRule rule) {
  check_soup(soup);
  if (options.weld) weld_vertices(soup, *options.weld);
  refuse_repeated_vertices(soup);
  drop_unused_vertices(soup);
  orient_cells(soup, rule);
  if (!soup.facets_as_they_are) drop_repeated_facets(soup);
}

/// The marker of boundary facets that are not listed and whose vertices share none.
template <int Dim>
Marker marker_of_unlisted(const MixedMesh<Dim>& mesh) {
  std::set<Marker> used;
  for (const auto& facet : mesh.boundary) used.insert(facet.marker);
  for (const auto& [marker, name] : mesh.marker_names) {
    if (name == unmarked) return marker;
    used.insert(marker);
  }
  Marker marker = 1;
  while (used.contains(marker)) ++marker;
  return marker;
}

const MixedFacet<2>& corners_of_facet(const MarkedMixedFacet<2>& facet) { return facet.corners; }
const MixedFacet<3>& corners_of_facet(const MarkedMixedFacet<3>& facet) { return facet.corners; }
std::array<VertexId, 2> corners_of_facet(const MarkedEdge& edge) { return Simplex<2>::corners_of(edge); }
std::array<VertexId, 3> corners_of_facet(const MarkedFace& face) { return Simplex<3>::corners_of(face); }

/// make_mesh and make_mixed_mesh have put the boundary facets that the file does not list behind those that it does.
template <int Dim, class Mesh>
void mark_unlisted(Mesh& mesh, std::size_t listed, Marker otherwise, std::vector<std::string>& warnings) {
  std::size_t shared = 0;
  for (std::size_t i = listed; i < mesh.boundary.size(); ++i) {
    const auto corners = corners_of_facet(mesh.boundary[i]);
    const Marker marker = mesh.vertex_markers[*corners.begin()];
    const bool is_shared = marker != 0 && std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
                             return mesh.vertex_markers[v] == marker;
                           });
    mesh.boundary[i].marker = is_shared ? marker : otherwise;
    if (is_shared) ++shared;
  }
  const std::size_t count = mesh.boundary.size() - listed;
  if (count == 0) return;
  std::string words = std::to_string(count) + " of " + std::to_string(mesh.boundary.size()) + " boundary " +
                      Simplex<Dim>::facet + "s have no marker in the file; ";
  if (shared > 0) words += std::to_string(shared) + " of them got the one that their vertices share, ";
  if (shared < count) {
    mesh.marker_names.try_emplace(otherwise, unmarked);
    words += (shared > 0 ? "the others " : "they got ") + std::to_string(otherwise) + ", named " + unmarked;
  }
  while (words.back() == ' ' || words.back() == ',') words.pop_back();
  warnings.push_back(std::move(words));
}

/// Boundary facets of the same corners at different vertices: the mesh falls apart where it seems to hang together.
template <int Dim, class Mesh>
void hint_at_welding(const Mesh& mesh, const ReadOptions& options, std::vector<std::string>& warnings) {
  if (options.weld) return;
  const std::size_t pairs = facets_back_to_back(mesh);
  if (pairs == 0) return;
  warnings.push_back(std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs") + " of boundary " +
                     Simplex<Dim>::facet +
                     "s lie back to back on vertices of equal places, where the mesh does not hang together; "
                     "--weld 0 joins such vertices");
}

mesh::MarkedFacetRules rules_for(Marker otherwise) {
  mesh::MarkedFacetRules rules;
  rules.take_inner_facets = true;
  rules.unlisted_boundary = otherwise;
  return rules;
}

template <int Dim>
MixedMeshFile<Dim> checked_mixed(MeshSoup<Dim>& soup, const ReadOptions& options) {
  mend(soup, options, QuadrilateralRule::convex);
  const std::size_t facets = soup.mesh.boundary.size();
  const Marker otherwise = marker_of_unlisted(soup.mesh);
  MixedMeshFile<Dim> file{mesh::make_mixed_mesh(std::move(soup.mesh), soup.source, rules_for(otherwise)),
                          std::move(soup.warnings), std::move(soup.point_fields),
                          std::move(soup.cell_fields)};
  mark_unlisted<Dim>(file.mesh, facets - file.mesh.inner_facets.size(), otherwise, file.warnings);
  if (Dim == 3 && !soup.facets_as_they_are)
    std::erase_if(file.mesh.inner_facets, [](const auto& facet) { return facet.marker == 0; });
  if constexpr (Dim == 2)
    if (const auto overlap = mesh::validate_embedding(file.mesh))
      throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                       "correct the coordinates or the cells there");
  hint_at_welding<Dim>(file.mesh, options, file.warnings);
  return file;
}

template <int Dim>
void refuse_cells_that_are_no_simplices(const MeshSoup<Dim>& soup) {
  for (const CellId cell : soup.mesh.kinds.ids())
    if (soup.mesh.kinds[cell] != simplex_kind<Dim>)
      throw InputError(place_in(soup, soup.cell_lines, cell.index()),
                       "the file has " + std::string(soup.mesh.shape(cell).names) + ": cell " +
                           std::to_string(cell.index()) + " is the first",
                       std::string("only ") + Simplex<Dim>::cells +
                           " can be taken here; leonhard convert --split makes them");
}

template <int Dim>
std::vector<typename Simplex<Dim>::MarkedFacet> simplex_facets_of(const MeshSoup<Dim>& soup) {
  std::vector<typename Simplex<Dim>::MarkedFacet> facets;
  facets.reserve(soup.mesh.boundary.size());
  for (std::size_t i = 0; i < soup.mesh.boundary.size(); ++i) {
    const auto& [corners, marker] = soup.mesh.boundary[i];
    if (corners.size() != Dim)
      throw InputError(
          place_in(soup, soup.facet_lines, i),
          marked_facet_words(soup.mesh.boundary[i]) + " has " + std::to_string(corners.size()) + " corners",
          "faces of tetrahedra have three");
    std::array<VertexId, Dim> of_simplex;
    std::copy(corners.begin(), corners.end(), of_simplex.begin());
    facets.push_back(Simplex<Dim>::marked(of_simplex, marker));
  }
  return facets;
}

/// A soup of simplices alone, mended.
template <int Dim>
SimplexMeshFile<Dim> checked_simplices(MeshSoup<Dim>& soup, const ReadOptions& options) {
  using SimplexId = typename Simplex<Dim>::CellId;
  auto facets = simplex_facets_of(soup);
  const std::size_t facet_count = facets.size();
  const Marker otherwise = marker_of_unlisted(soup.mesh);
  PerId<SimplexId, typename SimplexMesh<Dim>::CellCorners> corners(soup.mesh.cell_count());
  for (const SimplexId cell : corners.ids()) {
    const auto row = soup.mesh.corners[cell.index()];
    std::copy(row.begin(), row.end(), corners[cell].begin());
  }
  SimplexMeshFile<Dim> file;
  file.mesh = mesh::make_mesh<Dim>(std::move(soup.mesh.points), std::move(corners), std::move(facets),
                                   std::move(soup.mesh.marker_names), soup.source, rules_for(otherwise));
  file.mesh.region_names = std::move(soup.mesh.region_names);
  file.warnings = std::move(soup.warnings);
  file.point_fields = std::move(soup.point_fields);
  file.cell_fields = std::move(soup.cell_fields);
  if (!soup.mesh.regions.empty())
    file.mesh.regions = PerId<SimplexId, double>(std::move(soup.mesh.regions.flat()));
  if (!soup.mesh.vertex_markers.empty()) file.mesh.vertex_markers = std::move(soup.mesh.vertex_markers);
  mark_unlisted<Dim>(file.mesh, facet_count - file.mesh.inner_facets().size(), otherwise, file.warnings);
  if constexpr (Dim == 3)
    if (!soup.facets_as_they_are)
      std::erase_if(file.mesh.interfaces, [](const MarkedFace& face) { return face.marker == 0; });
  if (const auto overlap = mesh::validate_embedding(file.mesh))
    throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                     "correct the coordinates or the cells there");
  hint_at_welding<Dim>(file.mesh, options, file.warnings);
  return file;
}

/// Of the parts of cells, in their order.
std::vector<CellField> fields_of_parts(const std::vector<CellField>& fields,
                                       const PerId<TetId, CellId>& cell_of) {
  std::vector<CellField> result;
  for (const CellField& field : fields) {
    CellField parts{field.name, field.components, {}};
    for (const CellId cell : cell_of) {
      const auto row = field.values.begin() + static_cast<std::ptrdiff_t>(cell.index() * field.components);
      parts.values.insert(parts.values.end(), row, row + static_cast<std::ptrdiff_t>(field.components));
    }
    result.push_back(std::move(parts));
  }
  return result;
}

TetMeshFile split_into_tetrahedra(MeshSoup<3>& soup, const ReadOptions& options) {
  MixedMeshFile<3> file = checked_mixed(soup, options);
  mesh::SplitMesh<3> split = mesh::split_cells(file.mesh);
  TetMeshFile result{std::move(split.mesh), std::move(file.warnings), std::move(file.point_fields),
                     fields_of_parts(file.cell_fields, split.cell_of)};
  const std::size_t whole = file.mesh.count_of(CellKind::tetrahedron);
  result.warnings.push_back(std::to_string(file.mesh.cell_count() - whole) +
                            " cells were split into tetrahedra");
  if (const auto overlap = mesh::validate_embedding(result.mesh))
    throw InputError(soup.source, "the mesh is tangled: " + *overlap,
                     "correct the coordinates or the cells there");
  return result;
}

template <int Dim>
bool has_simplices_alone(const MeshSoup<Dim>& soup) {
  return soup.mesh.count_of(simplex_kind<Dim>) == soup.mesh.cell_count();
}

template <int Dim>
SimplexMeshFile<Dim> simplices_of(MeshSoup<Dim>& soup, const ReadOptions& options) {
  if constexpr (Dim == 3) {
    if (options.split && !has_simplices_alone(soup)) return split_into_tetrahedra(soup, options);
    refuse_cells_that_are_no_simplices(soup);
  }
  mend(soup, options, QuadrilateralRule::simple);
  if constexpr (Dim == 2) split_quadrilaterals(soup);
  return checked_simplices(soup, options);
}

/// What is done to a soup, with the soup's note added to errors.
template <int Dim, class Do>
auto with_note(MeshSoup<Dim>& soup, Do work) {
  try {
    return work();
  } catch (const InputError& error) {
    if (soup.note.empty()) throw;
    throw InputError(error.where(), error.problem(),
                     error.remedy() + (error.remedy().empty() ? "" : "; ") + soup.note);
  }
}

}  // namespace

template <int Dim>
MixedMeshFile<Dim> assemble_mixed(MeshSoup<Dim> soup, const ReadOptions& options) {
  return with_note(soup, [&] { return checked_mixed(soup, options); });
}

template <int Dim>
SimplexMeshFile<Dim> assemble_simplices(MeshSoup<Dim> soup, const ReadOptions& options) {
  return with_note(soup, [&] { return simplices_of(soup, options); });
}

template MixedMeshFile<2> assemble_mixed(MeshSoup<2>, const ReadOptions&);
template MixedMeshFile<3> assemble_mixed(MeshSoup<3>, const ReadOptions&);
template MeshFile assemble_simplices(MeshSoup<2>, const ReadOptions&);
template TetMeshFile assemble_simplices(MeshSoup<3>, const ReadOptions&);

}  // namespace leonhard::io
