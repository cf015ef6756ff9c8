// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/invariants.hpp"

#include <algorithm>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

/// What is said of a cell or of a facet that is listed, by dimension.
template <int Dim>
struct Verdicts;
template <>
struct Verdicts<2> {
  static constexpr const char *flat = " has area zero", *negative = " is clockwise: its area is negative",
                              *inwards = " has the mesh on its right", *inner_list = "constraints",
                              *not_inner = " is no interior edge of the mesh";
};
template <>
struct Verdicts<3> {
  static constexpr const char *flat = " has volume zero",
                              *negative = " is turned over: its volume is negative",
                              *inwards = " has a normal that points into the mesh",
                              *inner_list = "interfaces", *not_inner = " does not lie between two tetrahedra";
};

Sign orientation(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  return kernel::orient2d(mesh.points[a], mesh.points[b], mesh.points[c]);
}

Sign orientation(const TetMesh& mesh, TetId t) {
  const auto& [a, b, c, d] = mesh.corners[t];
  return kernel::orient3d(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
}

template <int Dim>
std::string neighbour_words(const SimplexMesh<Dim>&, MaybeId<typename Simplex<Dim>::CellId> t) {
  return t ? Simplex<Dim>::cell + (" " + std::to_string((*t).raw)) : std::string("none");
}

template <int Dim>
std::string entry_words(const SimplexMesh<Dim>& mesh, const char* array, std::size_t entry,
                        const typename Simplex<Dim>::MarkedFacet& facet) {
  return std::string(array) + " entry " + std::to_string(entry) + ", " +
         words(mesh, Simplex<Dim>::corners_of(facet)) + ", marker " + std::to_string(facet.marker) + ",";
}

}  // namespace

template <int Dim>
std::optional<std::string> broken_sizes(const SimplexMesh<Dim>& mesh) {
  const auto unlike = [](const char* array, std::size_t size, const char* of, std::size_t count) {
    return std::string(array) + " has " + std::to_string(size) + " entries for " + std::to_string(count) +
           " " + of;
  };
  const char* cells = Simplex<Dim>::cells;
  const std::size_t v = mesh.points.size(), t = mesh.corners.size();
  if (mesh.neighbours.size() != t) return unlike("neighbours", mesh.neighbours.size(), cells, t);
  if (mesh.regions.size() != t) return unlike("regions", mesh.regions.size(), cells, t);
  if (mesh.vertex_markers.size() != v)
    return unlike("vertex_markers", mesh.vertex_markers.size(), "vertices", v);
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_point(const SimplexMesh<Dim>& mesh) {
  for (const VertexId v : mesh.points.ids()) {
    if (!is_finite(mesh.points[v])) return words(mesh, v) + " has a coordinate that is no finite number";
  }
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_corner(const SimplexMesh<Dim>& mesh) {
  for (const auto t : mesh.corners.ids()) {
    const auto& corners = mesh.corners[t];
    for (auto corner = corners.begin(); corner != corners.end(); ++corner) {
      if (!mesh.points.contains(*corner)) {
        return "vertex " + std::to_string((*corner).raw) + " of " + words(mesh, t) +
               " does not exist, there are " + std::to_string(mesh.vertex_count()) + " vertices";
      }
      if (std::find(corners.begin(), corner, *corner) != corner)
        return words(mesh, t) + " has a vertex twice";
    }
  }
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> unused_vertex(const SimplexMesh<Dim>& mesh) {
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) used[v] = 1;
  }
  for (const VertexId v : used.ids()) {
    if (!used[v]) return words(mesh, v) + " belongs to no " + Simplex<Dim>::cell;
  }
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_orientation(const SimplexMesh<Dim>& mesh) {
  for (const auto t : mesh.corners.ids()) {
    const Sign sign = orientation(mesh, t);
    if (sign == Sign::zero) return words(mesh, t) + Verdicts<Dim>::flat;
    if (sign == Sign::negative) return words(mesh, t) + Verdicts<Dim>::negative;
  }
  return std::nullopt;
}

template <int Dim>
std::optional<std::string> broken_neighbour(const SimplexMesh<Dim>& mesh, const HalfFacetTable<Dim>& table) {
  const auto truth = neighbours_of(mesh, table);
  for (const auto t : mesh.corners.ids()) {
    for (std::size_t i = 0; i <= Dim; ++i) {
      if (mesh.neighbours[t][i] == truth[t][i]) continue;
      return words(mesh, t) + " names " + neighbour_words(mesh, mesh.neighbours[t][i]) + " as neighbour " +
             std::to_string(i) + ", but behind " + words(mesh, outward_facet(mesh.corners[t], i)) +
             " there is " + neighbour_words(mesh, truth[t][i]);
    }
  }
  return std::nullopt;
}

template <int Dim>
BoundaryFacets<Dim>::BoundaryFacets(const SimplexMesh<Dim>& mesh) {
  for (const auto t : mesh.neighbours.ids()) {
    for (std::uint8_t side = 0; side <= Dim; ++side) {
      if (!mesh.neighbours[t][side])
        facets_.push_back({sorted_facet(outward_facet(mesh.corners[t], side)), t, side});
    }
  }
  std::sort(facets_.begin(), facets_.end(),
            [](const Facet& a, const Facet& b) { return a.sorted.corners < b.sorted.corners; });
}

template <int Dim>
std::optional<std::size_t> BoundaryFacets<Dim>::find(const std::array<VertexId, Dim>& ascending) const {
  const auto at = std::partition_point(facets_.begin(), facets_.end(),
                                       [&](const Facet& f) { return f.sorted.corners < ascending; });
  if (at == facets_.end() || at->sorted.corners != ascending) return std::nullopt;
  return static_cast<std::size_t>(at - facets_.begin());
}

template <int Dim>
std::optional<std::string> broken_boundary(const SimplexMesh<Dim>& mesh, const BoundaryFacets<Dim>& facets) {
  using Kind = Simplex<Dim>;
  constexpr std::size_t never = static_cast<std::size_t>(-1);
  std::vector<std::size_t> listed_as(facets.facets().size(), never);
  for (std::size_t entry = 0; entry < mesh.boundary.size(); ++entry) {
    const auto said = [&] { return entry_words(mesh, "boundary", entry, mesh.boundary[entry]); };
    const SortedFacet<Dim> sorted = sorted_facet(Kind::corners_of(mesh.boundary[entry]));
    const auto at = facets.find(sorted.corners);
    if (!at) return said() + " is no boundary " + Kind::facet + " of the mesh";
    if (facets.facets()[*at].sorted.even != sorted.even) return said() + Verdicts<Dim>::inwards;
    if (listed_as[*at] != never)
      return said() + " is there already as entry " + std::to_string(listed_as[*at]);
    listed_as[*at] = entry;
  }
  const auto missing = std::find(listed_as.begin(), listed_as.end(), never);
  if (missing == listed_as.end()) return std::nullopt;
  const auto& facet = facets.facets()[static_cast<std::size_t>(missing - listed_as.begin())];
  return "boundary " + words(mesh, facet.sorted.directed()) + " of " + Kind::cell + " " +
         std::to_string(facet.cell.raw) + " has no marker";
}

template <int Dim>
std::optional<std::string> broken_inner_facet(const SimplexMesh<Dim>& mesh,
                                              const HalfFacetTable<Dim>& table) {
  const auto& inner = mesh.inner_facets();
  for (std::size_t entry = 0; entry < inner.size(); ++entry) {
    if (table.find(sorted_facet(Simplex<Dim>::corners_of(inner[entry])).corners).size() != 2)
      return entry_words(mesh, Verdicts<Dim>::inner_list, entry, inner[entry]) + Verdicts<Dim>::not_inner;
  }
  return std::nullopt;
}

void refuse(const std::optional<std::string>& problem, const std::string& source, const std::string& remedy) {
  if (problem) throw InputError(source, *problem, remedy);
}

template <int Dim>
HalfFacetTable<Dim> checked_half_facets(const SimplexMesh<Dim>& mesh, const std::string& source) {
  const std::string remedy = std::string("correct the list of ") + Simplex<Dim>::cells;
  refuse(broken_corner(mesh), source, remedy);
  HalfFacetTable<Dim> table = half_facet_table(mesh);
  refuse(broken_facet(mesh, table), source, remedy);
  return table;
}

template std::optional<std::string> broken_sizes(const SimplexMesh<2>&);
template std::optional<std::string> broken_point(const SimplexMesh<2>&);
template std::optional<std::string> broken_corner(const SimplexMesh<2>&);
template std::optional<std::string> unused_vertex(const SimplexMesh<2>&);
template std::optional<std::string> broken_orientation(const SimplexMesh<2>&);
template std::optional<std::string> broken_neighbour(const SimplexMesh<2>&, const HalfFacetTable<2>&);
template std::optional<std::string> broken_inner_facet(const SimplexMesh<2>&, const HalfFacetTable<2>&);
template class BoundaryFacets<2>;
template std::optional<std::string> broken_boundary(const SimplexMesh<2>&, const BoundaryFacets<2>&);
template HalfFacetTable<2> checked_half_facets(const SimplexMesh<2>&, const std::string&);

template std::optional<std::string> broken_sizes(const SimplexMesh<3>&);
template std::optional<std::string> broken_point(const SimplexMesh<3>&);
template std::optional<std::string> broken_corner(const SimplexMesh<3>&);
template std::optional<std::string> unused_vertex(const SimplexMesh<3>&);
template std::optional<std::string> broken_orientation(const SimplexMesh<3>&);
template std::optional<std::string> broken_neighbour(const SimplexMesh<3>&, const HalfFacetTable<3>&);
template std::optional<std::string> broken_inner_facet(const SimplexMesh<3>&, const HalfFacetTable<3>&);
template class BoundaryFacets<3>;
template std::optional<std::string> broken_boundary(const SimplexMesh<3>&, const BoundaryFacets<3>&);
template HalfFacetTable<3> checked_half_facets(const SimplexMesh<3>&, const std::string&);

}  // namespace leonhard::mesh
