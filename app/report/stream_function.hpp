// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"
#include "leonhard/solver/gas.hpp"

namespace leonhard::app {

/// The stream function of a steady flow at each vertex, in units of rho_inf c_inf times the mesh's unit: its contour lines are
/// streamlines, and between two of them flows their difference, to the right of the way along which it rises. 0 at `zero`.
///
/// edges   of this mesh
/// Method: least squares of the edges' differences against the mass that crosses them, each weighted by the inverse of its length squared;
/// conjugate gradients from the sums along a tree. Cost O(edges) an iteration, up to some thousands.
[[nodiscard]] std::vector<double> stream_function(const TriangleMesh& mesh, const EdgeStructure& edges,
                                                  const PerId<VertexId, State<2>>& states, VertexId zero);

/// The size of the density's gradient at each vertex, by the mean of the triangles about it, weighted by their areas. Cost O(triangles).
[[nodiscard]] std::vector<double> density_slopes(const TriangleMesh& mesh, const PerId<VertexId, State<2>>& states);

}  // namespace leonhard::app
