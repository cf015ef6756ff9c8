// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// The first broken invariant of a mesh in words, with ids and coordinates; none if all hold. In this order:
/// - neighbours and regions have one entry a cell, vertex_markers one a vertex
/// - points are finite
/// - corners are vertices, all different in a cell
/// - every vertex has a cell
/// - every triangle is counter-clockwise by exact orient2d, every tetrahedron positive by exact orient3d
/// - no edge has three triangles and no face three tetrahedra, or two on the same side
/// - neighbours are exactly the cells that share such a facet
/// - boundary has the facets with one cell, each once: the mesh to the left of an edge, the normal of a face outwards
/// - constraints, interfaces lie between two cells
///
/// Cost O(vertices + cells + boundary log boundary).
template <int Dim>
[[nodiscard]] std::optional<std::string> validate(const SimplexMesh<Dim>& mesh);

/// The same of a mesh of mixed cells. In this order:
/// - corners and regions have one entry a cell, vertex_markers one a vertex
/// - kinds are those of this dimension, each row of corners as long as its kind asks
/// - corners of cells and marked facets are vertices; points are finite; no cell and no marked facet has a vertex twice
/// - every vertex has a cell
/// - every cell is positive. In the plane: at each corner it turns counter-clockwise by exact orient2d, so that a
///   quadrilateral is strictly convex. In space: at each corner of three edges the tetrahedron of the corner and the ends
///   of the edges, in the cell's own order, is positive by exact orient3d: the corner Jacobians of Knupp (SIAM J. Sci.
///   Comput. 23, 2001), at all corners but a pyramid's apex. For a cell of flat faces this says that it is convex at each of
///   them; where faces of four vertices bend, it is needed for the cell to be an image of the unit cell, not enough
/// - no facet has three cells, or two on the same side
/// - in space no face of four vertices meets a face of three of them, or of all four in another order (non-conforming)
/// - boundary has the facets with one cell, each once: the mesh to the left of an edge, the normal of a face outwards
/// - inner_facets lie between two cells
///
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] std::optional<std::string> validate(const MixedMesh<Dim>& mesh);

/// The first edge (of triangles) or face (of tetrahedra) that is not locally Delaunay, in words: the opposite corner of
/// one of its cells lies strictly inside the circumcircle or circumsphere of the other, by exact incircle or insphere.
/// Facets in mesh.constraints or mesh.interfaces are excepted.
///
/// A triangle mesh that passes, and whose boundary and constraints are taken as given, is constrained Delaunay
/// (Delaunay's lemma; Barth's notes 3.2, Lee and Lin 1986 for constraints). A tetrahedral one that passes, and that fills
/// the convex hull of its points (validate_convex), is a Delaunay tetrahedralisation of them; one of which neither is
/// known is locally Delaunay, no more.
///
/// mesh    `validate` finds nothing wrong with it
/// Cost O(cells), and O(inner facets log inner facets) where a facet fails.
template <int Dim>
[[nodiscard]] std::optional<std::string> validate_delaunay(const SimplexMesh<Dim>& mesh);

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

/// Whether tetrahedra overlap although each one is positive: the words for the first place found, none if the mesh lies
/// properly in space.
///
/// mesh    `validate` finds nothing wrong with it
///
/// Argument. As in the plane, the number of tetrahedra over a place off the faces is the winding number of the boundary
/// about it, and the mesh lies properly if that is 0 or 1 everywhere. First no two boundary faces may meet but in common
/// corners and edges, or be the same (touching back to back); corners are common if their coordinates are equal. Then
/// the number just inside the boundary is the same all over a patch of faces that hang together by edges, and is found
/// at one place a patch, infinitesimally near a face; if it is 1 on every patch, no place is covered twice. All by
/// comparisons, exact orient3d and orient2d; no place is computed.
///
/// Parts of the boundary may touch in vertices, edges and faces, shared or of equal coordinates; a vertex inside another
/// boundary edge or face is reported (a hanging node).
///
/// Cost O(tetrahedra + boundary log boundary) where boundary faces are about as large as their distances.
[[nodiscard]] std::optional<std::string> validate_embedding(const TetMesh& mesh);

/// The same of mixed cells: of the triangles or tetrahedra that split_cells cuts them into, after whose numbers the words name
/// them. Exact in the plane, since quadrilaterals that pass `validate` are strictly convex. In space faces of four vertices are
/// taken as two triangles each; words "nothing is proved" name a cell that cannot be cut.
template <int Dim>
[[nodiscard]] std::optional<std::string> validate_embedding(const MixedMesh<Dim>& mesh);

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
