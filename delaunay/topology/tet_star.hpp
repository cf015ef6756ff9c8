// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/delaunay/support/id_set.hpp"
#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// The tetrahedra at a vertex and the other ends of its edges. Nothing is marked, so that many threads may look at
/// once. Buffers are kept from one vertex to the next.
class TetStar {
 public:
  /// Collect the star of a vertex, which may be the ghost.
  ///
  /// t  one of its tetrahedra
  /// Cost O(degree).
  void collect(const GhostTetrahedralization& in, TetId t, VertexId v);

  [[nodiscard]] std::span<const TetId> tets() const { return tets_; }  ///< ghosts among them
  [[nodiscard]] std::span<const VertexId> neighbours() const {
    return neighbours_;
  }  ///< the ghost maybe among them

 private:
  std::vector<TetId> tets_;
  std::vector<VertexId> neighbours_;
  IdSet known_;
};

}  // namespace leonhard::delaunay
