// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/ghost_triangulation.hpp"

#include <cassert>

namespace leonhard::delaunay {

void GhostTriangulation::start(VertexId a, VertexId b, VertexId c) {
  assert(corners_.empty());
  const TriangleId real = add(a, b, c);
  const std::array<VertexId, 3> corners{a, b, c};
  std::array<TriangleId, 3> ghosts;
  for (unsigned i = 0; i < 3; ++i) ghosts[i] = add(ghost, corners[(i + 2) % 3], corners[(i + 1) % 3]);
  for (unsigned i = 0; i < 3; ++i) {
    link(side(real, i), side(ghosts[i], 0));
    // Side 1 of (ghost, a, b) ends in the ghost, side 2 comes from it.
    link(side(ghosts[i], 2), side(ghosts[(i + 1) % 3], 1));
  }
}

std::string GhostTriangulation::name(SideId s) {
  return "side " + std::to_string(number(s)) + " of triangle " + std::to_string(triangle(s).raw);
}

GhostTriangulation::Flipped GhostTriangulation::flip(SideId s) {
  const SideId t = twin(s);
  const SideId s_next = next(s), s_previous = previous(s), t_next = next(t), t_previous = previous(t);
  const VertexId left = apex(s), right = apex(t);
  const SideId beyond_s_next = twin(s_next), beyond_t_next = twin(t_next);

  // (left, from, to) becomes (left, from, right), (right, to, from) becomes (right, to, left): each keeps two
  // corners, and with them the outer side between these.
  corners_[slot(s_previous)] = right;
  corners_[slot(t_previous)] = left;
  link(s, beyond_t_next);
  link(t, beyond_s_next);
  link(s_next, t_next);
  return {s_next, {{{s_next, t}, {t_next, s}, {s_previous, s_previous}, {t_previous, t_previous}}}};
}

std::optional<std::string> GhostTriangulation::validate() const {
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const SideId s = side(TriangleId::from(k / 3), static_cast<unsigned>(k % 3));
    if (number(twin(s)) > 2 || slot(twin(s)) >= corners_.size() || twin(twin(s)) != s)
      return name(s) + " has a twin that does not point back";
    if (origin(s) != destination(twin(s)) || destination(s) != origin(twin(s)))
      return name(s) + " and its twin do not share their ends";
    if (origin(s) == destination(s)) return name(s) + " joins a vertex to itself";
    if (number(s) != 0 && apex(s) == ghost)
      return "the ghost is not at corner 0 of triangle " + std::to_string(k / 3);
  }
  return std::nullopt;
}

}  // namespace leonhard::delaunay
