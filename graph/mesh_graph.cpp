// SPDX-License-Identifier: MIT
#include "leonhard/graph/mesh_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/mixed_topology.hpp"

namespace leonhard::graph {
namespace {

using Edge = std::array<std::uint32_t, 2>;

constexpr std::uint32_t not_chosen = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t max_edges = std::numeric_limits<std::uint32_t>::max() / 2;

/// A mesh's count as a graph's number of vertices.
std::uint32_t as_vertex_count(std::size_t count, const char* what) {
  if (count >= std::numeric_limits<std::uint32_t>::max())
    throw InputError("graph", "the mesh has " + std::to_string(count) + " " + what,
                     "graphs hold fewer than 2^32 - 1 vertices");
  return static_cast<std::uint32_t>(count);
}

enum class Directions { both, as_listed };

/// The edges' other ends by vertex, each row ascending, without self-loops; rows may repeat.
CsrGraph::Rows rows_of(std::uint32_t vertices, std::span<const Edge> edges, Directions directions) {
  auto rows = collect_rows<std::uint32_t>(vertices, [&](const auto& add) {
    for (const auto& [a, b] : edges) {
      if (a == b) continue;
      add(a, b);
      if (directions == Directions::both) add(b, a);
    }
  });
  for (std::uint32_t v = 0; v < vertices; ++v) std::ranges::sort(rows[v]);
  return rows;
}

/// Each link once in a row; the rows ascend.
CsrGraph::Rows without_repetitions(CsrGraph::Rows rows) {
  const auto repeats = [&] {
    for (std::size_t v = 0; v < rows.size(); ++v)
      if (std::ranges::adjacent_find(rows[v]) != rows[v].end()) return true;
    return false;
  };
  if (!repeats()) return rows;
  CsrGraph::Rows result;
  result.reserve(rows.size(), rows.link_count());
  for (std::size_t v = 0; v < rows.size(); ++v) {
    for (std::size_t k = 0; k < rows[v].size(); ++k)
      if (k == 0 || rows[v][k] != rows[v][k - 1]) result.add_link(rows[v][k]);
    result.end_row();
  }
  return result;
}

void check_edges(std::uint32_t vertices, std::span<const Edge> edges, std::size_t most) {
  if (edges.size() > most)
    throw InputError("edges", std::to_string(edges.size()) + " edges", "graphs hold at most 2^31 - 1");
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const std::uint32_t end : edges[i])
      if (end >= vertices)
        throw InputError("edges",
                         "edge " + std::to_string(i) + " ends at vertex " + std::to_string(end) +
                             ", the graph has " + std::to_string(vertices) + " vertices",
                         "number vertices from 0");
}

void check_both_directions(const CsrGraph& graph) {
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      if (!std::ranges::binary_search(neighbours(graph, w), v))
        throw InputError("edges",
                         "vertex " + std::to_string(v) + " has neighbour " + std::to_string(w) +
                             ", which does not have it back",
                         "name every edge in both directions");
}

std::size_t self_loops(std::span<const Edge> edges) {
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const Edge& e) { return e[0] == e[1]; }));
}

/// The edges are those of the mesh if every edge joins two corners of each triangle beside it, no edge stands twice, and
/// the triangles' sides are counted as often as there are any.
void check_edges_of(const TriangleMesh& mesh, const EdgeStructure& edges) {
  const auto refuse = [](const std::string& problem) {
    throw InputError("edges", problem, "give mesh::build_edges of this mesh");
  };
  if (edges.sides.size() != edges.ends.size()) refuse("they are incomplete");
  std::size_t sides = 0;
  for (const EdgeId e : edges.ends.ids()) {
    if (e.raw > 0 && !(edges.ends[EdgeId{e.raw - 1}] < edges.ends[e]))
      refuse("edge " + std::to_string(e.raw) + " does not follow the one before it");
    for (const MaybeId<TriangleId> side : edges.sides[e]) {
      if (!side) continue;
      ++sides;
      const bool known = mesh.corners.contains(*side);
      for (const VertexId end : edges.ends[e])
        if (!known || std::ranges::count(mesh.corners[*side], end) == 0)
          refuse("edge " + std::to_string(e.raw) + " has triangle " + std::to_string((*side).raw) +
                 " beside it, which " +
                 (known ? "does not have vertex " + std::to_string(end.raw) : "the mesh has not"));
    }
    if (edges.sides[e][0] == edges.sides[e][1])
      refuse("edge " + std::to_string(e.raw) + " has no triangle beside it, or one on both sides");
  }
  if (sides != 3 * mesh.triangle_count())
    refuse("they have " + std::to_string(sides) + " sides, the triangles " +
           std::to_string(3 * mesh.triangle_count()));
}

/// The graph of cells that name one another as neighbours.
template <class CellId, std::size_t sides>
CsrGraph graph_of_neighbours(const PerId<CellId, std::array<MaybeId<CellId>, sides>>& neighbours,
                             std::size_t cell_count, const std::string& cell) {
  const std::uint32_t cells = as_vertex_count(cell_count, "cells");
  if (neighbours.size() != cells)
    throw InputError("mesh",
                     "neighbours are known for " + std::to_string(neighbours.size()) + " of " +
                         std::to_string(cells) + " cells (" + cell + ")",
                     "call mesh::build_neighbours first");
  std::vector<Edge> list;
  list.reserve(cells * sides / 2);
  for (const CellId t : neighbours.ids())
    for (const MaybeId<CellId> neighbour : neighbours[t]) {
      if (!neighbour) continue;
      const CellId s = *neighbour;
      if (!neighbours.contains(s) || std::ranges::count(neighbours[s], MaybeId<CellId>(t)) == 0)
        throw InputError("mesh",
                         cell + " " + std::to_string(t.raw) + " names " + cell + " " + std::to_string(s.raw) +
                             " as neighbour, which does not name it back",
                         "call mesh::build_neighbours again");
      if (t < s) list.push_back({static_cast<std::uint32_t>(t.raw), static_cast<std::uint32_t>(s.raw)});
    }
  return graph_from_edges(cells, list).graph;
}

template <class Point>
std::vector<double> lengths(const CsrGraph& graph, std::span<const Point> points) {
  if (points.size() != vertex_count(graph))
    throw InputError(
        "points",
        std::to_string(points.size()) + " points for " + std::to_string(vertex_count(graph)) + " vertices",
        "give one a vertex");
  std::vector<double> result;
  result.reserve(graph.rows().link_count());
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v)) {
      const auto way = points[w] - points[v];
      if constexpr (std::is_same_v<Point, Point2>)
        result.push_back(std::hypot(way.x, way.y));
      else
        result.push_back(std::hypot(way.x, way.y, way.z));
    }
  return result;
}

}  // namespace

EdgeListGraph graph_from_edges(std::uint32_t vertices, std::span<const Edge> edges) {
  check_edges(vertices, edges, max_edges);
  CsrGraph::Rows rows = rows_of(vertices, edges, Directions::both);
  const std::size_t listed = rows.link_count();
  EdgeListGraph result{CsrGraph(without_repetitions(std::move(rows))), self_loops(edges)};
  result.parallel_edges = listed / 2 - edge_count(result.graph);
  return result;
}

EdgeListGraph graph_from_arcs(std::uint32_t vertices, std::span<const Edge> arcs) {
  check_edges(vertices, arcs, 2 * max_edges);
  CsrGraph::Rows rows = rows_of(vertices, arcs, Directions::as_listed);
  const std::size_t listed = rows.link_count();
  EdgeListGraph result{CsrGraph(without_repetitions(std::move(rows))), self_loops(arcs)};
  result.parallel_edges = (listed - result.graph.rows().link_count() + 1) / 2;
  check_both_directions(result.graph);
  return result;
}

CsrGraph vertex_graph(const TriangleMesh& mesh, const EdgeStructure& edges) {
  check_edges_of(mesh, edges);
  const std::uint32_t vertices = as_vertex_count(mesh.vertex_count(), "vertices");
  std::vector<Edge> list;
  list.reserve(edges.ends.size());
  for (const auto& ends : edges.ends)
    list.push_back({static_cast<std::uint32_t>(ends[0].raw), static_cast<std::uint32_t>(ends[1].raw)});
  return graph_from_edges(vertices, list).graph;
}

template <int Dim>
CsrGraph vertex_graph(const MixedMesh<Dim>& mesh) {
  const std::uint32_t vertices = as_vertex_count(mesh.vertex_count(), "vertices");
  const EdgeList edges = mesh::build_edges(mesh);
  std::vector<Edge> list;
  list.reserve(edges.edge_count());
  for (const auto& ends : edges.ends)
    list.push_back({static_cast<std::uint32_t>(ends[0].raw), static_cast<std::uint32_t>(ends[1].raw)});
  return graph_from_edges(vertices, list).graph;
}

template <int Dim>
CsrGraph dual_graph(const MixedMesh<Dim>& mesh) {
  const std::uint32_t cells = as_vertex_count(mesh.cell_count(), "cells");
  std::vector<Edge> list;
  for (const auto& [a, b] : mesh::neighbouring_cells(mesh))
    list.push_back({static_cast<std::uint32_t>(a.raw), static_cast<std::uint32_t>(b.raw)});
  return graph_from_edges(cells, list).graph;
}

template CsrGraph vertex_graph(const MixedMesh<2>&);
template CsrGraph vertex_graph(const MixedMesh<3>&);
template CsrGraph dual_graph(const MixedMesh<2>&);
template CsrGraph dual_graph(const MixedMesh<3>&);

CsrGraph vertex_graph(const TetMesh& mesh) {
  const std::uint32_t vertices = as_vertex_count(mesh.vertex_count(), "vertices");
  std::vector<Edge> list;
  list.reserve(mesh.tet_count() * tet_edge_corners.size());
  for (const TetId t : mesh.corners.ids())
    for (const auto& [i, j] : tet_edge_corners) {
      const VertexId a = mesh.corners[t][i], b = mesh.corners[t][j];
      if (a == b || a.raw >= vertices || b.raw >= vertices)
        throw InputError("mesh",
                         "tetrahedron " + std::to_string(t.raw) + " has an edge from vertex " +
                             std::to_string(a.raw) + " to " + std::to_string(b.raw) + ", the mesh has " +
                             std::to_string(vertices) + " vertices",
                         "name four distinct vertices");
      list.push_back({static_cast<std::uint32_t>(a.raw), static_cast<std::uint32_t>(b.raw)});
    }
  return graph_from_edges(vertices, list).graph;
}

CsrGraph vertex_graph(std::size_t vertices, const EdgeList& edges) {
  const std::uint32_t count = as_vertex_count(vertices, "vertices");
  std::vector<Edge> list;
  list.reserve(edges.ends.size());
  for (const auto& [a, b] : edges.ends) {
    if (a.raw >= count || b.raw >= count)
      throw InputError("edges",
                       "edge " + std::to_string(a.raw) + "-" + std::to_string(b.raw) + " has an end that is no vertex, the mesh has " +
                           std::to_string(count),
                       "give the edges of this mesh");
    list.push_back({static_cast<std::uint32_t>(a.raw), static_cast<std::uint32_t>(b.raw)});
  }
  return graph_from_edges(count, list).graph;
}

CsrGraph dual_graph(const TriangleMesh& mesh) {
  return graph_of_neighbours(mesh.neighbours, mesh.triangle_count(), "triangle");
}

CsrGraph dual_graph(const TetMesh& mesh) {
  return graph_of_neighbours(mesh.neighbours, mesh.tet_count(), "tetrahedron");
}

std::vector<double> arc_lengths(const CsrGraph& graph, std::span<const Point2> points) {
  return lengths(graph, points);
}

std::vector<double> arc_lengths(const CsrGraph& graph, std::span<const Point3> points) {
  return lengths(graph, points);
}

Components components(const CsrGraph& graph) {
  constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t n = vertex_count(graph);
  Components result{std::vector<std::uint32_t>(n, unseen), {}};
  std::vector<std::uint32_t> stack;
  for (std::uint32_t root = 0; root < n; ++root) {
    if (result.component_of[root] != unseen) continue;
    const std::uint32_t component = result.count();
    result.sizes.push_back(0);
    result.component_of[root] = component;
    stack.push_back(root);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      ++result.sizes[component];
      for (const std::uint32_t w : neighbours(graph, v))
        if (result.component_of[w] == unseen) {
          result.component_of[w] = component;
          stack.push_back(w);
        }
    }
  }
  return result;
}

SubgraphExtractor::SubgraphExtractor(const CsrGraph& graph)
    : graph_(&graph), new_of_old_(vertex_count(graph), not_chosen) {}

void SubgraphExtractor::number(std::span<const std::uint32_t> vertices) {
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t v = vertices[i];
    const bool exists = v < new_of_old_.size();
    if (!exists || new_of_old_[v] != not_chosen) {
      for (const std::uint32_t done : vertices.first(i)) new_of_old_[done] = not_chosen;
      throw InputError("vertices",
                       "vertex " + std::to_string(v) + (exists ? " is named twice" : " does not exist"),
                       "name distinct vertices below " + std::to_string(new_of_old_.size()));
    }
    new_of_old_[v] = i;
  }
}

CsrGraph SubgraphExtractor::operator()(std::span<const std::uint32_t> vertices) {
  number(vertices);
  CsrGraph::Rows rows;
  rows.reserve(vertices.size(), 0);
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    for (const std::uint32_t w : neighbours(*graph_, vertices[i]))
      if (new_of_old_[w] != not_chosen) rows.add_link(new_of_old_[w]);
    rows.end_row();
    std::ranges::sort(rows[i]);
  }
  for (const std::uint32_t v : vertices) new_of_old_[v] = not_chosen;
  return CsrGraph(std::move(rows));
}

std::optional<std::string> validate(const CsrGraph& graph) {
  const std::uint32_t n = vertex_count(graph);
  for (std::uint32_t v = 0; v < n; ++v) {
    const auto row = neighbours(graph, v);
    const std::string vertex = "vertex " + std::to_string(v);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::uint32_t w = row[k];
      const std::string other = std::to_string(w);
      if (w >= n)
        return vertex + " has neighbour " + other + ", the graph has " + std::to_string(n) + " vertices";
      if (w == v) return vertex + " is its own neighbour";
      if (k > 0 && row[k - 1] >= w) return "the row of " + vertex + " does not ascend at neighbour " + other;
      if (!std::ranges::binary_search(neighbours(graph, w), v))
        return vertex + " has neighbour " + other + ", which does not have it back";
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::graph
