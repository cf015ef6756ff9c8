// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/star.hpp"

#include <algorithm>
#include <cassert>

#include "leonhard/delaunay/plane/fast.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

void Star::start(const GhostTriangulation& in, SideId side) {
  link_.clear();
  triangles_.clear();
  SideId s = side;
  do {
    const SideId opposite = in.next(s);
    link_.push_back({in.twin(opposite), in.origin(opposite)});
    triangles_.push_back(in.triangle(s));
    s = in.turn_about_origin(s);
  } while (s != side);
  const auto is_ghost = [](const Link& l) { return l.from == GhostTriangulation::ghost; };
  const auto found = std::find_if(link_.begin(), link_.end(), is_ghost);
  if (found != link_.end()) std::rotate(link_.begin(), found + 1, link_.end());
}

void Star::fill(GhostTriangulation& in, std::span<const Point2> points, std::size_t few) {
  in_ = &in;
  points_ = points;
  taken_ = 0;
  if (link_.size() <= few)
    fill_directly();
  else
    fill_from_whole();
  assert(taken_ + 2 == triangles_.size());
}

void Star::fill_directly() {
  if (has_ghost()) return fill_about_ghost();
  const SideId outer = link_.back().outer;
  in_->link(fill_chain(0, link_.size() - 1), outer);
}

/// One of the star's triangles, with new corners.
AnyTriangleId Star::take(VertexId a, VertexId b, VertexId c) {
  const AnyTriangleId t = triangles_[taken_++];
  in_->set_corners(t, a, b, c);
  return t;
}

/// Which vertex of link()[begin..end) makes a Delaunay triangle with the edge; end if none lies to its left.
/// The circles through two points are ordered by what they hold of the half plane to the left, so one pass is
/// enough.
std::size_t Star::apex(VertexId from, VertexId to, std::size_t begin, std::size_t end) const {
  const Point2 a = at(from), b = at(to);
  std::size_t best = end;
  for (std::size_t i = begin; i < end; ++i) {
    const Point2 p = at(link_[i].from);
    if (best != end && kernel::incircle_perturbed(a, b, at(link_[best].from), p) != Sign::positive) continue;
    if (kernel::orient2d(a, b, p) == Sign::positive) best = i;
  }
  return best;
}

/// Fill the polygon of link()[first..last], none of them the ghost, and of the chord last -> first.
/// returns  the side from last to first, not yet linked
SideId Star::fill_chain(std::size_t first, std::size_t last) {
  if (last == first + 1) return link_[first].outer;
  const VertexId from = link_[last].from, to = link_[first].from;
  const std::size_t k = apex(from, to, first + 1, last);
  assert(k != last);
  const AnyTriangleId t = take(from, to, link_[k].from);
  in_->link(in_->side(t, 0), fill_chain(first, k));
  in_->link(in_->side(t, 1), fill_chain(k, last));
  return in_->side(t, 2);
}

/// Fill the hole behind link()[0], ..., the ghost. The first edge of what is left gets its triangle, a real
/// one if any vertex lies to its left, until a single vertex is left.
void Star::fill_about_ghost() {
  constexpr VertexId ghost = GhostTriangulation::ghost;
  const std::size_t last = link_.size() - 2;
  SideId from_ghost = link_.back().outer;  // first -> ghost
  for (std::size_t first = 0; first < last;) {
    const VertexId a = link_[first].from, b = link_[first + 1].from;
    const std::size_t k = apex(a, b, first + 2, last + 1);
    if (k == last + 1) {
      const AnyTriangleId t = take(ghost, a, b);
      in_->link(in_->side(t, 0), link_[first].outer);
      in_->link(in_->side(t, 2), from_ghost);
      from_ghost = in_->side(t, 1);
      ++first;
    } else {
      const AnyTriangleId t = take(a, b, link_[k].from);
      in_->link(in_->side(t, 2), link_[first].outer);
      in_->link(in_->side(t, 0), fill_chain(first + 1, k));
      first = k - 1;
      link_[first] = {in_->side(t, 1), a};
    }
  }
  in_->link(from_ghost, link_[last].outer);
}

void Star::fill_from_whole() {
  std::vector<Point2> corners;
  for (const Link& l : link_)
    if (l.from != GhostTriangulation::ghost) corners.push_back(at(l.from));
  const PointTriangulation whole = triangulate_fast(corners);
  if (whole.outcome == TriangulateOutcome::done) return copy_part(whole.triangulation);
  // All on one line, with nothing behind: ghosts alone.
  assert(has_ghost());
  SideId from_ghost = link_.back().outer;
  for (std::size_t i = 0; i + 2 < link_.size(); ++i) {
    const AnyTriangleId t = take(GhostTriangulation::ghost, link_[i].from, link_[i + 1].from);
    in_->link(in_->side(t, 0), link_[i].outer);
    in_->link(in_->side(t, 2), from_ghost);
    from_ghost = in_->side(t, 1);
  }
  in_->link(from_ghost, link_[link_.size() - 2].outer);
}

/// Take over the triangles that lie on the hole's side of the link's edges.
///
/// whole  the Delaunay triangulation of the link's vertices, numbered by their places in link(); its
///        triangles within the hole are those that are wanted, so the link's edges are among its edges
void Star::copy_part(const GhostTriangulation& whole) {
  const std::size_t n = link_.size();
  const std::size_t ghost_place = has_ghost() ? n - 1 : n;  // n: nowhere
  const auto place = [&](VertexId v) { return v == GhostTriangulation::ghost ? ghost_place : v.index(); };
  const auto is_border = [&](SideId s) {
    const std::size_t from = place(whole.origin(s)), to = place(whole.destination(s));
    return from < n && to == (from + 1 == n ? 0 : from + 1);
  };
  std::vector<MaybeId<AnyTriangleId>> copy_of(whole.triangle_count());
  std::vector<AnyTriangleId> pending;
  const auto copy = [&](AnyTriangleId t) {
    if (!copy_of[t.index()]) {
      const auto corner = [&](unsigned i) { return link_[place(whole.corner(t, i))].from; };
      copy_of[t.index()] = take(corner(0), corner(1), corner(2));
      pending.push_back(t);
    }
    return *copy_of[t.index()];
  };
  for (std::size_t i = 0; pending.empty(); ++i)  // until a border's triangle is found
    for (unsigned k = 0; k < 3; ++k)
      if (const AnyTriangleId t = AnyTriangleId::from(i); is_border(whole.side(t, k)) && pending.empty())
        copy(t);
  while (!pending.empty()) {
    const AnyTriangleId t = pending.back();
    pending.pop_back();
    for (unsigned k = 0; k < 3; ++k) {
      const SideId s = whole.side(t, k), twin = whole.twin(s), mine = in_->side(*copy_of[t.index()], k);
      if (is_border(s))
        in_->link(mine, link_[place(whole.origin(s))].outer);
      else
        in_->link(mine, in_->side(copy(whole.triangle(twin)), whole.number(twin)));
    }
  }
}

}  // namespace leonhard::delaunay
