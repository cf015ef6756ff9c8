// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/quad_edge.hpp"
#include "leonhard/mesh/structures/out_degree_list.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// The four data structures of Barth's notes 1.3 and the ways between them. With V vertices, E edges, T
/// triangles, and d the largest degree:
///
///   from \ to         TriangleMesh         EdgeStructure        OutDegreeList     QuadEdge
///   TriangleMesh (FE) -                    build_edges          through edges     through edges
///                                          O(V + T log d)
///   EdgeStructure     triangle_mesh        -                    out_degree_list   quad_edge
///                     O(V + E log d)                            O(V + E)          O(V + E log d)
///   OutDegreeList     through QuadEdge     through QuadEdge     -                 quad_edge
///                                                                                 O(V + E log E)
///   QuadEdge          through edges        edge_structure       through edges     -
///                                          O(V + E log E)
///
/// Vertices keep their numbers on every way, edges those of the edge structure (their order by ends),
/// triangles theirs except through an out-degree list, which knows nothing of triangles: they are found again
/// from coordinates, and numbered by first edge. None of the structures but the first has markers, regions
/// and names; whoever goes round in a circle copies them.
///
/// Pinches: where triangles about a vertex form several fans, the quad-edge structure made of an edge
/// structure has one ring of edges a fan, all with this vertex as origin (the account of euler.hpp counts
/// them so too); the one made of an out-degree list has one ring in all.
namespace leonhard::mesh {

/// A checked mesh from its edges.
///
/// edges      with the triangles on their sides, which are numbered 0 .. T-1
/// points     one a vertex, finite
/// marker     of all boundary edges
/// returns    the mesh, the corners of every triangle beginning with the smallest, boundary in the order of
///            edges
/// throws     InputError, naming the triangle, where a triangle's sides are not three edges that close; and
///            as make_triangle_mesh does
[[nodiscard]] TriangleMesh triangle_mesh(const EdgeStructure& edges, const PerId<VertexId, Point2>& points,
                                         Marker marker = 1);

/// The quad-edge structure of edges with triangles on their sides: edge e is the EdgeRef 4 e, from ends[e][0]
/// to ends[e][1]; faces are numbered as the triangles; what lies outside the mesh, hole or not, has no face
/// id.
///
/// edges  of a mesh that lies in the plane (build_edges made them)
[[nodiscard]] QuadEdge quad_edge(const EdgeStructure& edges);

/// The edge structure of a quad-edge structure whose faces with an id are triangles.
///
/// vertices  count; every origin is one of them
/// throws    InputError for an edge without origin and destination, or one that joins a vertex to itself or
///           two vertices that another one joins
[[nodiscard]] EdgeStructure edge_structure(const QuadEdge& quads, std::size_t vertices);

/// The quad-edge structure of a graph drawn in the plane with straight edges that do not cross. Each
/// component is a sphere of its own. Bounded faces of three edges are taken for triangles and have ids, in
/// the order of their first edge, except holes; other faces have none. Edges are numbered by their ends, as
/// in an edge structure.
///
/// points  one a vertex, distinct where they have a common neighbour
/// holes   vertices of bounded faces of three edges that are no triangles of the mesh, in any order
/// throws  InputError if there are fewer points than vertices
/// Decides by exact orient2d.
[[nodiscard]] QuadEdge quad_edge(const OutDegreeList& list, const PerId<VertexId, Point2>& points,
                                 std::span<const std::array<VertexId, 3>> holes = {});

// ---- the ways round ----

[[nodiscard]] inline QuadEdge quad_edge(const TriangleMesh& mesh) { return quad_edge(build_edges(mesh)); }

[[nodiscard]] inline OutDegreeList out_degree_list(const TriangleMesh& mesh) {
  return out_degree_list(build_edges(mesh));
}

[[nodiscard]] inline OutDegreeList out_degree_list(const QuadEdge& quads, std::size_t vertices) {
  return out_degree_list(edge_structure(quads, vertices));
}

[[nodiscard]] inline TriangleMesh triangle_mesh(const QuadEdge& quads, const PerId<VertexId, Point2>& points,
                                                Marker marker = 1) {
  return triangle_mesh(edge_structure(quads, points.size()), points, marker);
}

[[nodiscard]] inline EdgeStructure edge_structure(const OutDegreeList& list,
                                                  const PerId<VertexId, Point2>& points,
                                                  std::span<const std::array<VertexId, 3>> holes = {}) {
  return edge_structure(quad_edge(list, points, holes), points.size());
}

[[nodiscard]] inline TriangleMesh triangle_mesh(const OutDegreeList& list,
                                                const PerId<VertexId, Point2>& points,
                                                std::span<const std::array<VertexId, 3>> holes = {},
                                                Marker marker = 1) {
  return triangle_mesh(edge_structure(list, points, holes), points, marker);
}

}  // namespace leonhard::mesh
