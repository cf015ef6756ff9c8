// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/constrain.hpp"

#include <array>
#include <cassert>
#include <deque>
#include <optional>
#include <utility>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {
namespace {

/// Inserts one segment after another. Edges are remembered as pairs of vertices, because flips renumber sides.
class SegmentInserter {
 public:
  SegmentInserter(ConstrainedTriangulation& in, const Pslg& pslg)
      : in_(in), topology_(in.topology()), pslg_(pslg), side_from_(in.points().size()) {
    for (std::size_t t = 0; t < topology_.triangle_count(); ++t)
      for (unsigned i = 0; i < 3; ++i) remember(topology_.side(AnyTriangleId::from(t), i));
  }

  /// returns  false if it crosses another one
  [[nodiscard]] bool insert(VertexId from, VertexId to, std::size_t segment, std::vector<OverlapNote>& overlaps) {
    const std::size_t overlaps_before = overlaps.size();
    while (from != to) {
      const Step step = first_step(from, to);
      MaybeId<VertexId> reached = step.reached;
      if (step.crosses) reached = cross(from, to, step.side);
      if (!reached) return false;
      mark(find(from, *reached), segment, overlaps, overlaps_before);
      from = *reached;
    }
    return true;
  }

 private:
  using Edge = std::pair<VertexId, VertexId>;

  /// How a segment leaves a vertex: along an edge to `reached`, or across `side`.
  struct Step {
    bool crosses;
    SideId side;
    VertexId reached;
  };

  void remember(SideId s) {
    const VertexId v = topology_.origin(s);
    if (v != GhostTriangulation::ghost) side_from_[v.index()] = s;
  }

  [[nodiscard]] Sign turn(VertexId a, VertexId b, VertexId c) const {
    return kernel::orient2d(in_.point(a), in_.point(b), in_.point(c));
  }

  [[nodiscard]] Step first_step(VertexId from, VertexId to) const {
    const Point2 a = in_.point(from), b = in_.point(to);
    SideId s = side_from_[from.index()];
    while (true) {
      const VertexId right = topology_.destination(s), left = topology_.apex(s);
      if (right == to) return {false, s, to};
      if (right != GhostTriangulation::ghost) {
        const Sign side_of_right = turn(from, to, right);
        const Point2 d = in_.point(right);
        // On the ray towards `to`: then it lies before `to`, since no vertex lies within an edge.
        if (side_of_right == Sign::zero && (a < b) == (a < d)) return {false, s, right};
        if (side_of_right == Sign::negative && left != GhostTriangulation::ghost &&
            turn(from, to, left) == Sign::positive)
          return {true, topology_.next(s), {}};
      }
      s = topology_.turn_about_origin(s);
      assert(s != side_from_[from.index()]);
    }
  }

  /// Flip away all edges that the segment crosses between `from` and the next vertex on it, which is returned;
  /// none, and no edge flipped, if a segment is crossed. `first` is the first side crossed, its origin on the right.
  MaybeId<VertexId> cross(VertexId from, VertexId to, SideId first) {
    std::deque<Edge> crossed;
    VertexId reached{};
    for (SideId s = first;;) {
      if (in_.is_constrained(s)) return {};
      crossed.emplace_back(topology_.origin(s), topology_.destination(s));
      const SideId behind = topology_.twin(s);
      const VertexId v = topology_.apex(behind);
      const Sign side = turn(from, to, v);
      if (side == Sign::zero) {
        reached = v;
        break;
      }
      s = side == Sign::positive ? topology_.next(behind) : topology_.previous(behind);
    }
    std::vector<Edge> changed;
    while (!crossed.empty()) {
      const auto [u, v] = crossed.front();
      crossed.pop_front();
      const SideId s = find(u, v);
      const VertexId x = topology_.apex(s), y = topology_.apex(topology_.twin(s));
      if (turn(x, u, y) != Sign::positive || turn(y, v, x) != Sign::positive) {
        crossed.emplace_back(u, v);
        continue;
      }
      flip(s);
      const bool still_crosses =
          x != from && y != from && x != reached && y != reached && turn(from, to, x) != turn(from, to, y);
      (still_crosses ? crossed.emplace_back(x, y) : changed.emplace_back(x, y));
    }
    legalise(std::move(changed), {from, reached});
    return reached;
  }

  /// Lawson's flips from a stack of edges; `kept` is not flipped although it is no piece yet.
  void legalise(std::vector<Edge> stack, Edge kept) {
    const auto same = [](Edge e, Edge f) { return e == f || e == Edge{f.second, f.first}; };
    while (!stack.empty()) {
      const Edge e = stack.back();
      stack.pop_back();
      if (same(e, kept)) continue;
      const std::optional<SideId> found = find_if_there(e.first, e.second);
      if (!found || in_.is_constrained(*found)) continue;
      const SideId s = *found, t = topology_.twin(s);
      if (topology_.is_ghost(topology_.triangle(s)) || topology_.is_ghost(topology_.triangle(t))) continue;
      const VertexId a = topology_.apex(s), b = topology_.origin(s), c = topology_.destination(s),
                     d = topology_.apex(t);
      if (kernel::incircle_perturbed(in_.point(a), in_.point(b), in_.point(c), in_.point(d)) !=
          Sign::positive)
        continue;
      flip(s);
      stack.insert(stack.end(), {{a, b}, {b, d}, {d, c}, {c, a}});
    }
  }

  void flip(SideId s) {
    const AnyTriangleId one = topology_.triangle(s), other = topology_.triangle(topology_.twin(s));
    in_.flip(s);
    for (unsigned i = 0; i < 3; ++i) {
      remember(topology_.side(one, i));
      remember(topology_.side(other, i));
    }
  }

  [[nodiscard]] std::optional<SideId> find_if_there(VertexId from, VertexId to) const {
    const SideId first = side_from_[from.index()];
    SideId s = first;
    do {
      if (topology_.destination(s) == to) return s;
      s = topology_.turn_about_origin(s);
    } while (s != first);
    return std::nullopt;
  }
  [[nodiscard]] SideId find(VertexId from, VertexId to) const {
    const std::optional<SideId> s = find_if_there(from, to);
    assert(s);
    return *s;
  }

  void mark(SideId s, std::size_t segment, std::vector<OverlapNote>& overlaps, std::size_t overlaps_before) {
    const Marker marker = pslg_.segments[segment].marker;
    if (const MaybeId<PieceId> p = in_.piece_of(s)) {
      const std::size_t earlier = (*in_.piece(*p).segment).index();
      if (overlaps.size() == overlaps_before || overlaps.back().earlier != earlier)
        overlaps.push_back({segment, earlier});
      if (in_.piece(*p).marker == 0) in_.set_marker(*p, marker);
      return;
    }
    in_.add_piece(s, marker, SegmentId::from(segment));
  }

  ConstrainedTriangulation& in_;
  const GhostTriangulation& topology_;
  const Pslg& pslg_;
  std::vector<SideId> side_from_;  // one a vertex: some side that it is the origin of
};

}  // namespace

InsertedSegments insert_segments(ConstrainedTriangulation& in, const Pslg& pslg, const std::vector<VertexId>& vertex_of,
                                 const Progress& progress) {
  SegmentInserter inserter(in, pslg);
  InsertedSegments result;
  constexpr std::size_t poll = 256;
  for (std::size_t k = 0; k < pslg.segments.size(); ++k) {
    if (k % poll == 0) {
      if (progress.stop_requested()) break;
      progress("constrain", static_cast<double>(k) / static_cast<double>(pslg.segments.size()));
    }
    const Pslg::Segment& s = pslg.segments[k];
    if (!inserter.insert(vertex_of[s.from], vertex_of[s.to], k, result.overlaps)) {
      result.some_cross = true;
      break;
    }
  }
  return result;
}

}  // namespace leonhard::delaunay
