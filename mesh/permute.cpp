// SPDX-License-Identifier: MIT
#include "leonhard/mesh/permute.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/edges_of_pairs.hpp"

namespace leonhard::mesh {
namespace {

/// throws  InputError, naming an entry, if new_of_old does not give each of `count` vertices a number of its own below
///         count
void check_permutation(std::size_t count, const PerId<VertexId, VertexId>& new_of_old) {
  const char* remedy = "give every vertex a new number of its own from 0 to the number of vertices - 1";
  if (new_of_old.size() != count) {
    throw InputError(
        "new_of_old",
        std::to_string(new_of_old.size()) + " entries for " + std::to_string(count) + " vertices", remedy);
  }
  PerId<VertexId, MaybeId<VertexId>> old_of_new(count);
  for (const VertexId old : new_of_old.ids()) {
    const VertexId id = new_of_old[old];
    const auto entry = [&] {
      return "vertex " + std::to_string(old.raw) + " is given the number " + std::to_string(id.raw);
    };
    if (!old_of_new.contains(id)) {
      throw InputError("new_of_old", entry() + ", but there are " + std::to_string(count) + " vertices",
                       remedy);
    }
    if (old_of_new[id]) {
      throw InputError("new_of_old",
                       entry() + ", which vertex " + std::to_string((*old_of_new[id]).raw) + " has already",
                       remedy);
    }
    old_of_new[id] = old;
  }
}

/// values[v] at its vertex's new number.
template <class T>
PerId<VertexId, T> renumbered(const PerId<VertexId, T>& values, const PerId<VertexId, VertexId>& new_of_old) {
  PerId<VertexId, T> result(values.size());
  for (const VertexId old : values.ids()) result[new_of_old[old]] = values[old];
  return result;
}

template <int Dim>
void renumber_facets(std::vector<typename Simplex<Dim>::MarkedFacet>& facets,
                     const PerId<VertexId, VertexId>& new_of_old) {
  for (auto& facet : facets) {
    auto corners = Simplex<Dim>::corners_of(facet);
    for (VertexId& v : corners) v = new_of_old[v];
    facet = Simplex<Dim>::marked(corners, facet.marker);
  }
}

/// order[new] = old number of a cell: in buckets by smallest vertex, each sorted.
template <class CellId, std::size_t count>
std::vector<CellId> order_by_vertices(const PerId<CellId, std::array<VertexId, count>>& corners,
                                      std::size_t vertices) {
  struct Entry {
    std::array<VertexId, count - 1> higher;
    CellId cell;
  };
  std::vector<std::size_t> first(vertices + 1, 0);
  for (const auto& c : corners) ++first[std::min_element(c.begin(), c.end())->index() + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Entry> entries(corners.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const CellId t : corners.ids()) {
    auto key = corners[t];
    std::sort(key.begin(), key.end());
    Entry& entry = entries[next[key[0].index()]++];
    std::copy(key.begin() + 1, key.end(), entry.higher.begin());
    entry.cell = t;
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(first[v]),
              entries.begin() + static_cast<std::ptrdiff_t>(first[v + 1]),
              [](const Entry& a, const Entry& b) {
                return a.higher != b.higher ? a.higher < b.higher : a.cell < b.cell;
              });
  }
  std::vector<CellId> old_of_new;
  old_of_new.reserve(entries.size());
  for (const Entry& entry : entries) old_of_new.push_back(entry.cell);
  return old_of_new;
}

/// The same mesh, its cells in another order; returns the new number of each old cell.
template <int Dim, class CellId>
PerId<CellId, CellId> reorder_cells(SimplexMesh<Dim>& mesh, const std::vector<CellId>& old_of_new) {
  PerId<CellId, CellId> new_of_old(mesh.cell_count());
  for (std::size_t i = 0; i < old_of_new.size(); ++i) new_of_old[old_of_new[i]] = CellId::from(i);
  decltype(mesh.corners) corners;
  decltype(mesh.neighbours) neighbours;
  decltype(mesh.regions) regions;
  corners.reserve(mesh.cell_count());
  neighbours.reserve(mesh.cell_count());
  regions.reserve(mesh.cell_count());
  for (const CellId old : old_of_new) {
    corners.push_back(mesh.corners[old]);
    regions.push_back(mesh.regions[old]);
    auto across = mesh.neighbours[old];
    for (MaybeId<CellId>& neighbour : across) {
      if (neighbour) neighbour = new_of_old[*neighbour];
    }
    neighbours.push_back(across);
  }
  mesh.corners = std::move(corners);
  mesh.neighbours = std::move(neighbours);
  mesh.regions = std::move(regions);
  return new_of_old;
}

}  // namespace

template <int Dim>
Renumbered<Dim> renumber(const SimplexMesh<Dim>& mesh, const PerId<VertexId, VertexId>& new_of_old,
                         CellOrder order) {
  check_permutation(mesh.vertex_count(), new_of_old);
  require_ids_in_range(mesh);
  Renumbered<Dim> renumbered_mesh{mesh, {}};
  SimplexMesh<Dim>& result = renumbered_mesh.mesh;
  result.points = renumbered(mesh.points, new_of_old);
  result.vertex_markers = renumbered(mesh.vertex_markers, new_of_old);
  renumber_facets<Dim>(result.boundary, new_of_old);
  renumber_facets<Dim>(result.inner_facets(), new_of_old);
  for (auto& corners : result.corners) {
    for (VertexId& v : corners) v = new_of_old[v];
  }
  if (order == CellOrder::by_smallest_vertex) {
    renumbered_mesh.new_cell =
        reorder_cells(result, order_by_vertices(result.corners, result.vertex_count()));
  } else {
    for (const auto cell : result.corners.ids()) renumbered_mesh.new_cell.push_back(cell);
  }
  return renumbered_mesh;
}

template <int Dim>
SimplexMesh<Dim> renumber_vertices(const SimplexMesh<Dim>& mesh, const PerId<VertexId, VertexId>& new_of_old,
                                   CellOrder order) {
  return renumber(mesh, new_of_old, order).mesh;
}

template <int Dim>
RenumberedMixed<Dim> renumber(const MixedMesh<Dim>& mesh, const PerId<VertexId, VertexId>& new_of_old) {
  check_permutation(mesh.vertex_count(), new_of_old);
  require_ids_in_range(mesh);
  RenumberedMixed<Dim> result{{}, PerId<CellId, CellId>(mesh.cell_count())};
  result.mesh.points = renumbered(mesh.points, new_of_old);
  result.mesh.vertex_markers = renumbered(mesh.vertex_markers, new_of_old);
  result.mesh.marker_names = mesh.marker_names;
  result.mesh.region_names = mesh.region_names;
  result.mesh.boundary = mesh.boundary;
  result.mesh.inner_facets = mesh.inner_facets;
  for (auto* facets : {&result.mesh.boundary, &result.mesh.inner_facets})
    for (auto& facet : *facets)
      for (std::size_t i = 0; i < facet.corners.size(); ++i) facet.corners[i] = new_of_old[facet.corners[i]];

  std::vector<std::pair<std::vector<VertexId>, CellId>> order;  // by ascending new vertices
  order.reserve(mesh.cell_count());
  for (const CellId cell : mesh.kinds.ids()) {
    std::vector<VertexId> corners;
    for (const VertexId v : mesh.corners_of(cell)) corners.push_back(new_of_old[v]);
    std::sort(corners.begin(), corners.end());
    order.emplace_back(std::move(corners), cell);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [sorted, old] : order) {
    std::vector<VertexId> corners;
    for (const VertexId v : mesh.corners_of(old)) corners.push_back(new_of_old[v]);
    const CellId id = result.mesh.add_cell(mesh.kinds[old], corners);
    result.mesh.regions[id] = mesh.regions[old];
    result.new_cell[old] = id;
  }
  return result;
}

template <int Dim>
MeshDual<Dim> renumber_vertices(const MeshDual<Dim>& dual, const PerId<VertexId, VertexId>& new_of_old) {
  check_permutation(dual.vertex_count(), new_of_old);
  if (!dual.span.empty()) throw InputError("dual", "has periodic sides joined", "renumber it before joining them");
  MeshDual<Dim> result;
  result.points = renumbered(dual.points, new_of_old);
  result.volume = renumbered(dual.volume, new_of_old);
  result.boundary = dual.boundary;
  result.marker_names = dual.marker_names;
  for (DualFacet<Dim>& facet : result.boundary)
    for (std::size_t i = 0; i < facet.corners.size(); ++i) facet.corners[i] = new_of_old[facet.corners[i]];
  result.edges = edges_of(dual.vertex_count(), [&](auto visit) {
    for (const auto& ends : dual.edges.ends) visit(new_of_old[ends[0]], new_of_old[ends[1]]);
  });
  result.face.resize(dual.edge_count());
  for (const EdgeId e : dual.edges.ends.ids()) {
    const VertexId a = new_of_old[dual.edges.ends[e][0]], b = new_of_old[dual.edges.ends[e][1]];
    result.face[*result.edges.find(a, b)] = a < b ? dual.face[e] : -dual.face[e];
  }
  return result;
}

template Renumbered<2> renumber(const SimplexMesh<2>&, const PerId<VertexId, VertexId>&, CellOrder);
template Renumbered<3> renumber(const SimplexMesh<3>&, const PerId<VertexId, VertexId>&, CellOrder);
template TriangleMesh renumber_vertices(const SimplexMesh<2>&, const PerId<VertexId, VertexId>&, CellOrder);
template TetMesh renumber_vertices(const SimplexMesh<3>&, const PerId<VertexId, VertexId>&, CellOrder);
template RenumberedMixed<2> renumber(const MixedMesh<2>&, const PerId<VertexId, VertexId>&);
template RenumberedMixed<3> renumber(const MixedMesh<3>&, const PerId<VertexId, VertexId>&);
template MeshDual<2> renumber_vertices(const MeshDual<2>&, const PerId<VertexId, VertexId>&);
template MeshDual<3> renumber_vertices(const MeshDual<3>&, const PerId<VertexId, VertexId>&);

}  // namespace leonhard::mesh
