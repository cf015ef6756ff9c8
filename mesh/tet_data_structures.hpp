// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/faces.hpp"
#include "leonhard/mesh/tet_edges.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

/// The data structures of Barth's notes 1.3 that extend to space, and the ways between them. With V vertices, E edges, F
/// faces, T tetrahedra, and d the largest number of tetrahedra about a vertex:
///
///   from \ to      TetMesh             FaceStructure        TetEdges
///   TetMesh (FE)   -                   build_faces          build_edges
///                                      O(V + T log d)       O(V + T + E log d)
///   FaceStructure  tet_mesh            -                    build_edges
///                  O(V + T log d)                           O(V + F + E log d)
///   TetEdges       no way              no way               -
///
/// The edges of a tetrahedral mesh, without more, do not say which of them span tetrahedra, and no order about a vertex
/// helps out as it does in the plane. The notes leave the out-degree and the quad-edge structure to the plane.
///
/// Vertices and tetrahedra keep their numbers on every way. Only the mesh has markers, regions and names; whoever goes
/// round in a circle copies them.
namespace leonhard::mesh {

/// A checked mesh from its faces.
///
/// faces    with the tetrahedra on their sides, which are numbered 0 .. T-1
/// points   one a vertex, finite
/// marker   of all boundary faces
/// returns  the mesh, the corners of every tetrahedron ascending but for the last two where that makes it positive;
///          boundary in the order of faces
/// throws   InputError, naming the tetrahedron, where a tetrahedron's sides are not the four faces of four vertices,
///          directed outwards; and as make_tet_mesh does
[[nodiscard]] TetMesh tet_mesh(const FaceStructure& faces, const PerId<VertexId, Point3>& points,
                               Marker marker = 1);

}  // namespace leonhard::mesh
