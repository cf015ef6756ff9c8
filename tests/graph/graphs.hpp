// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/mesh/topology.hpp"

/// Graphs and meshes whose answers are known.
namespace leonhard::graph::test {

using Edges = std::vector<std::array<std::uint32_t, 2>>;

inline CsrGraph path(std::uint32_t n) {
  Edges edges;
  for (std::uint32_t v = 1; v < n; ++v) edges.push_back({v - 1, v});
  return graph_from_edges(n, edges).graph;
}

inline CsrGraph cycle(std::uint32_t n) {
  Edges edges;
  for (std::uint32_t v = 0; v < n; ++v) edges.push_back({v, (v + 1) % n});
  return graph_from_edges(n, edges).graph;
}

/// Vertices (i, j), i < width, j < height, number j * width + i, four neighbours.
inline CsrGraph grid(std::uint32_t width, std::uint32_t height) {
  Edges edges;
  for (std::uint32_t j = 0; j < height; ++j)
    for (std::uint32_t i = 0; i < width; ++i) {
      const std::uint32_t v = j * width + i;
      if (i + 1 < width) edges.push_back({v, v + 1});
      if (j + 1 < height) edges.push_back({v, v + width});
    }
  return graph_from_edges(width * height, edges).graph;
}

inline CsrGraph complete(std::uint32_t n) {
  Edges edges;
  for (std::uint32_t v = 0; v < n; ++v)
    for (std::uint32_t w = v + 1; w < n; ++w) edges.push_back({v, w});
  return graph_from_edges(n, edges).graph;
}

/// Vertex 0 joined to all others.
inline CsrGraph star(std::uint32_t n) {
  Edges edges;
  for (std::uint32_t v = 1; v < n; ++v) edges.push_back({0, v});
  return graph_from_edges(n, edges).graph;
}

/// A cycle of n - 1 vertices and a hub, vertex 0, joined to all of them.
inline CsrGraph wheel(std::uint32_t n) {
  Edges edges;
  for (std::uint32_t v = 1; v < n; ++v) {
    edges.push_back({0, v});
    edges.push_back({v, v % (n - 1) + 1});
  }
  return graph_from_edges(n, edges).graph;
}

/// Each pair of vertices joined with the given chance in 256.
inline CsrGraph random_graph(std::uint32_t n, unsigned chance, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Edges edges;
  for (std::uint32_t v = 0; v < n; ++v)
    for (std::uint32_t w = v + 1; w < n; ++w)
      if (random() % 256 < chance) edges.push_back({v, w});
  return graph_from_edges(n, edges).graph;
}

/// Several graphs side by side, numbered one after another.
inline CsrGraph disjoint_union(const std::vector<CsrGraph>& graphs) {
  Edges edges;
  std::uint32_t n = 0;
  for (const CsrGraph& graph : graphs) {
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      for (const std::uint32_t w : neighbours(graph, v)) edges.push_back({n + v, n + w});
    n += vertex_count(graph);
  }
  return graph_from_edges(n, edges).graph;
}

/// A random permutation of 0 ... n-1, the same on every platform.
inline std::vector<std::uint32_t> random_order(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    order[i] = i;
    std::swap(order[i], order[random() % (i + std::uint64_t{1})]);
  }
  return order;
}

inline bool is_permutation_of_all(const CsrGraph& graph, std::vector<std::uint32_t> order) {
  std::ranges::sort(order);
  for (std::uint32_t i = 0; i < order.size(); ++i)
    if (order[i] != i) return false;
  return order.size() == vertex_count(graph);
}

/// The same graph with vertex v renamed to name[v].
inline CsrGraph renamed(const CsrGraph& graph, const std::vector<std::uint32_t>& name) {
  Edges edges;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v)) edges.push_back({name[v], name[w]});
  return graph_from_edges(vertex_count(graph), edges).graph;
}

/// A rectangle of width times height squares, each cut by one of its diagonals at random, inner vertices
/// moved a little at random: inner degrees are 4 to 8.
inline TriangleMesh random_triangulation(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto jitter = [&] { return 0.2 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5); };
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return VertexId::from(j * (width + 1) + i); };
  PerId<VertexId, Point2> points;
  for (std::uint32_t j = 0; j <= height; ++j)
    for (std::uint32_t i = 0; i <= width; ++i) {
      const bool inner = i > 0 && i < width && j > 0 && j < height;
      const double dx = inner ? jitter() : 0, dy = inner ? jitter() : 0;
      points.push_back({i + dx, j + dy});
    }
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  for (std::uint32_t j = 0; j < height; ++j)
    for (std::uint32_t i = 0; i < width; ++i) {
      const VertexId a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      const bool from_a = (random() >> 63) != 0;
      corners.push_back(from_a ? std::array{a, b, c} : std::array{a, b, d});
      corners.push_back(from_a ? std::array{a, c, d} : std::array{b, c, d});
    }
  std::vector<MarkedEdge> boundary;
  for (std::uint32_t i = 0; i < width; ++i) {
    boundary.push_back({vertex(i, 0), vertex(i + 1, 0), 1});
    boundary.push_back({vertex(i + 1, height), vertex(i, height), 1});
  }
  for (std::uint32_t j = 0; j < height; ++j) {
    boundary.push_back({vertex(width, j), vertex(width, j + 1), 1});
    boundary.push_back({vertex(0, j + 1), vertex(0, j), 1});
  }
  return mesh::make_triangle_mesh(std::move(points), std::move(corners), std::move(boundary));
}

/// The graph of a random triangulation's vertices.
inline CsrGraph random_mesh_graph(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
  const TriangleMesh mesh = random_triangulation(width, height, seed);
  return vertex_graph(mesh, mesh::build_edges(mesh));
}

}  // namespace leonhard::graph::test
