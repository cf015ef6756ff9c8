// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard::mesh {

/// The vertices of a facet in an order that depends neither on its direction nor on where it begins: the smallest first,
/// then on towards the smaller one of its two neighbours. Beyond the last: the first again.
template <int Dim>
using FacetRing = std::array<VertexId, MixedFacet<Dim>::most_corners>;

template <int Dim>
struct DirectedRing {
  FacetRing<Dim> ring;
  bool turned;  ///< whether the facet was given in the other direction
};

/// facet  its vertices distinct
template <int Dim>
[[nodiscard]] DirectedRing<Dim> directed_ring(const MixedFacet<Dim>& facet);

/// The facet of a ring, in the ring's direction.
template <int Dim>
[[nodiscard]] MixedFacet<Dim> facet_of_ring(const FacetRing<Dim>& ring);

/// One side of a cell, seen as a part of the facet that it has in common with another.
template <int Dim>
struct MixedSide {
  FacetRing<Dim> ring;
  CellId cell;
  std::uint8_t side;  ///< number in shape(cell).facets
  bool turned;        ///< whether the ring is directed into the cell
};

/// All sides of all cells, sorted by (ring, cell): the table from which what lies beyond a facet is read.
template <int Dim>
class MixedSides {
 public:
  using Group = std::span<const MixedSide<Dim>>;

  /// mesh  its corners in range and distinct within each cell
  /// Cost O(vertices + cells log degree), one sort by buckets.
  explicit MixedSides(const MixedMesh<Dim>& mesh);

  [[nodiscard]] const std::vector<MixedSide<Dim>>& entries() const { return entries_; }
  /// Number of a side in entries().
  [[nodiscard]] std::size_t number_of(const MixedSide<Dim>& side) const {
    return static_cast<std::size_t>(&side - entries_.data());
  }

  /// The sides of one facet; empty if there is none. Cost O(log degree).
  [[nodiscard]] Group find(const FacetRing<Dim>& ring) const;

  /// Calls visit(sides of one facet) for each facet in the order of rings until it returns true.
  template <class Visit>
  void for_each_facet_until(Visit visit) const {
    for (std::size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
      while (end < entries_.size() && entries_[end].ring == entries_[begin].ring) ++end;
      if (visit(Group(entries_).subspan(begin, end - begin))) return;
    }
  }

 private:
  std::vector<MixedSide<Dim>> entries_;
  std::vector<std::size_t> first_;  ///< entries whose ring begins with v are first_[v] .. first_[v + 1] - 1
};

}  // namespace leonhard::mesh
