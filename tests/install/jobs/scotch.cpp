// SPDX-License-Identifier: MIT
// A partition by Scotch, through the library's door.
#include <leonhard/graph/scotch.hpp>

#include "check.hpp"
#include "grid.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  const auto graph = graph::dual_graph(grid(20, 20, [](double s, double t) { return Point2{s, t}; }));
  const auto cost = graph::partition_cost(graph, graph::partition_with_scotch(graph, 4));
  claim(cost.smallest > 0 && cost.imbalance < 0.1, "four parts of about equal size");
  claim(cost.cut < 100, "few edges are cut");
  return claim.failed();
}
