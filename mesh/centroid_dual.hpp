// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/dual_metrics.hpp"

namespace leonhard::mesh {

/// The centroid dual (Barth's notes 1.2): straight segments between the centroids of neighbouring triangles, and from a
/// boundary edge's midpoint to its triangle's centroid. Its normals are the median dual's, whose faces have the same
/// ends; its areas are not. The segment between two centroids may pass beside the edge: an area is the right one as
/// long as the cell, so bounded, is simple, and the areas always add up to the mesh's.
///
/// edges   of this mesh, from build_edges
/// throws  InputError for edges of another mesh
/// Cost O(edges + triangles).
[[nodiscard]] DualMetrics<2> centroid_dual(const TriangleMesh& mesh, const EdgeStructure& edges);

}  // namespace leonhard::mesh
