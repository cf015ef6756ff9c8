// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/from_quad_edge.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

namespace leonhard::delaunay {
namespace {

/// One entry a directed edge.
std::size_t slot(EdgeRef e) { return e.index() >> 1; }

/// For each face one of its edges.
std::vector<EdgeRef> edge_of_face(const QuadEdge& quads) {
  std::vector<EdgeRef> edge;
  quads.for_each_directed_edge([&](EdgeRef e) {
    const MaybeId<FaceId> face = quads.left(e);
    if (!face) return;
    if (edge.size() <= (*face).index()) edge.resize((*face).index() + 1);
    edge[(*face).index()] = e;
  });
  return edge;
}

}  // namespace

GhostTriangulation ghost_triangulation(const QuadEdge& quads) {
  GhostTriangulation out;
  std::vector<SideId> side_of(2 * quads.record_count());
  const std::vector<EdgeRef> edge = edge_of_face(quads);
  out.reserve(edge.size() + 8);
  for (const EdgeRef e : edge) {
    const EdgeRef next = quads.lnext(e), last = quads.lnext(next);
    assert(quads.lnext(last) == e);
    const AnyTriangleId t = out.add(*quads.origin(e), *quads.origin(next), *quads.origin(last));
    side_of[slot(e)] = out.side(t, 2);
    side_of[slot(next)] = out.side(t, 0);
    side_of[slot(last)] = out.side(t, 1);
  }
  quads.for_each_directed_edge([&](EdgeRef e) {
    if (quads.left(e)) return;
    side_of[slot(e)] =
        out.side(out.add(GhostTriangulation::ghost, *quads.origin(e), *quads.destination(e)), 0);
  });
  quads.for_each_directed_edge([&](EdgeRef e) {
    const SideId s = side_of[slot(e)];
    if (QuadEdge::sym(e) > e) out.link(s, side_of[slot(QuadEdge::sym(e))]);
    if (!quads.left(e)) out.link(out.next(s), out.previous(side_of[slot(quads.lnext(e))]));
  });
  return out;
}

}  // namespace leonhard::delaunay
