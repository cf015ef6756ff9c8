// SPDX-License-Identifier: MIT
#include "leonhard/graph/adjacency.hpp"

#include <array>
#include <limits>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

template <class Number>
void check_offsets(std::span<const Number> xadj, std::size_t links) {
  if (xadj.empty()) throw InputError("xadj", "it is empty", "give one offset more than there are vertices");
  if (xadj.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("xadj", std::to_string(xadj.size() - 1) + " vertices",
                     "graphs hold fewer than 2^32 - 1");
  if (xadj.front() != 0)
    throw InputError("xadj", "it begins with " + std::to_string(xadj.front()), "number places from 0");
  for (std::size_t v = 1; v < xadj.size(); ++v)
    if (xadj[v] < xadj[v - 1])
      throw InputError("xadj",
                       "it descends from " + std::to_string(xadj[v - 1]) + " to " + std::to_string(xadj[v]) +
                           " at vertex " + std::to_string(v - 1),
                       "rows follow one another");
  if (static_cast<std::uint64_t>(xadj.back()) != links)
    throw InputError("xadj",
                     "it ends with " + std::to_string(xadj.back()) + ", adjncy holds " +
                         std::to_string(links) + " neighbours",
                     "end with adjncy's size");
}

template <class Number>
EdgeListGraph from_adjacency(std::span<const Number> xadj, std::span<const Number> adjncy) {
  check_offsets(xadj, adjncy.size());
  const auto vertices = static_cast<std::uint32_t>(xadj.size() - 1);
  std::vector<std::array<std::uint32_t, 2>> arcs;
  arcs.reserve(adjncy.size());
  for (std::uint32_t v = 0; v < vertices; ++v)
    for (auto k = static_cast<std::size_t>(xadj[v]); k < static_cast<std::size_t>(xadj[v + std::size_t{1}]);
         ++k) {
      if (adjncy[k] < 0 || static_cast<std::uint64_t>(adjncy[k]) >= vertices)
        throw InputError("adjncy",
                         "vertex " + std::to_string(v) + " has neighbour " + std::to_string(adjncy[k]) +
                             ", the graph has " + std::to_string(vertices) + " vertices",
                         "number vertices from 0");
      arcs.push_back({v, static_cast<std::uint32_t>(adjncy[k])});
    }
  return graph_from_arcs(vertices, arcs);
}

}  // namespace

EdgeListGraph graph_from_adjacency(std::span<const std::int32_t> xadj, std::span<const std::int32_t> adjncy) {
  return from_adjacency(xadj, adjncy);
}

EdgeListGraph graph_from_adjacency(std::span<const std::int64_t> xadj, std::span<const std::int64_t> adjncy) {
  return from_adjacency(xadj, adjncy);
}

AdjacencySpans adjacency_spans(const CsrGraph& graph) {
  constexpr std::size_t largest = std::numeric_limits<std::int32_t>::max();
  if (vertex_count(graph) > largest || graph.rows().link_count() > largest)
    throw InputError(
        "graph",
        std::to_string(vertex_count(graph)) + " vertices and " + std::to_string(edge_count(graph)) + " edges",
        "32 signed bits do not count them; take adjacency_arrays()");
  // Signed and unsigned numbers of one size may be read as each other.
  const auto as_signed = [](std::span<const std::uint32_t> numbers) {
    return std::span(reinterpret_cast<const std::int32_t*>(numbers.data()), numbers.size());
  };
  return {as_signed(graph.rows().offsets()), as_signed(graph.rows().links())};
}

AdjacencyArrays adjacency_arrays(const CsrGraph& graph) {
  const auto offsets = graph.rows().offsets(), links = graph.rows().links();
  return {{offsets.begin(), offsets.end()}, {links.begin(), links.end()}};
}

}  // namespace leonhard::graph
