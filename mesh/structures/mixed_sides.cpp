// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/mixed_sides.hpp"

#include <algorithm>
#include <tuple>

namespace leonhard::mesh {

template <int Dim>
DirectedRing<Dim> directed_ring(const MixedFacet<Dim>& facet) {
  FacetRing<Dim> ring{};
  const auto last = ring.begin() + static_cast<std::ptrdiff_t>(facet.size());
  std::copy(facet.begin(), facet.end(), ring.begin());
  const auto smallest = std::min_element(ring.begin(), last);
  bool turned = Dim == 2 && smallest != ring.begin();
  std::rotate(ring.begin(), smallest, last);
  if (Dim == 3 && ring[1] > *(last - 1)) {
    std::reverse(ring.begin() + 1, last);
    turned = true;
  }
  std::fill(last, ring.end(), ring[0]);
  return {ring, turned};
}

template <int Dim>
MixedFacet<Dim> facet_of_ring(const FacetRing<Dim>& ring) {
  const std::size_t count = Dim == 3 && ring.back() == ring.front() ? 3 : ring.size();
  return MixedFacet<Dim>(std::span<const VertexId>(ring.data(), count));
}

template <int Dim>
MixedSides<Dim>::MixedSides(const MixedMesh<Dim>& mesh) : first_(mesh.vertex_count() + 1, 0) {
  std::vector<MixedSide<Dim>> unsorted;
  for (const CellId cell : mesh.kinds.ids()) {
    for (std::size_t side = 0; side < mesh.shape(cell).facets.size(); ++side) {
      const auto [ring, turned] = directed_ring(mesh.facet_of(cell, side));
      unsorted.push_back({ring, cell, static_cast<std::uint8_t>(side), turned});
      ++first_[ring[0].index() + 1];
    }
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  entries_.resize(unsorted.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& side : unsorted) entries_[next[side.ring[0].index()]++] = side;
  for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
    std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
              entries_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]),
              [](const auto& a, const auto& b) {
                return std::tie(a.ring, a.cell, a.side) < std::tie(b.ring, b.cell, b.side);
              });
  }
}

template <int Dim>
typename MixedSides<Dim>::Group MixedSides<Dim>::find(const FacetRing<Dim>& ring) const {
  const std::size_t low = ring[0].index();
  if (low + 1 >= first_.size()) return {};
  const Group bucket = Group(entries_).subspan(first_[low], first_[low + 1] - first_[low]);
  const auto begin =
      std::partition_point(bucket.begin(), bucket.end(), [&](const auto& side) { return side.ring < ring; });
  const auto end = std::find_if(begin, bucket.end(), [&](const auto& side) { return side.ring != ring; });
  return {begin, end};
}

template DirectedRing<2> directed_ring(const MixedFacet<2>&);
template DirectedRing<3> directed_ring(const MixedFacet<3>&);
template MixedFacet<2> facet_of_ring<2>(const FacetRing<2>&);
template MixedFacet<3> facet_of_ring<3>(const FacetRing<3>&);
template class MixedSides<2>;
template class MixedSides<3>;

}  // namespace leonhard::mesh
