// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// The first broken invariant of TriangleMesh in words, with ids and coordinates; none if all hold. In this order:
/// - neighbours and regions have one entry a triangle, vertex_markers one a vertex
/// - points are finite
/// - corners are vertices, three different ones a triangle
/// - every vertex has a triangle
/// - every triangle is counter-clockwise by exact orient2d
/// - no edge has three triangles, or two on the same side
/// - neighbours are exactly the triangles that share an edge
/// - boundary has the edges with one triangle, each once, the mesh on the left
/// - constraints are interior edges
///
/// Cost O(vertices + triangles + boundary log boundary).
[[nodiscard]] std::optional<std::string> validate(const TriangleMesh& mesh);

/// Whether triangles overlap although each one is positive: the words for the first place found, none if the
/// mesh lies properly in the plane.
///
/// mesh    `validate` finds nothing wrong with it
///
/// Argument: where all triangles are positive, the number of triangles over a point off the edges is the winding
/// number of the mesh's boundary about it (interior edges cancel; the degree of a map from its boundary). So no
/// two triangles overlap if and only if the boundary's winding number is 0 or 1 everywhere. A sweep over the
/// boundary edges in lexicographic order (Shamos and Hoey, FOCS 1976) finds edges that cross, overlap or carry
/// another's vertex, and where there are none reads off the winding number above and below every edge. Before that
/// each vertex is asked whether its triangles cover a direction twice, because this names the culprit better. All
/// by comparisons and exact orient2d.
///
/// Boundary edges may meet in vertices, shared or of equal coordinates, and two of equal coordinates may lie back
/// to back (a slit); a vertex inside another boundary edge is reported (a hanging node).
///
/// Cost O(triangles + boundary log boundary).
[[nodiscard]] std::optional<std::string> validate_embedding(const TriangleMesh& mesh);

/// The first edge that is not locally Delaunay, in words: the opposite corner of one of its triangles lies
/// strictly inside the circumcircle of the other, by exact incircle. Edges in mesh.constraints are excepted.
/// A mesh that passes, and whose boundary and constraints are taken as given, is constrained Delaunay
/// (Delaunay's lemma; Barth's notes 3.2, Lee and Lin 1986 for constraints).
///
/// mesh    `validate` finds nothing wrong with it
/// Cost O(triangles), and O(constraints log constraints) where an edge fails.
[[nodiscard]] std::optional<std::string> validate_delaunay(const TriangleMesh& mesh);

// ---- tetrahedra ----

/// The first broken invariant of TetMesh in words, with ids and coordinates; none if all hold. In this order:
/// - neighbours and regions have one entry a tetrahedron, vertex_markers one a vertex
/// - points are finite
/// - corners are vertices, four different ones a tetrahedron
/// - every vertex has a tetrahedron
/// - every tetrahedron is positive by exact orient3d
/// - no face has three tetrahedra, or two on the same side
/// - neighbours are exactly the tetrahedra that share a face
/// - boundary has the faces with one tetrahedron, each once, the normal pointing outwards
/// - interfaces lie between two tetrahedra
///
/// Cost O(vertices + tetrahedra + boundary log boundary).
[[nodiscard]] std::optional<std::string> validate(const TetMesh& mesh);

/// The first face that is not locally Delaunay, in words: the opposite corner of one of its tetrahedra lies strictly
/// inside the circumsphere of the other, by exact insphere. Faces in mesh.interfaces are excepted. A mesh that passes,
/// and that fills the convex hull of its points (validate_convex), is a Delaunay tetrahedralisation of them (Delaunay's
/// lemma); one of which neither is known is locally Delaunay, no more.
///
/// mesh    `validate` finds nothing wrong with it
/// Cost O(tetrahedra), and O(interfaces log interfaces) where a face fails.
[[nodiscard]] std::optional<std::string> validate_delaunay(const TetMesh& mesh);

/// Whether the tetrahedra fill the convex hull of the points, each place once: the words for the first thing that speaks
/// against it, none if they do.
///
/// mesh    `validate` finds nothing wrong with it
///
/// Argument. Where all tetrahedra are positive, the number of them over a place is the winding number of the boundary
/// about it (inner faces cancel). Take a place o strictly inside some tetrahedron. If no other one holds it, the winding
/// number about o is 1. If o lies strictly behind every boundary face, the rays from o meet each face from behind, so the
/// boundary winds about o as often as a ray meets it: once. So the boundary is the surface of a set star-shaped about o,
/// which the tetrahedra fill, each place once. If no edge of the surface is reflex, the set is convex (Tietze and
/// Nakajima). All by exact orient3d; o is the rounded centroid of a tetrahedron of large volume, and the exact signs say
/// whether it is strictly inside.
///
/// Words "no place found" mean that every tetrahedron is too thin to hold a place whose coordinates are doubles near its
/// centroid: then nothing is proved.
/// Cost O(tetrahedra + boundary log boundary).
[[nodiscard]] std::optional<std::string> validate_convex(const TetMesh& mesh);

}  // namespace leonhard::mesh
