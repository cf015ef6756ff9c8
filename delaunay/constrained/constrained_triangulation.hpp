// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/delaunay/input_segments.hpp"
#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::delaunay {

/// A part of an input segment that is an edge of the triangulation.
struct Piece {
  VertexId from, to;
  SideId side;                 ///< one of its two sides
  Marker marker{};             ///< 0: none
  MaybeId<SegmentId> segment;  ///< the input segment; none for an edge of the convex hull
};
using PieceId = Id<struct PieceTag>;

/// A triangulation with coordinates, in which some edges are pieces of segments that no flip and no cavity may
/// cross. Functions on top of it (constrain, carve, refine) keep it constrained Delaunay.
class ConstrainedTriangulation {
 public:
  ConstrainedTriangulation() = default;
  ConstrainedTriangulation(GhostTriangulation topology, std::vector<Point2> points);

  [[nodiscard]] const GhostTriangulation& topology() const { return topology_; }
  [[nodiscard]] const std::vector<Point2>& points() const { return points_; }
  [[nodiscard]] Point2 point(VertexId v) const { return points_[v.index()]; }
  [[nodiscard]] const PerId<PieceId, Piece>& pieces() const { return pieces_; }
  [[nodiscard]] const Piece& piece(PieceId p) const { return pieces_[p]; }
  [[nodiscard]] MaybeId<PieceId> piece_of(SideId s) const { return piece_of_side_[topology_.slot(s)]; }
  [[nodiscard]] bool is_constrained(SideId s) const { return piece_of_side_[topology_.slot(s)].has_value(); }
  /// 0: in no region, otherwise one more than the region's index in the input. Empty until regions are assigned.
  [[nodiscard]] const std::vector<std::uint32_t>& region_of() const { return region_of_; }
  void set_regions(std::vector<std::uint32_t> region_of) { region_of_ = std::move(region_of); }

  VertexId add_point(Point2 p) {
    points_.push_back(p);
    return VertexId::from(points_.size() - 1);
  }
  /// Make the edge of side s a piece.
  PieceId add_piece(SideId s, Marker marker, MaybeId<SegmentId> segment);
  void set_marker(PieceId p, Marker marker) { pieces_[p].marker = marker; }

  /// Replace an unconstrained edge between two real triangles by the other diagonal.
  GhostTriangulation::Flipped flip(SideId s);
  /// GhostTriangulation's fill; pieces on the border stay, each new triangle takes the region of the border's
  /// former triangle.
  void fill(Cavity& cavity, VertexId v);
  /// Split piece p at v, which the fan just filled has as its centre: p keeps its first half.
  /// returns  the piece of the second half
  PieceId split_piece(PieceId p, VertexId v, const Cavity& filled);
  /// Forget that the edge is a piece, so that a cavity may cover it; split_piece gives it back in two halves.
  void release(PieceId p);
  /// Undo release.
  void restore(PieceId p) { set_both(pieces_[p].side, p); }

  /// The first broken invariant in words: those of GhostTriangulation, exact orientation of every real triangle,
  /// pieces and sides that do not know each other, an unconstrained edge that is not locally Delaunay (ties
  /// broken by incircle_perturbed).
  [[nodiscard]] std::optional<std::string> validate() const;

 private:
  void set_piece(SideId s, MaybeId<PieceId> p);
  void set_both(SideId s, MaybeId<PieceId> p) {
    set_piece(topology_.twin(s), p);
    set_piece(s, p);
  }

  GhostTriangulation topology_;
  std::vector<Point2> points_;
  std::vector<MaybeId<PieceId>> piece_of_side_;  // both sides of a piece know it
  PerId<PieceId, Piece> pieces_;
  std::vector<std::uint32_t> region_of_;
  std::vector<std::pair<MaybeId<PieceId>, std::uint32_t>> saved_;  // fill's memory of the border
};

}  // namespace leonhard::delaunay
