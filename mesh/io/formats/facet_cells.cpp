// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/facet_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::io {
namespace {

constexpr std::size_t no_cell = std::numeric_limits<std::size_t>::max();

/// The vertices of a facet, ascending; beyond the last the largest again.
using FacetKey = std::array<VertexId, most_facet_corners>;

FacetKey key_of(FacetKey vertices, std::size_t count) {
  std::sort(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count));
  std::fill(vertices.begin() + static_cast<std::ptrdiff_t>(count), vertices.end(), vertices[count - 1]);
  return vertices;
}

/// Facets in the order of their keys, and the first cell found at each.
template <int Dim>
class FacetTable {
 public:
  FacetTable(std::size_t vertices, const std::vector<MixedFacet<Dim>>& facets) : has_facet_(vertices, 0) {
    entries_.reserve(facets.size());
    for (const MixedFacet<Dim>& facet : facets) {
      FacetKey vertices_of_facet{};
      std::copy(facet.begin(), facet.end(), vertices_of_facet.begin());
      entries_.push_back({key_of(vertices_of_facet, facet.size()), entries_.size()});
      for (const VertexId v : facet) has_facet_[v.index()] = 1;
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
    cell_of_.assign(facets.size(), no_cell);
  }

  template <class Corners>
  void add_cell(std::size_t cell, CellKind kind, const Corners& corners) {
    for (const FacetShape& shape : shape_of(kind).facets) {
      FacetKey vertices{};
      std::size_t count = 0;
      for (const std::size_t corner : shape) {
        if (has_facet_[corners[corner].index()] == 0) break;
        vertices[count++] = corners[corner];
      }
      if (count == shape.size()) add_side(cell, key_of(vertices, count));
    }
  }

  [[nodiscard]] std::vector<std::size_t> finish() && {
    const auto bare = std::find(cell_of_.begin(), cell_of_.end(), no_cell);
    if (bare != cell_of_.end())
      throw InputError("boundary",
                       "marked facet " + std::to_string(bare - cell_of_.begin()) + " is no side of a cell",
                       "give a mesh that passes validate");
    return std::move(cell_of_);
  }

 private:
  struct Entry {
    FacetKey key;
    std::size_t facet;
  };

  void add_side(std::size_t cell, const FacetKey& key) {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), key,
                                  [](const Entry& e, const FacetKey& k) { return e.key < k; });
    for (; entry != entries_.end() && entry->key == key; ++entry)
      if (cell_of_[entry->facet] == no_cell) cell_of_[entry->facet] = cell;
  }

  std::vector<char> has_facet_;  ///< one a vertex
  std::vector<Entry> entries_;
  std::vector<std::size_t> cell_of_;  ///< one a facet
};

}  // namespace

template <int Dim>
std::vector<std::size_t> cells_at(const SimplexMesh<Dim>& mesh, const std::vector<MixedFacet<Dim>>& facets) {
  FacetTable<Dim> table(mesh.vertex_count(), facets);
  for (const auto cell : mesh.corners.ids())
    table.add_cell(cell.index(), simplex_kind<Dim>, mesh.corners[cell]);
  return std::move(table).finish();
}
template <int Dim>
std::vector<std::size_t> cells_at(const MixedMesh<Dim>& mesh, const std::vector<MixedFacet<Dim>>& facets) {
  FacetTable<Dim> table(mesh.vertex_count(), facets);
  for (const CellId cell : mesh.kinds.ids())
    table.add_cell(cell.index(), mesh.kinds[cell], mesh.corners_of(cell));
  return std::move(table).finish();
}

template std::vector<std::size_t> cells_at(const SimplexMesh<2>&, const std::vector<MixedFacet<2>>&);
template std::vector<std::size_t> cells_at(const SimplexMesh<3>&, const std::vector<MixedFacet<3>>&);
template std::vector<std::size_t> cells_at(const MixedMesh<2>&, const std::vector<MixedFacet<2>>&);
template std::vector<std::size_t> cells_at(const MixedMesh<3>&, const std::vector<MixedFacet<3>>&);

}  // namespace leonhard::io
