// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "leonhard/delaunay/space/first_tetrahedron.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// Vertices in one plane, on one line or fewer, in lexicographic order: all there is to know of points that span no
/// tetrahedron.
class CoplanarPoints {
  /// The foot of a perpendicular to the line, compared with points on it without being computed.
  struct Foot {
    Point3 of, last;
  };
  struct Order {
    using is_transparent = void;
    bool operator()(const Point3& a, const Point3& b) const { return a < b; }
    bool operator()(const Point3& a, const Foot& foot) const;
  };
  using Map = std::map<Point3, VertexId, Order>;

 public:
  using const_iterator = Map::const_iterator;

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] bool empty() const { return vertices_.empty(); }
  [[nodiscard]] const_iterator begin() const { return vertices_.begin(); }  ///< of pairs (point, vertex)
  [[nodiscard]] const_iterator end() const { return vertices_.end(); }
  [[nodiscard]] Extent extent() const { return basis_.extent; }  ///< never space

  /// Whether p lies in what the points span: the plane, the line or the place; never if there are none.
  [[nodiscard]] bool spans(const Point3& p) const;
  [[nodiscard]] MaybeId<VertexId> find(const Point3& p) const;
  /// The vertex nearest to any point of space, the lexicographically first of several; none if there is none.
  /// Cost O(n); O(log n) while all lie on one line.
  [[nodiscard]] MaybeId<VertexId> nearest(const Point3& p) const;

  /// p must be none of the points, and they with it must not span space. Cost O(log n).
  void insert(const Point3& p, VertexId v);
  /// Cost O(log n), O(n) for a few points that mark out the span.
  void erase(const Point3& p);
  void clear() { *this = {}; }

 private:
  void find_basis();

  Map vertices_;
  FirstTetrahedron basis_;              // of basis_points_
  std::array<Point3, 4> basis_points_;  // that span what all do
};

}  // namespace leonhard::delaunay
