// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The tetrahedra that a new vertex destroys, and those that take their place: Bowyer 1981 and Watson 1981 for a
/// tetrahedralisation that changes. Buffers are kept from one insertion to the next.
class TetCavity {
 public:
  /// Replace what v destroys (in_conflict) by cones from v over the cavity's walls.
  ///
  /// v      no vertex yet, its point none of a vertex
  /// t      destroyed by v: the tetrahedron that holds it or a ghost that it lies beyond
  /// spare  tetrahedra that are not in use: taken where more come than go, added to where fewer do; their corners are
  ///        all the ghost
  /// Cost O(k log k) for k walls.
  void insert(GhostTetrahedralization& in, std::span<const Point3> points, VertexId v, TetId t,
              std::vector<TetId>& spare);

  /// The cones, ghosts among them, after insert.
  [[nodiscard]] std::span<const TetId> made() const { return made_; }

 private:
  enum class Mark : std::uint8_t { none, destroyed, kept };
  /// A face between the cavity and a tetrahedron that stays.
  struct Wall {
    TetCorners corners;   ///< of the cone
    unsigned face;        ///< which face of the cone it is
    TetId outer;          ///< behind it
    unsigned outer_face;  ///< which face of the outer one
  };
  /// What two cones have in common besides the new vertex.
  struct Edge {
    std::array<VertexId, 2> ends;
    TetId t;
    unsigned opposite;
  };
  void open(const GhostTetrahedralization& in, std::span<const Point3> points, VertexId v, TetId t);
  void choose_places(GhostTetrahedralization& in, std::vector<TetId>& spare);
  void fill(GhostTetrahedralization& in);

  std::vector<Mark> marks_;  // one a tetrahedron, all none between insertions
  std::vector<TetId> cavity_, made_;
  std::vector<Wall> walls_;
  std::vector<Edge> edges_;
};

}  // namespace leonhard::delaunay
