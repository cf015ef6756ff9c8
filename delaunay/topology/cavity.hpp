// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <utility>
#include <vector>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"

namespace leonhard::delaunay {

/// The triangles that a new vertex destroys, and the fan that takes their place.
///
/// The cavity is a topological disc without interior vertex, so the triangles in it form a tree: a depth-first
/// walk that turns the same way everywhere meets each of them once, needs no marks, and meets the border in
/// counter-clockwise order. Buffers are kept from one insertion to the next.
class Cavity {
 public:
  struct Border {
    SideId inner;  ///< the border's side in the cavity (before fill), opposite the new vertex (after it)
    SideId outer;  ///< its twin
    VertexId from, to;
  };

  /// Counter-clockwise; border()[i].to is border()[i + 1].from.
  [[nodiscard]] const std::vector<Border>& border() const { return border_; }
  /// Every triangle of the cavity once, before fill; the fan, afterwards, triangle i behind border i.
  [[nodiscard]] const std::vector<AnyTriangleId>& triangles() const { return triangles_; }

  /// Start anew with the disc that is one triangle.
  void start(const GhostTriangulation& in, AnyTriangleId t) {
    clear();
    triangles_.push_back(t);
    for (unsigned i = 3; i-- > 0;) pending_.push_back(in.side(t, i));
  }
  /// Start anew with the two triangles on both sides of an edge.
  void start(const GhostTriangulation& in, SideId edge) {
    clear();
    const SideId twin = in.twin(edge);
    triangles_.push_back(in.triangle(edge));
    triangles_.push_back(in.triangle(twin));
    for (const SideId s : {twin, edge}) {
      pending_.push_back(in.previous(s));
      pending_.push_back(in.next(s));
    }
  }

  /// Grow over every side that crosses(side) says the new vertex takes down.
  ///
  /// crosses(s)  asked once for each side met from within; true only where the disc stays star-shaped
  template <class Crosses>
  void grow(const GhostTriangulation& in, const Crosses& crosses) {
    while (!pending_.empty()) {
      const SideId inner = pending_.back();
      pending_.pop_back();
      const SideId outer = in.twin(inner);
      if (crosses(inner)) {
        triangles_.push_back(in.triangle(outer));
        pending_.push_back(in.previous(outer));
        pending_.push_back(in.next(outer));
      } else {
        border_.push_back({inner, outer, in.origin(inner), in.destination(inner)});
      }
    }
    assert(border_.size() == triangles_.size() + 2);
  }

  /// Replace the cavity by the fan of triangles from v to its border; two triangles more than before.
  void fill(GhostTriangulation& in, VertexId v) {
    constexpr VertexId ghost = GhostTriangulation::ghost;
    while (triangles_.size() < border_.size()) triangles_.push_back(in.add(v, v, v));
    SideId last_open{};  // the side of the previous fan triangle that awaits its twin
    SideId first_open{};
    for (std::size_t i = 0; i < border_.size(); ++i) {
      Border& b = border_[i];
      const AnyTriangleId t = triangles_[i];
      unsigned apex = 0;  // corner of t that is v; the ghost has to be corner 0
      if (b.from == ghost) {
        in.set_corners(t, b.from, b.to, v);
        apex = 2;
      } else if (b.to == ghost) {
        in.set_corners(t, b.to, v, b.from);
        apex = 1;
      } else {
        in.set_corners(t, v, b.from, b.to);
      }
      b.inner = in.side(t, apex);
      in.link(b.inner, b.outer);
      const SideId towards_from = in.side(t, (apex + 2) % 3);  // v -> from
      if (i == 0)
        first_open = towards_from;
      else
        in.link(towards_from, last_open);
      last_open = in.side(t, (apex + 1) % 3);  // to -> v
    }
    in.link(first_open, last_open);
  }

 private:
  void clear() {
    triangles_.clear();
    border_.clear();
    pending_.clear();
  }
  std::vector<AnyTriangleId> triangles_;
  std::vector<Border> border_;
  std::vector<SideId> pending_;
};

}  // namespace leonhard::delaunay
