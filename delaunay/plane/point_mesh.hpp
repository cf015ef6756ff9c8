// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/delaunay/order/sorted_points.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

struct PointMesh {
  TriangleMesh mesh;
  std::vector<MaybeId<VertexId>> vertex_of_input;  ///< one an input point, never none; duplicates share one
};

/// The triangulation of a point set as a mesh. Vertices are numbered in the order of the input points that made them;
/// boundary edges, marker 1, run counter-clockwise from the vertex of the lowest number on the hull.
///
/// cells   at least one real triangle; its vertices are sorted's points
/// sorted  of `input`; its points may be gone
/// input   becomes the mesh's points
/// threads  0: as many as there are cores; the answer does not depend on it
/// Memory is given back as soon as it is not needed: at most 90 bytes a point beyond `input` with what is taken over.
[[nodiscard]] PointMesh to_mesh(GhostTriangulation cells, SortedPoints sorted, std::vector<Point2> input,
                                unsigned threads);

}  // namespace leonhard::delaunay
