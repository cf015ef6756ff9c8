// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/delaunay/support/id_set.hpp"
#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The tetrahedra that a point, if inserted, destroys: TetCavity without changes and without marks, so that many threads
/// may look at once. Buffers are kept from one point to the next.
class TetConflictZone {
 public:
  /// A face of the zone: of one of its tetrahedra, opposite corner `face`; what lies behind is not in the zone.
  struct Wall {
    TetId inner;
    unsigned face;
  };

  /// p  at no vertex
  /// t  destroyed by p: the tetrahedron that holds it or a ghost that it lies beyond
  /// Cost O(k log k) for k tetrahedra.
  void collect(const GhostTetrahedralization& in, std::span<const Point3> points, TetId t, const Point3& p);

  /// In rising order, which does not depend on where the search began.
  [[nodiscard]] std::span<const TetId> tets() const { return tets_; }
  /// In the order of the tetrahedra, then of the faces.
  [[nodiscard]] std::span<const Wall> walls() const { return walls_; }
  /// Whether a ghost is among the tetrahedra: p lies beyond or on the hull.
  [[nodiscard]] bool has_ghost() const { return has_ghost_; }

 private:
  std::vector<TetId> tets_;
  std::vector<Wall> walls_;
  IdSet destroyed_, kept_;
  bool has_ghost_ = false;
};

}  // namespace leonhard::delaunay
