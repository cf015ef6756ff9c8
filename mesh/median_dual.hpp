// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/dual_metrics.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// Control volumes of the median dual (Barth's notes 1.2, figure 1.2.0): about each vertex the region bounded
/// by the lines from the midpoints of its edges to the centroids of its triangles, and on the boundary by its
/// halves of the boundary edges. A face bends at its edge's midpoint; an area is a third of the vertex's triangles'.
using MedianDual = DualMetrics;

namespace mesh {

/// The median dual's metrics.
///
/// edges   of this mesh, from build_edges
/// throws  InputError naming the first edge that is none of the mesh's, or what is missing
/// Closed to rounding: about each vertex the outward normals and boundary halves add up to zero, the areas
/// add up to the mesh's. All values are made of differences of coordinates, never of centroids' absolute
/// positions, so a mesh far from the origin keeps its digits: an interior normal is (o_left - o_right)/3
/// turned clockwise by a right angle, o being the corners opposite the edge. Cost O(edges + triangles).
[[nodiscard]] MedianDual median_dual(const TriangleMesh& mesh, const EdgeStructure& edges);

}  // namespace mesh
}  // namespace leonhard
