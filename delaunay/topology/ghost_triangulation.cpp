// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"

#include <cassert>

namespace leonhard::delaunay {

void GhostTriangulation::set_first_triangle(AnyTriangleId t, VertexId a, VertexId b, VertexId c) {
  const auto ghost_at = [&](unsigned i) { return AnyTriangleId{t.raw + 1 + i}; };  // behind side i
  set_corners(t, a, b, c);
  set_corners(ghost_at(0), ghost, c, b);
  set_corners(ghost_at(1), ghost, a, c);
  set_corners(ghost_at(2), ghost, b, a);
  for (unsigned i = 0; i < 3; ++i) {
    link(side(t, i), side(ghost_at(i), 0));
    // Side 1 of (ghost, a, b) ends in the ghost, side 2 comes from it.
    link(side(ghost_at(i), 2), side(ghost_at((i + 1) % 3), 1));
  }
}

void GhostTriangulation::renumber_vertices(std::span<const std::uint32_t> number_of) {
  for (std::array<VertexId, 3>& corners : corners_)
    for (VertexId& v : corners)
      if (v != ghost) v = VertexId{number_of[v.index()]};
}

void GhostTriangulation::erase(AnyTriangleId t) {
  const AnyTriangleId last = AnyTriangleId::from(triangle_count() - 1);
  if (t != last) {
    corners_[t.index()] = corners_.back();
    for (unsigned i = 0; i < 3; ++i) link(side(t, i), twin(side(last, i)));
  }
  corners_.pop_back();
  twins_.resize(3 * last.index());
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
  set_corner(triangle(s_previous), number(s_previous), right);
  set_corner(triangle(t_previous), number(t_previous), left);
  link(s, beyond_t_next);
  link(t, beyond_s_next);
  link(s_next, t_next);
  return {s_next, {{{s_next, t}, {t_next, s}, {s_previous, s_previous}, {t_previous, t_previous}}}};
}

std::optional<std::string> GhostTriangulation::validate() const {
  for (std::size_t k = 0; k < twins_.size(); ++k) {
    const SideId s = side(AnyTriangleId::from(k / 3), static_cast<unsigned>(k % 3));
    if (number(twin(s)) > 2 || slot(twin(s)) >= twins_.size() || twin(twin(s)) != s)
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
