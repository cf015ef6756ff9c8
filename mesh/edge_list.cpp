// SPDX-License-Identifier: MIT
#include "leonhard/mesh/edge_list.hpp"

#include <algorithm>

#include "leonhard/mesh/structures/half_facets.hpp"

namespace leonhard {

MaybeId<EdgeId> EdgeList::find(VertexId a, VertexId b) const {
  return mesh::find_facet(ends, first_edge, {std::min(a, b), std::max(a, b)});
}

}  // namespace leonhard
