// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/constrained_triangulation.hpp"

#include <array>
#include <cassert>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

ConstrainedTriangulation::ConstrainedTriangulation(GhostTriangulation topology, std::vector<Point2> points)
    : topology_(std::move(topology)),
      points_(std::move(points)),
      piece_of_side_(3 * topology_.triangle_count()) {}

void ConstrainedTriangulation::set_piece(SideId s, MaybeId<PieceId> p) {
  piece_of_side_[topology_.slot(s)] = p;
  if (p) pieces_[*p].side = s;
}

PieceId ConstrainedTriangulation::add_piece(SideId s, Marker marker, MaybeId<SegmentId> segment) {
  const PieceId p = pieces_.push_back({topology_.origin(s), topology_.destination(s), s, marker, segment});
  set_both(s, p);
  return p;
}

GhostTriangulation::Flipped ConstrainedTriangulation::flip(SideId s) {
  assert(!is_constrained(s));
  const GhostTriangulation::Flipped flipped = topology_.flip(s);
  std::array<MaybeId<PieceId>, 4> pieces;
  for (std::size_t i = 0; i < 4; ++i) pieces[i] = piece_of(flipped.moved[i].first);
  for (std::size_t i = 0; i < 4; ++i) set_piece(flipped.moved[i].second, pieces[i]);
  set_both(flipped.diagonal, {});
  return flipped;
}

void ConstrainedTriangulation::fill(Cavity& cavity, VertexId v) {
  const bool regions = !region_of_.empty();
  saved_.clear();
  for (const Cavity::Border& b : cavity.border())
    saved_.emplace_back(piece_of(b.inner),
                        regions ? region_of_[GhostTriangulation::triangle(b.inner).index()] : 0);
  cavity.fill(topology_, v);
  piece_of_side_.resize(3 * topology_.triangle_count());
  if (regions) region_of_.resize(topology_.triangle_count());
  for (std::size_t i = 0; i < saved_.size(); ++i) {
    const SideId inner = cavity.border()[i].inner;
    set_piece(inner, saved_[i].first);
    set_piece(GhostTriangulation::next(inner), {});
    set_piece(GhostTriangulation::previous(inner), {});
    if (regions) region_of_[GhostTriangulation::triangle(inner).index()] = saved_[i].second;
  }
}

void ConstrainedTriangulation::release(PieceId p) { set_both(pieces_[p].side, {}); }

PieceId ConstrainedTriangulation::split_piece(PieceId p, VertexId v, const Cavity& filled) {
  const VertexId to = pieces_[p].to;
  PieceId second{};
  for (const Cavity::Border& b : filled.border()) {
    // In the fan triangle (v, from, to) the side opposite its `to` is v -> from.
    const SideId spoke = GhostTriangulation::previous(b.inner);
    assert(topology_.origin(spoke) == v && topology_.destination(spoke) == b.from);
    if (b.from == pieces_[p].from) {
      set_both(spoke, p);
    } else if (b.from == to) {
      second = add_piece(spoke, pieces_[p].marker, pieces_[p].segment);
    }
  }
  pieces_[p].to = v;
  pieces_[second].from = v;
  pieces_[second].to = to;
  return second;
}

std::optional<std::string> ConstrainedTriangulation::validate() const {
  if (auto broken = topology_.validate()) return broken;
  for (std::size_t k = 0; k < piece_of_side_.size(); ++k) {
    const SideId s = topology_.side(AnyTriangleId::from(k / 3), static_cast<unsigned>(k % 3)),
                 t = topology_.twin(s);
    const std::string name = topology_.name(s);
    if (piece_of(s) != piece_of(t)) return name + " and its twin belong to different pieces";
    if (const MaybeId<PieceId> p = piece_of(s)) {
      const VertexId a = topology_.origin(s), b = topology_.destination(s);
      const Piece& known = piece(*p);
      if (known.side != s && known.side != t) return name + " is unknown to its piece";
      if (!(known.from == a && known.to == b) && !(known.from == b && known.to == a))
        return name + " does not join the ends of its piece";
    }
    const AnyTriangleId here = topology_.triangle(s), behind = topology_.triangle(t);
    if (topology_.is_ghost(here)) continue;
    const Point2 a = point(topology_.corner(here, 0)), b = point(topology_.corner(here, 1)),
                 c = point(topology_.corner(here, 2));
    if (kernel::orient2d(a, b, c) != Sign::positive) return name + ": the triangle is not counter-clockwise";
    if (is_constrained(s) || topology_.is_ghost(behind)) continue;
    if (kernel::incircle_perturbed(a, b, c, point(topology_.apex(t))) == Sign::positive)
      return name + " is not locally Delaunay";
  }
  return std::nullopt;
}

}  // namespace leonhard::delaunay
