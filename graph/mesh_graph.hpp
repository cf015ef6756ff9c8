// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/edge_list.hpp"
#include "leonhard/mesh/compressed_rows.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::graph {

/// An undirected graph in compressed rows: every edge is stored in both directions, each row ascending, without
/// self-loops or parallel edges. Vertices are 0 ... n-1; both vertex and directed-edge numbers are 32-bit.
class CsrGraph {
 public:
  using Rows = CompressedRows<std::uint32_t>;

  /// Without vertices.
  CsrGraph() = default;
  /// rows  of neighbours as promised above, which is not checked (see validate(); graph_from_edges takes any list)
  explicit CsrGraph(Rows rows) : rows_(std::move(rows)) {}

  /// Row v holds the neighbours of vertex v.
  [[nodiscard]] const Rows& rows() const { return rows_; }

  friend bool operator==(const CsrGraph&, const CsrGraph&) = default;

 private:
  Rows rows_;
};

[[nodiscard]] inline std::uint32_t vertex_count(const CsrGraph& graph) {
  return static_cast<std::uint32_t>(graph.rows().size());
}

/// Undirected edges: each counted once though stored twice.
[[nodiscard]] inline std::size_t edge_count(const CsrGraph& graph) { return graph.rows().link_count() / 2; }

/// The neighbours of a vertex, ascending. Valid as long as the graph is.
///
/// vertex  below vertex_count(graph): a precondition, asserted only, for loops over a whole graph ask nothing else
[[nodiscard]] inline std::span<const std::uint32_t> neighbours(const CsrGraph& graph, std::uint32_t vertex) {
  return graph.rows()[vertex];
}

/// How many these are, with the same precondition.
[[nodiscard]] inline std::uint32_t degree(const CsrGraph& graph, std::uint32_t vertex) {
  return static_cast<std::uint32_t>(neighbours(graph, vertex).size());
}

/// A graph made from a list of edges, and what the list held that a graph does not.
struct EdgeListGraph {
  CsrGraph graph;
  std::size_t self_loops{};      ///< edges from a vertex to itself, dropped
  std::size_t parallel_edges{};  ///< repetitions of an edge (in either direction), dropped
};

/// The graph of an edge list.
///
/// vertices  number of vertices
/// edges     pairs of vertices in either order and any sequence; (a,b) and (b,a) are one edge
/// throws    InputError on an end that is not below `vertices` and on more than 2^31 - 1 edges
/// Cost O(n + m log d), d the largest degree.
[[nodiscard]] EdgeListGraph graph_from_edges(std::uint32_t vertices,
                                             std::span<const std::array<std::uint32_t, 2>> edges);

/// The graph of a list that names every edge in both directions (what each vertex says of its neighbours).
///
/// vertices  number of vertices
/// arcs      source and target, in any sequence; of self-loops and repetitions as above, a repetition in both directions
///           counted once
/// throws    InputError on an end that is not below `vertices`, an edge that is named in one direction only and on more
///           than 2^31 - 1 edges
/// Cost O(n + m log d), d the largest degree.
[[nodiscard]] EdgeListGraph graph_from_arcs(std::uint32_t vertices,
                                            std::span<const std::array<std::uint32_t, 2>> arcs);

/// The graph of a mesh's vertices and edges (the graph that a vertex-centred scheme couples).
///
/// edges   mesh::build_edges(mesh)
/// throws  InputError if `edges` is not of this mesh or the mesh is too large for 32-bit graphs
/// Cost O(vertices + edges).
[[nodiscard]] CsrGraph vertex_graph(const TriangleMesh& mesh, const EdgeStructure& edges);

/// The dual graph: one vertex a triangle, an edge where two triangles share a side.
///
/// mesh    with its neighbours filled (mesh::build_neighbours)
/// throws  InputError if the neighbours are missing or not mutual
/// Cost O(triangles).
[[nodiscard]] CsrGraph dual_graph(const TriangleMesh& mesh);

/// The graph of a tetrahedral mesh's vertices and edges.
///
/// throws  InputError on a corner that is no vertex, a tetrahedron that names a vertex twice, or a mesh too large
/// Cost O(vertices + tetrahedra log degree); neighbours are not read.
[[nodiscard]] CsrGraph vertex_graph(const TetMesh& mesh);

/// The graph of the vertices and edges of a mesh of any cells.
///
/// vertices  as many as the mesh has
/// edges     mesh::build_edges of it, or those of its dual
/// throws    InputError on an end that is no vertex and on a mesh too large
/// Cost O(vertices + edges).
[[nodiscard]] CsrGraph vertex_graph(std::size_t vertices, const EdgeList& edges);

/// The dual graph of a tetrahedral mesh: one vertex a tetrahedron, an edge where two share a face.
///
/// throws  as for triangles
/// Cost O(tetrahedra).
[[nodiscard]] CsrGraph dual_graph(const TetMesh& mesh);

/// The graph of the vertices and edges of a mesh of mixed cells; diagonals of quadrilaterals are no edges.
///
/// throws  InputError as mesh::build_edges, and on a mesh too large
/// Cost O(vertices + cells).
template <int Dim>
[[nodiscard]] CsrGraph vertex_graph(const MixedMesh<Dim>& mesh);

/// The dual graph of a mesh of mixed cells: one vertex a cell, an edge where two share a facet.
///
/// throws  InputError as mesh::neighbouring_cells, and on a mesh too large
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] CsrGraph dual_graph(const MixedMesh<Dim>& mesh);

/// The length of every directed edge, in the graph's sequence: weights for shortest paths.
///
/// points  one a vertex
/// throws  InputError if there are not as many points as vertices
/// Cost O(n + m).
[[nodiscard]] std::vector<double> arc_lengths(const CsrGraph& graph, std::span<const Point2> points);
[[nodiscard]] std::vector<double> arc_lengths(const CsrGraph& graph, std::span<const Point3> points);

/// The connected components, numbered by their smallest vertex.
struct Components {
  std::vector<std::uint32_t> component_of;  ///< one a vertex
  std::vector<std::uint32_t> sizes;         ///< one a component

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(sizes.size()); }
};

/// Cost O(n + m).
[[nodiscard]] Components components(const CsrGraph& graph);

/// Cuts subgraphs out of one graph. Keeps scratch space of one number a vertex, so that many small subgraphs
/// cost no more than their own size; one thread at a time.
class SubgraphExtractor {
 public:
  /// graph  must outlive the extractor
  explicit SubgraphExtractor(const CsrGraph& graph);

  /// The subgraph on some vertices: vertex i of the result is vertices[i].
  ///
  /// vertices  distinct vertices of the graph in any order
  /// throws    InputError on a vertex out of range or repeated
  /// Cost O(sum of the chosen degrees, times log of the largest).
  [[nodiscard]] CsrGraph operator()(std::span<const std::uint32_t> vertices);

 private:
  void number(std::span<const std::uint32_t> vertices);

  const CsrGraph* graph_;
  std::vector<std::uint32_t> new_of_old_;  ///< per vertex its number in the subgraph being cut, or none
};

/// The first broken promise of CsrGraph in words (range, order of a row, self-loop, missing reverse edge), if
/// any.
///
/// Cost O(n + m log d).
[[nodiscard]] std::optional<std::string> validate(const CsrGraph& graph);

}  // namespace leonhard::graph
