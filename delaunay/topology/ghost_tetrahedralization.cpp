// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"

#include <algorithm>
#include <functional>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

std::string name(TetId t) { return "tetrahedron " + std::to_string(t.raw); }

/// The corners of a face in the order that starts with the least, the direction kept.
std::array<VertexId, 3> face_corners(const GhostTetrahedralization& in, TetId t, unsigned face) {
  std::array<VertexId, 3> corners;
  for (unsigned i = 0; i < 3; ++i) corners[i] = in.corners[t][tet_face_corners[face][i]];
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

std::optional<std::string> broken_corners(const GhostTetrahedralization& in, TetId t) {
  std::array<VertexId, 4> corners = in.corners[t];
  for (unsigned i = 1; i < 4; ++i)
    if (corners[i] == GhostTetrahedralization::ghost)
      return name(t) + " has the ghost at corner " + std::to_string(i) + " instead of corner 0";
  std::sort(corners.begin(), corners.end());
  if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
    return name(t) + " has a corner twice";
  return {};
}

std::optional<std::string> broken_face(const GhostTetrahedralization& in, TetId t, unsigned face) {
  const std::string where = name(t) + ", face " + std::to_string(face) + ": ";
  const MaybeId<TetId> behind = in.neighbours[t][face];
  if (!behind || !in.corners.contains(*behind)) return where + "no tetrahedron lies behind it";
  const auto& back = in.neighbours[*behind];
  const auto twin = static_cast<unsigned>(std::find(back.begin(), back.end(), MaybeId(t)) - back.begin());
  if (twin == 4) return where + name(*behind) + " lies behind it but does not point back";
  std::array<VertexId, 3> mine = face_corners(in, t, face), other = face_corners(in, *behind, twin);
  std::swap(other[1], other[2]);
  if (mine != other)
    return where + name(*behind) + " lies behind it but does not share its corners in opposite order";
  return {};
}

}  // namespace

void GhostTetrahedralization::erase(std::vector<TetId> dead) {
  std::sort(dead.begin(), dead.end(), std::greater<>());
  for (const TetId hole : dead) {  // the last one is alive: all dead ones after the hole are gone
    const TetId last = TetId::from(tet_count() - 1);
    if (hole != last) {
      corners[hole] = corners[last];
      neighbours[hole] = neighbours[last];
      for (const MaybeId<TetId> behind : neighbours[hole]) {
        if (!behind) continue;
        auto& back = neighbours[*behind];
        std::replace(back.begin(), back.end(), MaybeId(last), MaybeId(hole));
      }
    }
    corners.flat().pop_back();
    neighbours.flat().pop_back();
  }
}

std::optional<std::string> GhostTetrahedralization::validate() const {
  if (neighbours.size() != corners.size())
    return "there are " + std::to_string(corners.size()) + " tetrahedra and neighbours of " +
           std::to_string(neighbours.size());
  for (const TetId t : corners.ids()) {
    if (auto broken = broken_corners(*this, t)) return broken;
    for (unsigned face = 0; face < 4; ++face)
      if (auto broken = broken_face(*this, t, face)) return broken;
  }
  return {};
}

}  // namespace leonhard::delaunay
