// SPDX-License-Identifier: MIT
// Orders a mesh for a solver, renumbers it, and cuts it for four processes.
#include <leonhard/graph/order.hpp>
#include <leonhard/graph/partition.hpp>
#include <leonhard/mesh/edges.hpp>
#include <leonhard/mesh/permute.hpp>
#include <vector>

#include "check.hpp"
#include "grid.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  const TriangleMesh mesh = grid(60, 10, [](double s, double t) { return Point2{6 * s, t}; });
  const auto graph = graph::vertex_graph(mesh, mesh::build_edges(mesh));
  const auto [order, outcome] = graph::order(graph, {.method = graph::OrderMethod::reverse_cuthill_mckee});
  claim(outcome == graph::OrderOutcome::done, "nobody stopped it");
  claim(graph::ordering_cost(graph, order).bandwidth < 20, "the band is about as wide as the strip");

  PerId<VertexId, VertexId> new_of_old;
  for (const auto number : graph::invert(order)) new_of_old.push_back(VertexId{number});
  const TriangleMesh ordered = mesh::renumber_vertices(mesh, new_of_old);
  claim(ordered.triangle_count() == mesh.triangle_count(), "renumbering keeps the triangles");

  const auto parts = graph::partition(graph::dual_graph(ordered), 4, {.imbalance = 0.05, .connected = true});
  const auto cost = graph::partition_cost(graph::dual_graph(ordered), parts);
  claim(parts.outcome == graph::PartitionOutcome::done && cost.imbalance <= 0.05, "the parts are alike");
  claim(cost.cut < 100 && cost.max_components == 1, "few edges are cut, no part falls apart");
  return claim.failed();
}
