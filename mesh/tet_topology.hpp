// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::mesh {

/// Fill mesh.neighbours from mesh.corners: neighbours[t][i] is the tetrahedron across the face opposite corners[t][i],
/// none on the boundary. Coordinates, markers, boundary and interfaces are not read.
///
/// throws  InputError, mesh unchanged, on a corner that is no vertex, a tetrahedron that names a vertex twice, a face
///         with three tetrahedra, two on the same side, and a tetrahedron given twice; names the tetrahedra
/// Cost O(vertices + tetrahedra), one sort by buckets.
void build_neighbours(TetMesh& mesh);

/// The boundary as mesh.neighbours has it: each face without a tetrahedron behind, its normal pointing outwards and its
/// smallest vertex first, sorted by vertices in ascending order.
///
/// marker  of all of them
/// throws  InputError for an id out of range or an array of the wrong size
/// Cost O(tetrahedra + boundary log boundary).
[[nodiscard]] std::vector<MarkedFace> boundary_faces(const TetMesh& mesh, Marker marker = 1);

/// What make_tet_mesh does with lists of marked faces that are not just the boundary. Without rules every boundary face
/// has to be listed, and no other.
struct MarkedFaceRules {
  /// Boundary faces that are not listed get this marker and follow those listed, in the order of boundary_faces. None:
  /// they are refused. (TetGen's files may list none at all.)
  std::optional<Marker> unlisted_boundary;
  /// Faces listed that lie between two tetrahedra become mesh.interfaces, as given and in the order given. False: they
  /// are refused.
  bool take_interfaces = false;
};

/// A checked mesh from what a file or a generator holds. `mesh::validate` finds nothing wrong with the result.
///
/// points   one a vertex, finite
/// corners  vertices of each tetrahedron, positive by exact orient3d
/// faces    every boundary face once, in either direction; the result has them in the same order, their normals pointing
///          outwards. Others as `rules` allow
/// names    names of markers; markers need no name
/// source   file or description that errors name as their place; may be empty
/// returns  the mesh; vertex_markers and regions are 0: the caller may fill them
/// throws   InputError naming ids and coordinates: a number that is not finite, a corner out of range or repeated, a
///          tetrahedron of zero or negative volume, a face of three tetrahedra, two on the same side of one, a boundary
///          face marked twice or never, a marked face that is none of the boundary's, a vertex of no tetrahedron
/// Overlaps that no single face shows are the business of `mesh::validate_embedding`.
/// Cost O(vertices + tetrahedra + boundary log boundary).
[[nodiscard]] TetMesh make_tet_mesh(PerId<VertexId, Point3> points,
                                    PerId<TetId, std::array<VertexId, 4>> corners,
                                    std::vector<MarkedFace> faces, std::map<Marker, std::string> names = {},
                                    std::string source = {}, const MarkedFaceRules& rules = {});

}  // namespace leonhard::mesh
