// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/faces.hpp"
#include "leonhard/mesh/tet_edges.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// Whether edges and faces that are given beside a mesh are those of this mesh. All throw InputError naming the first
/// edge, face or entry that is not.
namespace leonhard::mesh {

/// Every edge has a triangle, and every triangle on its sides is one of the mesh with both ends as corners, on that side.
/// Edges may be missing. Cost O(edges).
void require_edges_within(const TriangleMesh& mesh, const EdgeStructure& edges);

/// The edges are what build_edges makes of the mesh, and the ends of its boundary are vertices.
/// Cost O(edges + boundary).
void require_edges_of(const TriangleMesh& mesh, const EdgeStructure& edges);

/// Every face has a tetrahedron, and every one on its sides is one of the mesh with its three corners. Faces may be missing.
/// Cost O(faces).
void require_faces_within(const TetMesh& mesh, const FaceStructure& faces);

/// The edges are vertices of the mesh two by two, sorted, with rows to match. Whether they are edges of a tetrahedron is
/// left to the caller. Cost O(edges).
void require_edge_list_of(const TetMesh& mesh, const TetEdges& edges);

/// The corners of the boundary are vertices. Cost O(boundary).
void require_boundary_within(const TetMesh& mesh);

/// "edges: edge 17, from vertex 3 to 8, is none of the mesh's".
[[noreturn]] void throw_foreign_edge(EdgeId e, const std::array<VertexId, 2>& ends);

}  // namespace leonhard::mesh
