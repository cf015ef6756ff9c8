// SPDX-License-Identifier: MIT
#include "leonhard/mesh/quad_edge.hpp"

#include <utility>

namespace leonhard {

EdgeRef QuadEdge::make_edge(MaybeId<VertexId> origin, MaybeId<VertexId> destination) {
  if (free_.empty()) {
    free_.push_back(static_cast<IdRaw>(records_.size()));
    records_.emplace_back();
  }
  const IdRaw q = free_.back();
  free_.pop_back();
  const EdgeRef e{4 * q};
  // Alone on its sphere: each end's ring is the edge itself, both sides are one face.
  records_[q] = {{e, inv_rot(e), sym(e), rot(e)}, {origin, destination}, {}};
  return e;
}

void QuadEdge::splice(EdgeRef a, EdgeRef b) {
  const EdgeRef alpha = rot(onext(a)), beta = rot(onext(b));
  std::swap(onext_of(a), onext_of(b));
  std::swap(onext_of(alpha), onext_of(beta));
}

EdgeRef QuadEdge::connect(EdgeRef a, EdgeRef b) {
  const EdgeRef e = make_edge(destination(a), origin(b));
  set_left(e, left(a));
  set_left(sym(e), left(a));
  splice(e, lnext(a));
  splice(sym(e), b);
  return e;
}

void QuadEdge::remove(EdgeRef e) {
  splice(e, oprev(e));
  splice(sym(e), oprev(sym(e)));
  record(e).onext[0] = removed;
  free_.push_back(e.raw >> 2);
}

void QuadEdge::swap(EdgeRef e) {
  const EdgeRef a = oprev(e), b = oprev(sym(e));
  splice(e, a);
  splice(sym(e), b);
  splice(e, lnext(a));
  splice(sym(e), lnext(b));
  set_origin(e, destination(a));
  set_destination(e, destination(b));
  // The two sides of the quadrilateral that lay on the other side of the diagonal before.
  set_left(lprev(e), left(e));
  set_left(lprev(sym(e)), right(e));
}

std::string QuadEdge::name(EdgeRef e) {
  std::string text = "edge " + std::to_string(e.raw >> 2);
  const IdRaw quarters = e.raw & 3;
  if (quarters != 0) text += ", turned by " + std::to_string(quarters) + " quarters";
  return text;
}

std::optional<std::string> QuadEdge::broken_algebra(EdgeRef e) const {
  const EdgeRef next = onext(e);
  if (!contains(next)) return name(e) + " is followed about its origin by an edge that was removed";
  if (is_primal(e) != is_primal(next)) {
    return name(e) + " is followed about its origin by " + name(next) +
           ": one joins vertices, the other faces";
  }
  if (rot(onext(rot(next))) != e) {
    return name(e) + " is followed about its origin by " + name(next) + ", but is not the one before it";
  }
  return std::nullopt;
}

std::optional<std::string> QuadEdge::broken_id(EdgeRef e) const {
  if (origin(e) != origin(onext(e))) {
    return name(e) + " and " + name(onext(e)) + " have the same origin with different vertices";
  }
  if (left(e) != left(lnext(e))) {
    return name(e) + " and " + name(lnext(e)) + " have the same left face with different ids";
  }
  return std::nullopt;
}

std::optional<std::string> QuadEdge::validate() const {
  std::optional<std::string> problem;
  for_each_edge([&](EdgeRef e) {
    for (EdgeRef turn : {e, rot(e), sym(e), inv_rot(e)})
      if (!problem) problem = broken_algebra(turn);
  });
  if (problem) return problem;
  for_each_directed_edge([&](EdgeRef e) {
    if (!problem) problem = broken_id(e);
  });
  return problem;
}

}  // namespace leonhard
