// SPDX-License-Identifier: MIT
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include "leonhard/graph/boost_graph.hpp"
#include "leonhard/graph/orientation.hpp"

namespace leonhard::graph {

bool is_planar(const CsrGraph& graph) {
  const std::size_t n = vertex_count(graph);
  if (n >= 3 && edge_count(graph) > 3 * n - 6) return false;  // Euler
  return boost::boyer_myrvold_planarity_test(UndirectedGraph(graph));
}

}  // namespace leonhard::graph
