// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/triangle_mesh.hpp"
#include "leonhard/solver/gas.hpp"

namespace leonhard::app {

/// dv/dx - du/dy at each vertex, in speeds of sound over the mesh's unit: the mean, weighted by their areas, of the triangles
/// about it, on each of which the velocity is linear. Cost O(triangles).
[[nodiscard]] std::vector<double> vorticity(const TriangleMesh& mesh, const PerId<VertexId, State<2>>& states);

}  // namespace leonhard::app
