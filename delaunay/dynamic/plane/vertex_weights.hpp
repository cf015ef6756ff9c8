// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/delaunay/location.hpp"
#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

/// Points as convex combinations of vertices.
///
/// Weights are not negative and sum to 1 but for rounding. They are evaluated in floating point, and once
/// more in rational arithmetic, rounded last, where the combination misses the point by more than 2^-33 of
/// the distances that it sums: slivers, coordinates whose squares leave the range of double, points next to a
/// vertex or the hull.
namespace leonhard::delaunay {

/// Linear interpolation between two vertices.
///
/// points  all vertices by id
/// p       on the segment from a to b
/// weights receives two entries
void edge_weights(std::span<const Point2> points, VertexId a, VertexId b, Point2 p,
                  std::vector<VertexWeight>& weights);

/// Barycentric coordinates.
///
/// p       in the triangle a, b, c
/// weights receives three entries
void triangle_weights(std::span<const Point2> points, VertexId a, VertexId b, VertexId c, Point2 p,
                      std::vector<VertexWeight>& weights);

/// Sibson's weights of a point: the area that each neighbour's Voronoi cell would lose to the point's own.
///
/// p       strictly inside the convex hull, at no vertex
/// cavity  the triangles that an insertion of p destroys, before it is filled
/// weights receives one entry for each vertex of its border, counter-clockwise; some are 0 where vertices are
/// cocircular
/// Method: R. Sibson, "A brief description of natural neighbour interpolation", in V. Barnett (ed.),
/// Interpreting Multivariate Data (1981); the cells' corners are circumcentres of the destroyed triangles and
/// of those that would replace them (Watson 1992). Cost O(cavity): some hundred nanoseconds; tens of
/// microseconds in rationals.
void sibson_weights(const GhostTriangulation& in, std::span<const Point2> points, const Cavity& cavity,
                    Point2 p, std::vector<VertexWeight>& weights);

}  // namespace leonhard::delaunay
