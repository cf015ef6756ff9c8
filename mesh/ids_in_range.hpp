// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// What a mesh needs so that nothing reads beyond the end of an array: one entry a cell in neighbours and regions, one a
/// vertex in vertex_markers, and no id in corners, neighbours, boundary and inner facets that is out of range. Much less
/// than `validate` asks, and much cheaper: whatever takes a mesh from outside may call it first.
///
/// throws  InputError naming the array or the entry
/// Cost O(vertices + cells + boundary), some nanoseconds each.
template <int Dim>
void require_ids_in_range(const SimplexMesh<Dim>& mesh);

/// The corners alone: all that a sum over cells reads.
template <int Dim>
void require_corners_in_range(const SimplexMesh<Dim>& mesh);

/// The boundary alone: all that a sum over it reads.
template <int Dim>
void require_boundary_in_range(const SimplexMesh<Dim>& mesh);

extern template void require_ids_in_range(const SimplexMesh<2>&);
extern template void require_ids_in_range(const SimplexMesh<3>&);
extern template void require_corners_in_range(const SimplexMesh<2>&);
extern template void require_corners_in_range(const SimplexMesh<3>&);
extern template void require_boundary_in_range(const SimplexMesh<2>&);
extern template void require_boundary_in_range(const SimplexMesh<3>&);

}  // namespace leonhard::mesh
