// SPDX-License-Identifier: MIT
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include "leonhard/graph/orientation.hpp"

namespace leonhard::graph {

bool is_planar(const CsrGraph& graph) {
  const std::size_t n = vertex_count(graph);
  if (n >= 3 && edge_count(graph) > 3 * n - 6) return false;  // Euler
  using Undirected = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                           boost::property<boost::edge_index_t, std::size_t>>;
  Undirected undirected(n);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < n; ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      if (v < w) boost::add_edge(v, w, next++, undirected);
  return boost::boyer_myrvold_planarity_test(undirected);
}

}  // namespace leonhard::graph
