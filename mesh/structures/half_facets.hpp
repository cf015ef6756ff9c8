// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/structures/sorted_facet.hpp"

namespace leonhard::mesh {

/// One side of a cell, seen as a part of the facet that it has in common with another, whichever way round.
template <int Dim>
struct HalfFacet {
  std::array<VertexId, Dim - 1> higher;  ///< the facet's vertices but for the smallest, ascending
  typename Simplex<Dim>::CellId cell;    ///< whose side it is
  std::uint8_t side;                     ///< 0..Dim: opposite corners[cell][side]
  bool even;  ///< whether the smallest and `higher`, in this order, are directed out of the cell
};

/// All sides of all cells, grouped by smallest vertex, sorted by (higher, cell) within a group: the table from which
/// neighbours and facets are read.
template <int Dim>
struct HalfFacetTable {
  std::vector<HalfFacet<Dim>> entries;  ///< Dim + 1 a cell
  std::vector<std::size_t> first;       ///< entries with smallest vertex v are first[v] .. first[v + 1] - 1

  /// The entries of one facet, given with its vertices ascending; empty if there is none. Cost O(log degree).
  [[nodiscard]] std::span<const HalfFacet<Dim>> find(const std::array<VertexId, Dim>& facet) const;
};

/// The table of a mesh whose corners are in range and distinct within each cell.
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] HalfFacetTable<Dim> half_facet_table(const SimplexMesh<Dim>& mesh);

/// Calls visit(low, half-facets of one facet) for each facet in the order of (low, higher) until it returns true.
template <int Dim, class Visit>
void for_each_facet_until(const HalfFacetTable<Dim>& table, Visit visit) {
  for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
    for (std::size_t begin = table.first[v], end = begin; begin < table.first[v + 1]; begin = end) {
      while (end < table.first[v + 1] && table.entries[end].higher == table.entries[begin].higher) ++end;
      if (visit(VertexId::from(v), std::span(table.entries).subspan(begin, end - begin))) return;
    }
  }
}

/// Words for the first facet that has more than two cells or two on the same side (a cell given twice included); none if
/// every facet is that of an oriented surface or space.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_facet(const SimplexMesh<Dim>& mesh,
                                                      const HalfFacetTable<Dim>& table);

/// The neighbours that the table implies, shaped as mesh.neighbours. Every facet must be in order (broken_facet).
template <int Dim>
[[nodiscard]] PerId<typename Simplex<Dim>::CellId, typename SimplexMesh<Dim>::CellNeighbours> neighbours_of(
    const SimplexMesh<Dim>& mesh, const HalfFacetTable<Dim>& table);

/// The facets of a mesh, sorted by their vertices.
template <int Dim>
struct FacetList {
  using FacetId = typename Simplex<Dim>::FacetId;
  PerId<FacetId, std::array<VertexId, Dim>> corners;  ///< ascending
  /// [0] the cell out of which the corners are directed, [1] the one beyond
  PerId<FacetId, std::array<MaybeId<typename Simplex<Dim>::CellId>, 2>> sides;
  std::vector<IdRaw> first;  ///< facets with corners[0] == v are first[v] .. first[v + 1] - 1
};

/// Every facet of the table must be in order (broken_facet).
template <int Dim>
[[nodiscard]] FacetList<Dim> facet_list(const SimplexMesh<Dim>& mesh, const HalfFacetTable<Dim>& table);

/// The facet of these vertices, given ascending, in a list that is shaped as FacetList is; none if there is no such
/// facet. Cost O(log degree).
template <class FacetId, std::size_t count>
[[nodiscard]] MaybeId<FacetId> find_facet(const PerId<FacetId, std::array<VertexId, count>>& corners,
                                          const std::vector<IdRaw>& first,
                                          const std::array<VertexId, count>& ascending) {
  const std::size_t low = ascending[0].index();
  if (low + 1 >= first.size()) return {};
  const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(first[low]);
  const auto end = corners.begin() + static_cast<std::ptrdiff_t>(first[low + 1]);
  const auto at = std::partition_point(begin, end, [&](const auto& facet) {
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (facet[i] != ascending[i]) return facet[i] < ascending[i];
    }
    return facet[count - 1] < ascending[count - 1];
  });
  if (at == end || *at != ascending) return {};
  return FacetId::from(static_cast<std::size_t>(at - corners.begin()));
}

}  // namespace leonhard::mesh
