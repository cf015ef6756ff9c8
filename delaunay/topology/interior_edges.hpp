// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

/// Two triangles with a common edge, from -> to: `left` is the third corner of the one on its left.
struct TrianglePair {
  VertexId from, to, left, right;
  TriangleId left_triangle, right_triangle;
};

/// The edges that are constraints, to look up.
class ConstraintSet {
 public:
  explicit ConstraintSet(const TriangleMesh& mesh) {
    for (const MarkedEdge& edge : mesh.constraints) edges_.push_back(ordered(edge.from, edge.to));
    std::sort(edges_.begin(), edges_.end());
  }
  [[nodiscard]] bool contains(VertexId a, VertexId b) const {
    return std::binary_search(edges_.begin(), edges_.end(), ordered(a, b));
  }

 private:
  static std::pair<VertexId, VertexId> ordered(VertexId a, VertexId b) {
    return {std::min(a, b), std::max(a, b)};
  }
  std::vector<std::pair<VertexId, VertexId>> edges_;
};

/// The first answer that ask(pair) gives for the interior edges that are no constraints, each once; none if
/// it gives none.
template <class Ask>
auto first_of_interior_edges(const TriangleMesh& mesh, const Ask& ask) -> decltype(ask(TrianglePair{})) {
  mesh::require_ids_in_range(mesh);
  const ConstraintSet constraints(mesh);
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const MaybeId<TriangleId> u = mesh.neighbours[t][i];
      if (!u || *u < t) continue;
      const auto& back = mesh.neighbours[*u];
      const auto j = std::find(back.begin(), back.end(), MaybeId<TriangleId>(t)) - back.begin();
      const TrianglePair pair{mesh.corners[t][(i + 1) % 3],
                              mesh.corners[t][(i + 2) % 3],
                              mesh.corners[t][i],
                              mesh.corners[*u][static_cast<std::size_t>(j)],
                              t,
                              *u};
      if (constraints.contains(pair.from, pair.to)) continue;
      if (auto answer = ask(pair)) return answer;
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::delaunay
