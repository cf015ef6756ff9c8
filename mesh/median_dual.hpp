// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/dual_metrics.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/tet_edges.hpp"

namespace leonhard::mesh {

/// The median dual's metrics (Barth's notes 1.2, figure 1.2.0): about each vertex the region bounded, in each of its
/// cells, by the pieces that join the midpoints of edges, in space the centroids of faces, and the cell's centroid; on the
/// boundary by its halves of the boundary edges or its thirds of the boundary faces. A face of the dual bends at its edge's
/// midpoint. A volume is a third of the vertex's triangles' or a quarter of its tetrahedra's.
///
/// edges   of this mesh, from build_edges
/// throws  InputError naming the first edge that is none of the mesh's, or what is missing
/// Closed to rounding: about each vertex the outward normals and boundary parts add up to zero, the volumes add up to the
/// mesh's. All values are made of differences of coordinates, never of centroids' absolute positions, so a mesh far from
/// the origin keeps its digits.
///
/// In the plane an interior normal is (o_left - o_right)/3 turned clockwise by a right angle, o being the corners opposite
/// the edge. In space the part of edge ab's normal within the positive tetrahedron abcd is half the cross product of the
/// quadrilateral's diagonals, from the edge's midpoint to the tetrahedron's centroid and from one face's centroid to the
/// other's, ((c - a) + (d - b)) x (d - c) / 24.
/// Cost O(edges + triangles), O(tetrahedra log degree).
[[nodiscard]] DualMetrics<2> median_dual(const TriangleMesh& mesh, const EdgeStructure& edges);
[[nodiscard]] DualMetrics<3> median_dual(const TetMesh& mesh, const TetEdges& edges);

}  // namespace leonhard::mesh
