// SPDX-License-Identifier: MIT
#include "leonhard/graph/colouring/boost_colourings.hpp"

#include <algorithm>
#include <boost/graph/edge_coloring.hpp>
#include <boost/graph/iteration_macros.hpp>
#include <boost/graph/sequential_vertex_coloring.hpp>

#include "leonhard/graph/boost_graph.hpp"

namespace leonhard::graph::detail {
namespace {

/// Thrown out of Boost's loops, which ask nobody whether to go on; never leaves this file.
struct Stopped {};

/// Property map: colours of edges, one step a colour given.
class CountedColours {
 public:
  using key_type = BoostEdge;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;
  using category = boost::read_write_property_map_tag;

  CountedColours(std::vector<std::uint32_t>& colours, StepCounter& steps)
      : colours_(&colours), steps_(&steps) {}
  friend std::uint32_t get(const CountedColours& map, const BoostEdge& edge) {
    return (*map.colours_)[edge.index];
  }
  friend void put(const CountedColours& map, const BoostEdge& edge, std::uint32_t colour) {
    if (!map.steps_->step()) throw Stopped{};
    (*map.colours_)[edge.index] = colour;
  }

 private:
  std::vector<std::uint32_t>* colours_;
  StepCounter* steps_;
};

}  // namespace

std::uint32_t boost_colour_vertices(const CsrGraph& graph, std::vector<std::uint32_t>& colour_of) {
  colour_of.assign(vertex_count(graph), 0);
  return boost::sequential_vertex_coloring(
      graph, boost::make_iterator_property_map(colour_of.begin(), get(boost::vertex_index, graph)));
}

std::optional<std::uint32_t> boost_colour_edges(const CsrGraph& graph, std::vector<std::uint32_t>& colour_of,
                                                StepCounter& steps) {
  const UndirectedGraph undirected(graph);
  colour_of.assign(edge_count(graph), 0);
  try {
    return boost::edge_coloring(undirected, CountedColours(colour_of, steps));
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

}  // namespace leonhard::graph::detail
