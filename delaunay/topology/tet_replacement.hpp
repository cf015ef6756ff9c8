// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"

namespace leonhard::delaunay {

/// Replaces some tetrahedra by others that fill the same room: what every flip, and every hole filled, comes down to.
/// Nobody needs to say how the new tetrahedra hang together: faces of the same three vertices are joined. Buffers are
/// kept from one replacement to the next.
class TetReplacement {
 public:
  /// Start anew with nothing to replace.
  void start() {
    old_.clear();
    corners_.clear();
  }
  /// A tetrahedron that goes; each once.
  void take(TetId t) { old_.push_back(t); }
  /// A tetrahedron that comes, positive, the ghost only at corner 0.
  void put(const TetCorners& corners) { corners_.push_back(corners); }

  /// Do it. What comes must have the outer faces of what goes, and all its other faces in pairs; no face within what
  /// goes may have the corners of one of what comes.
  ///
  /// spare  tetrahedra that are not in use: taken where more come than go, added to where fewer do; their corners are
  ///        all the ghost
  /// Cost O(k log k) for k tetrahedra.
  void apply(GhostTetrahedralization& in, std::vector<TetId>& spare);

  /// After apply: what came, in the order of put.
  [[nodiscard]] std::span<const TetId> made() const { return made_; }

 private:
  /// Face i of tetrahedron t, a new one or one that lies outside.
  struct Face {
    std::array<VertexId, 3> key;  ///< corners in ascending order
    TetId t;
    unsigned i;
    bool is_old;  ///< seen from a tetrahedron that goes: t lies behind it
  };
  void add_face(const TetCorners& corners, unsigned opposite, TetId t, unsigned i, bool is_old);
  void choose_places(GhostTetrahedralization& in, std::vector<TetId>& spare);
  void join_faces(GhostTetrahedralization& in);

  std::vector<TetId> old_, made_;
  std::vector<TetCorners> corners_;
  std::vector<Face> faces_;
};

}  // namespace leonhard::delaunay
