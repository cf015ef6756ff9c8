// SPDX-License-Identifier: MIT
// Meshes a unit square with a hole through the installed library, and orders the mesh's graph.
#include <cstdio>
#include <leonhard/delaunay/refine.hpp>
#include <leonhard/graph/mesh_graph.hpp>
#include <leonhard/graph/ordering.hpp>
#include <leonhard/mesh/edges.hpp>
#include <leonhard/mesh/euler.hpp>

int main() {
  leonhard::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}};
  square.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}, {4, 5, 2}, {5, 6, 2}, {6, 7, 2}, {7, 4, 2}};
  square.holes = {{0.5, 0.5}};
  leonhard::delaunay::RefineOptions options;
  options.size = [](leonhard::Point2) { return 0.1; };
  const auto refined = leonhard::delaunay::mesh_pslg(square, options);
  const auto edges = leonhard::mesh::build_edges(refined.mesh);
  const auto account = leonhard::mesh::euler_account(refined.mesh, edges);
  const auto order = leonhard::graph::reverse_cuthill_mckee(leonhard::graph::vertex_graph(refined.mesh, edges));
  std::printf("%zu vertices, %zu triangles, %zu hole\n", refined.mesh.vertex_count(), refined.mesh.triangle_count(), account.holes);
  return account.balances() && account.holes == 1 && order.size() == refined.mesh.vertex_count() ? 0 : 1;
}
