// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// Vertices on one line, or fewer than two, in lexicographic order: the triangulation of points that span no
/// triangle.
class CollinearPoints {
  /// The foot of a perpendicular to the line, compared with points on it without being computed.
  struct Foot {
    Point2 of, last;
  };
  struct Order {
    using is_transparent = void;
    bool operator()(Point2 a, Point2 b) const { return a < b; }
    bool operator()(Point2 a, const Foot& foot) const;
  };
  using Map = std::map<Point2, VertexId, Order>;

 public:
  using const_iterator = Map::const_iterator;

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] bool empty() const { return vertices_.empty(); }
  [[nodiscard]] const_iterator begin() const { return vertices_.begin(); }  ///< of pairs (point, vertex)
  [[nodiscard]] const_iterator end() const { return vertices_.end(); }
  [[nodiscard]] Point2 first() const { return vertices_.begin()->first; }
  [[nodiscard]] Point2 last() const { return vertices_.rbegin()->first; }

  /// Whether the points and p lie on one line.
  [[nodiscard]] bool collinear_with(Point2 p) const;
  [[nodiscard]] MaybeId<VertexId> find(Point2 p) const;
  /// The vertices before and after p in lexicographic order, p itself left out.
  [[nodiscard]] std::array<MaybeId<VertexId>, 2> around(Point2 p) const;
  /// The vertex nearest to any point of the plane, the lexicographically first of two; none if there is none.
  /// Cost O(log n).
  [[nodiscard]] MaybeId<VertexId> nearest(Point2 p) const;

  /// p must be collinear_with the points and none of them.
  void insert(Point2 p, VertexId v) { vertices_.emplace(p, v); }
  void erase(Point2 p) { vertices_.erase(p); }
  void clear() { vertices_.clear(); }

 private:
  Map vertices_;
};

}  // namespace leonhard::delaunay
