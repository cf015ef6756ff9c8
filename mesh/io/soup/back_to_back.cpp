// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/back_to_back.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace leonhard::io {
namespace {

using FacetKey = std::array<IdRaw, most_facet_corners>;

/// Calls visit(corners) for each boundary facet.
template <int Dim, class Visit>
void for_each_boundary_facet(const SimplexMesh<Dim>& mesh, Visit visit) {
  for (const auto& facet : mesh.boundary) visit(Simplex<Dim>::corners_of(facet));
}
template <int Dim, class Visit>
void for_each_boundary_facet(const MixedMesh<Dim>& mesh, Visit visit) {
  for (const auto& facet : mesh.boundary) visit(facet.corners);
}

template <class Mesh>
std::size_t count_pairs(const Mesh& mesh) {
  std::vector<bool> is_on_boundary(mesh.vertex_count(), false);
  for_each_boundary_facet(mesh, [&](const auto& corners) {
    for (const VertexId v : corners) is_on_boundary[v.index()] = true;
  });
  std::vector<VertexId> order;
  for (const VertexId v : mesh.points.ids())
    if (is_on_boundary[v.index()]) order.push_back(v);
  const auto at = [&](VertexId v) -> const auto& { return mesh.points[v]; };
  std::sort(order.begin(), order.end(),
            [&](VertexId a, VertexId b) { return std::pair(at(a), a) < std::pair(at(b), b); });
  const auto equal = [&](VertexId a, VertexId b) { return at(a) == at(b); };
  if (std::adjacent_find(order.begin(), order.end(), equal) == order.end()) return 0;
  PerId<VertexId, IdRaw> place(mesh.vertex_count());
  for (std::size_t i = 0; i < order.size(); ++i)
    place[order[i]] = i > 0 && equal(order[i], order[i - 1]) ? place[order[i - 1]] : order[i].raw;
  std::vector<FacetKey> keys;
  for_each_boundary_facet(mesh, [&](const auto& corners) {
    FacetKey key{};
    for (std::size_t i = 0; i < corners.size(); ++i) key[i] = place[corners[i]] + 1;
    std::sort(key.begin(), key.end());
    keys.push_back(key);
  });
  std::sort(keys.begin(), keys.end());
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i] == keys[i - 1]) ++pairs;
  return pairs;
}

}  // namespace

template <int Dim>
std::size_t facets_back_to_back(const SimplexMesh<Dim>& mesh) {
  return count_pairs(mesh);
}
template <int Dim>
std::size_t facets_back_to_back(const MixedMesh<Dim>& mesh) {
  return count_pairs(mesh);
}

template std::size_t facets_back_to_back(const SimplexMesh<2>&);
template std::size_t facets_back_to_back(const SimplexMesh<3>&);
template std::size_t facets_back_to_back(const MixedMesh<2>&);
template std::size_t facets_back_to_back(const MixedMesh<3>&);

}  // namespace leonhard::io
