// SPDX-License-Identifier: MIT
#include "leonhard/graph/mesh_graph.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "leonhard/graph/support/sorted_arcs.hpp"
#include "leonhard/kernel/input_error.hpp"

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

/// Both directions of every edge, grouped by source; rows are in the sequence of the list and may repeat.
struct Rows {
  std::vector<std::size_t> start;
  std::vector<std::uint32_t> column;
};

Rows rows_of(std::uint32_t vertices, std::span<const Edge> edges) {
  Rows rows{std::vector<std::size_t>(vertices + std::size_t{1}, 0), {}};
  for (const Edge& e : edges) {
    if (e[0] == e[1]) continue;
    ++rows.start[e[0] + std::size_t{1}];
    ++rows.start[e[1] + std::size_t{1}];
  }
  for (std::size_t v = 0; v < vertices; ++v) rows.start[v + 1] += rows.start[v];
  rows.column.resize(rows.start.back());
  std::vector<std::size_t> next(rows.start.begin(), rows.start.end() - 1);
  for (const Edge& e : edges) {
    if (e[0] == e[1]) continue;
    rows.column[next[e[0]]++] = e[1];
    rows.column[next[e[1]]++] = e[0];
  }
  return rows;
}

using detail::Arcs;
using detail::graph_of_sorted_arcs;

void check_edges(std::uint32_t vertices, std::span<const Edge> edges) {
  if (edges.size() > max_edges)
    throw InputError("edges", std::to_string(edges.size()) + " edges", "graphs hold at most 2^31 - 1");
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const std::uint32_t end : edges[i])
      if (end >= vertices)
        throw InputError("edges",
                         "edge " + std::to_string(i) + " ends at vertex " + std::to_string(end) +
                             ", the graph has " + std::to_string(vertices) + " vertices",
                         "number vertices from 0");
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

}  // namespace

EdgeListGraph graph_from_edges(std::uint32_t vertices, std::span<const Edge> edges) {
  check_edges(vertices, edges);
  Rows rows = rows_of(vertices, edges);
  Arcs arcs;
  arcs.reserve(rows.column.size());
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto first = rows.column.begin() + static_cast<std::ptrdiff_t>(rows.start[v]);
    const auto last = rows.column.begin() + static_cast<std::ptrdiff_t>(rows.start[v + std::size_t{1}]);
    std::sort(first, last);
    for (auto w = first; w != last; ++w)
      if (w == first || *w != *(w - 1)) arcs.emplace_back(v, *w);
  }
  EdgeListGraph result;
  result.self_loops = static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const Edge& e) { return e[0] == e[1]; }));
  result.parallel_edges = (rows.column.size() - arcs.size()) / 2;
  result.graph = graph_of_sorted_arcs(arcs, vertices);
  return result;
}

CsrGraph vertex_graph(const TriangleMesh& mesh, const EdgeStructure& edges) {
  const std::uint32_t vertices = as_vertex_count(mesh.vertex_count(), "vertices");
  std::vector<Edge> list;
  list.reserve(edges.ends.size());
  for (const auto& ends : edges.ends)
    list.push_back({static_cast<std::uint32_t>(ends[0].raw), static_cast<std::uint32_t>(ends[1].raw)});
  return graph_from_edges(vertices, list).graph;
}

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

CsrGraph dual_graph(const TriangleMesh& mesh) {
  return graph_of_neighbours(mesh.neighbours, mesh.triangle_count(), "triangle");
}

CsrGraph dual_graph(const TetMesh& mesh) {
  return graph_of_neighbours(mesh.neighbours, mesh.tet_count(), "tetrahedron");
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
  Arcs arcs;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const std::size_t row = arcs.size();
    for (const std::uint32_t w : neighbours(*graph_, vertices[i]))
      if (new_of_old_[w] != not_chosen) arcs.emplace_back(i, new_of_old_[w]);
    std::sort(arcs.begin() + static_cast<std::ptrdiff_t>(row), arcs.end());
  }
  for (const std::uint32_t v : vertices) new_of_old_[v] = not_chosen;
  return graph_of_sorted_arcs(arcs, vertices.size());
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
