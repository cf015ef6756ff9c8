// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// Fill mesh.neighbours from mesh.corners: neighbours[t][i] is the triangle across the edge opposite
/// corners[t][i], none on the boundary. Coordinates, markers and boundary are not read.
///
/// throws  InputError, mesh unchanged, on a corner that is no vertex, a triangle that names a vertex twice,
///         an edge with three triangles, neighbours of unlike orientation, and a triangle given twice; names
///         the triangles
/// Cost O(vertices + triangles), one sort by buckets.
void build_neighbours(TriangleMesh& mesh);

/// A checked mesh from what a file or a generator holds. `mesh::validate` finds nothing wrong with the
/// result.
///
/// points    one a vertex, finite
/// corners   vertices of each triangle, counter-clockwise by exact orient2d
/// boundary  every boundary edge once, in either direction; the result has them in the same order with the
/// mesh on
///           their left
/// names     names of markers; markers need no name
/// source    file or description that errors name as their place; may be empty
/// returns   the mesh; vertex_markers and regions are 0, constraints empty: the caller may fill them
/// throws  InputError naming ids and coordinates: a number that is not finite, a corner out of range, a
/// triangle of
///         zero or negative area, an edge of three triangles, a boundary edge marked twice or never, a marked
///         edge that is none of the boundary's, a vertex of no triangle
/// Overlaps that no single cell shows are the business of `mesh::validate_embedding`.
/// Cost O(vertices + triangles + boundary log boundary).
[[nodiscard]] TriangleMesh make_triangle_mesh(PerId<VertexId, Point2> points,
                                              PerId<TriangleId, std::array<VertexId, 3>> corners,
                                              std::vector<MarkedEdge> boundary,
                                              std::map<Marker, std::string> names = {},
                                              std::string source = {});

}  // namespace leonhard::mesh
