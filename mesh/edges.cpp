// SPDX-License-Identifier: MIT
#include "leonhard/mesh/edges.hpp"

#include <algorithm>
#include <utility>

#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/structures/half_facets.hpp"

namespace leonhard {

MaybeId<EdgeId> EdgeStructure::find(VertexId a, VertexId b) const {
  return mesh::find_facet(ends, first_edge, {std::min(a, b), std::max(a, b)});
}

namespace mesh {

EdgeStructure build_edges(const TriangleMesh& mesh) {
  auto [ends, sides, first] = facet_list(mesh, checked_half_facets(mesh));
  return {std::move(ends), std::move(sides), std::move(first)};
}

}  // namespace mesh
}  // namespace leonhard
