// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// What a mesh needs so that nothing reads beyond the end of an array: one entry a cell in neighbours and regions, one a
/// vertex in vertex_markers, and no id in corners, neighbours, boundary, constraints or interfaces that is out of range.
/// Much less than `validate` asks, and much cheaper: whatever takes a mesh from outside may call it first.
///
/// throws  InputError naming the array or the entry
/// Cost O(vertices + cells + boundary), some nanoseconds each.
void require_ids_in_range(const TriangleMesh& mesh);
void require_ids_in_range(const TetMesh& mesh);

/// The corners alone: all that a sum over cells reads.
void require_corners_in_range(const TriangleMesh& mesh);
void require_corners_in_range(const TetMesh& mesh);

}  // namespace leonhard::mesh
