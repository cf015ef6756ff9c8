// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic/plane/vertex_weights.hpp"

#include <gmpxx.h>

#include <cmath>

#include "leonhard/delaunay/dynamic/weights_by_shares.hpp"

namespace leonhard::delaunay {
namespace {

/// A vector whose coordinates are doubles or rationals.
template <class Number>
struct Vector {
  Number x, y;
};

template <class Number>
Vector<Number> difference(Point2 a, Point2 b) {
  return {Number(a.x) - Number(b.x), Number(a.y) - Number(b.y)};
}
template <class Number>
Number cross(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

/// The circumcentre of 0, u and v.
template <class Number>
Vector<Number> circumcentre(const Vector<Number>& u, const Vector<Number>& v) {
  const Number uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y, twice_cross = 2 * cross(u, v);
  return {(uu * v.y - vv * u.y) / twice_cross, (vv * u.x - uu * v.x) / twice_cross};
}

/// The areas that the vertices of the border lose, times two; the origin is the point that takes them.
template <class Number>
class StolenAreas {
 public:
  StolenAreas(const GhostTriangulation& in, std::span<const Point2> points, const Cavity& cavity, Point2 p)
      : in_(in), points_(points), p_(p) {
    const std::vector<Cavity::Border>& border = cavity.border();
    std::vector<Vector<Number>> new_centres;
    for (const Cavity::Border& b : border) new_centres.push_back(circumcentre(arm(b.from), arm(b.to)));
    for (std::size_t i = 0; i < border.size(); ++i) {
      const std::size_t before = i == 0 ? border.size() - 1 : i - 1;
      areas_.push_back(area(border[before].inner, border[i].inner, new_centres[before], new_centres[i]));
    }
  }
  [[nodiscard]] const std::vector<Number>& areas() const { return areas_; }

 private:
  [[nodiscard]] Vector<Number> arm(VertexId v) const { return difference<Number>(points_[v.index()], p_); }

  /// The centre of a triangle's circle, from a corner of it.
  [[nodiscard]] Vector<Number> old_centre(SideId side) const {
    const Point2 a = points_[in_.origin(side).index()];
    const Point2 b = points_[in_.destination(side).index()], c = points_[in_.apex(side).index()];
    return circumcentre(difference<Number>(b, a), difference<Number>(c, a));
  }

  /// Twice the area of the polygon between the bisector with p, on which lie the two new centres, and the old
  /// centres about the origin of `out`; `in` is the border's side that ends there. Taken about the vertex.
  [[nodiscard]] Number area(SideId in, SideId out, const Vector<Number>& before,
                            const Vector<Number>& after) const {
    const Vector<Number> v = arm(in_.origin(out));
    const auto from_vertex = [&](const Vector<Number>& c) { return Vector<Number>{c.x - v.x, c.y - v.y}; };
    Vector<Number> last = from_vertex(after);
    Number sum = cross(from_vertex(before), last);
    SideId side = out;
    while (true) {
      const Vector<Number> centre = old_centre(side);
      sum += cross(last, centre);
      last = centre;
      if (in_.previous(side) == in) break;
      side = in_.turn_about_origin(side);
    }
    return sum + cross(last, from_vertex(before));
  }

  const GhostTriangulation& in_;
  std::span<const Point2> points_;
  Point2 p_;
  std::vector<Number> areas_;
};

}  // namespace

void edge_weights(std::span<const Point2> points, VertexId a, VertexId b, Point2 p,
                  std::vector<VertexWeight>& weights) {
  weights.assign({{a, 0}, {b, 0}});
  const Point2 from = points[a.index()], to = points[b.index()];
  // Lengths along the axis nearer to the edge's direction: all have one sign, and the sum is not 0.
  const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  const auto lengths = [&]<class Number>(Number) {
    const auto along = [&](Point2 q) { return Number(steep ? q.y : q.x); };
    return std::vector<Number>{along(to) - along(p), along(p) - along(from)};
  };
  weigh_by_shares(points, p, lengths, weights);
}

void triangle_weights(std::span<const Point2> points, VertexId a, VertexId b, VertexId c, Point2 p,
                      std::vector<VertexWeight>& weights) {
  weights.assign({{a, 0}, {b, 0}, {c, 0}});
  const auto areas = [&]<class Number>(Number) {
    const auto arm = [&](VertexId v) { return difference<Number>(points[v.index()], p); };
    const Vector<Number> u = arm(a), v = arm(b), w = arm(c);
    return std::vector<Number>{cross(v, w), cross(w, u), cross(u, v)};
  };
  weigh_by_shares(points, p, areas, weights);
}

void sibson_weights(const GhostTriangulation& in, std::span<const Point2> points, const Cavity& cavity,
                    Point2 p, std::vector<VertexWeight>& weights) {
  weights.clear();
  for (const Cavity::Border& b : cavity.border()) weights.push_back({b.from, 0});
  const auto areas = [&]<class Number>(Number) { return StolenAreas<Number>(in, points, cavity, p).areas(); };
  weigh_by_shares(points, p, areas, weights);
}

}  // namespace leonhard::delaunay
