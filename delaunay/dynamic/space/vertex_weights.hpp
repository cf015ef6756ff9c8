// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/delaunay/location.hpp"
#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_conflict_zone.hpp"
#include "leonhard/kernel/point.hpp"

/// Points of space as convex combinations of vertices, as precise as in the plane (dynamic/plane/vertex_weights.hpp).
namespace leonhard::delaunay {

/// Barycentric coordinates in the segment, triangle or tetrahedron that holds a point strictly inside.
///
/// points   all vertices by id
/// at       where p lies
/// weights  receives one entry a vertex of `at`, in its order; none unless p is inside
void barycentric_weights(std::span<const Point3> points, const TetLocation& at, const Point3& p,
                         std::vector<VertexWeight>& weights);

/// Sibson's weights of a point: the volume that each neighbour's Voronoi cell would lose to the point's own.
///
/// p        strictly inside the convex hull, at no vertex
/// zone     what an insertion of p destroys
/// weights  receives one entry for each corner of the zone, in rising order; some are 0 where vertices are cospherical
///
/// Method. What a vertex v loses is a convex polyhedron whose corners are circumcentres: of the zone's tetrahedra at v and
/// of the cones that p would make with the zone's walls at v. It is summed up from cones with the apex v over its faces,
/// one on each bisector of v with a vertex next to it or with p, each of these from triangles over the face's edges. An
/// edge lies between two tetrahedra of the zone, or between one and a cone, or between two cones, so that every pair of
/// these adds its part to the vertices that both have: no face has to be put together.
/// Cost O(k log k) for k tetrahedra in the zone: some microseconds; a hundred times that in rationals.
void sibson_weights(const GhostTetrahedralization& in, std::span<const Point3> points,
                    const TetConflictZone& zone, const Point3& p, std::vector<VertexWeight>& weights);

/// Sibson's weights in a plane of the hull, the limit of those in space: among the vertices in that plane, by areas.
///
/// p        on the hull, strictly inside the part of it that lies in one plane
/// zone     what an insertion of p destroys: its ghosts lie in that plane
/// weights  receives one entry for each corner of the ghosts, in rising order
void sibson_weights_on_hull(const GhostTetrahedralization& in, std::span<const Point3> points,
                            const TetConflictZone& zone, const Point3& p, std::vector<VertexWeight>& weights);

}  // namespace leonhard::delaunay
