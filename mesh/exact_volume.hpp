// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::mesh {

/// Six times the sum of the tetrahedra's signed volumes, exact: of each the determinants of its four faces, directed
/// outwards, which add up to that of b - a, c - a, d - a. Reads corners and points only. throws InputError on a corner that
/// is no vertex and a coordinate that is not finite. Cost O(tetrahedra), some hundred nanoseconds each.
[[nodiscard]] mpq_class exact_volume6(const TetMesh& mesh);

/// Six times the volume that mesh.boundary encloses (normals pointing outwards), exact. Equals exact_volume6 for every
/// mesh whose boundary is complete. Cost O(boundary).
[[nodiscard]] mpq_class exact_boundary_volume6(const TetMesh& mesh);

}  // namespace leonhard::mesh
