// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// Twice the sum of the triangles' signed areas, exact. Reads corners and points only.
/// throws InputError on a corner that is no vertex and a coordinate that is not finite. Cost O(triangles), some tens of nanoseconds each.
[[nodiscard]] mpq_class exact_area2(const TriangleMesh& mesh);

/// Twice the area that mesh.boundary encloses (the mesh on its left), exact. Equals exact_area2 for every
/// mesh whose boundary is complete. Cost O(boundary).
[[nodiscard]] mpq_class exact_boundary_area2(const TriangleMesh& mesh);

}  // namespace leonhard::mesh
