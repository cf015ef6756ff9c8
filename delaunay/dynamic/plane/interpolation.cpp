// SPDX-License-Identifier: MIT
#include <algorithm>

#include "leonhard/delaunay/dynamic/plane/vertex_weights.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/topology/conflict.hpp"

namespace leonhard::delaunay {

/// Whether one of the two triangles at an edge is a ghost.
bool DynamicTriangulation::on_hull(SideId side) const {
  return triangles_.is_ghost(triangles_.triangle(side)) ||
         triangles_.is_ghost(triangles_.triangle(triangles_.twin(side)));
}

/// Weights of the corners of the vertex, edge or triangle that holds p.
void DynamicTriangulation::weigh(Point2 p, const PointLocation& at,
                                 std::vector<VertexWeight>& weights) const {
  weights.clear();
  const auto& v = at.vertices;
  switch (at.kind) {
    case PointLocation::Kind::outside:
      return;
    case PointLocation::Kind::on_vertex:
      weights.push_back({*v[0], 1});
      return;
    case PointLocation::Kind::on_edge:
      return edge_weights(points_.flat(), *v[0], *v[1], p, weights);
    case PointLocation::Kind::in_triangle:
      return triangle_weights(points_.flat(), *v[0], *v[1], *v[2], p, weights);
  }
}

PointLocation::Kind DynamicTriangulation::find_linear_weights(Point2 p, Search& search) const {
  const PointLocation at = locate_from(p, search);
  weigh(p, at, search.weights);
  return at.kind;
}

PointLocation::Kind DynamicTriangulation::find_natural_weights(Point2 p, Search& search) const {
  if (extent() != Extent::plane) return find_linear_weights(p, search);
  const Location found = find(p, search);
  const PointLocation at = answer(found);
  const bool has_cell = at.kind == PointLocation::Kind::in_triangle ||
                        (at.kind == PointLocation::Kind::on_edge && !on_hull(found.side));
  if (!has_cell) {
    weigh(p, at, search.weights);
    return at.kind;
  }
  // On an edge, start from the same one of its triangles whatever the way here was: sums are the same to the
  // bit.
  const SideId twin = triangles_.twin(found.side);
  const SideId side = at.kind == PointLocation::Kind::on_edge ? std::min(found.side, twin) : found.side;
  search.cavity.start(triangles_, triangles_.triangle(side));
  search.cavity.grow(triangles_, [&](SideId inner) {
    return in_conflict(triangles_, points_.flat(), triangles_.triangle(triangles_.twin(inner)), p);
  });
  sibson_weights(triangles_, points_.flat(), search.cavity, p, search.weights);
  return at.kind;
}

}  // namespace leonhard::delaunay
