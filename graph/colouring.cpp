// SPDX-License-Identifier: MIT
#include "leonhard/graph/colouring.hpp"

#include <algorithm>
#include <limits>

#include "leonhard/graph/colouring/boost_colourings.hpp"
#include "leonhard/graph/orientation.hpp"

namespace leonhard::graph {
namespace {

constexpr std::uint32_t uncoloured = std::numeric_limits<std::uint32_t>::max();

/// The smallest colour that `taken` did not name since the last call.
class FirstFree {
 public:
  void take(std::uint32_t colour) {
    if (colour >= taken_in_.size()) taken_in_.resize(colour + std::size_t{1}, 0);
    taken_in_[colour] = round_;
  }
  std::uint32_t find() {
    std::uint32_t colour = 0;
    while (colour < taken_in_.size() && taken_in_[colour] == round_) ++colour;
    ++round_;
    return colour;
  }

 private:
  std::vector<std::uint64_t> taken_in_;
  std::uint64_t round_ = 1;
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> edges_of(const CsrGraph& graph) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(edge_count(graph));
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      if (v < w) edges.push_back({v, w});
  return edges;
}

Colouring colour_vertices(const CsrGraph& graph, VertexColouringMethod method) {
  if (method == VertexColouringMethod::boost) {
    Colouring of_boost;
    of_boost.colours = detail::boost_colour_vertices(graph, of_boost.colour_of);
    return of_boost;
  }
  std::vector<std::uint32_t> sequence = least_degree_sequence(graph);
  std::ranges::reverse(sequence);
  Colouring result{0, std::vector<std::uint32_t>(sequence.size(), uncoloured)};
  FirstFree free;
  for (const std::uint32_t v : sequence) {
    for (const std::uint32_t w : neighbours(graph, v))
      if (result.colour_of[w] != uncoloured) free.take(result.colour_of[w]);
    result.colour_of[v] = free.find();
    result.colours = std::max(result.colours, result.colour_of[v] + 1);
  }
  return result;
}

Colouring colour_edges_greedily(const CsrGraph& graph) {
  const auto edges = edges_of(graph);
  Colouring result{0, std::vector<std::uint32_t>(edges.size(), uncoloured)};
  std::vector<std::size_t> row(vertex_count(graph) + std::size_t{1}, 0);  // where a vertex's colours begin
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) row[v + std::size_t{1}] = row[v] + degree(graph, v);
  std::vector<std::size_t> end_of(row.begin(), row.end() - 1);
  std::vector<std::uint32_t> colours_at(row.back());
  FirstFree free;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const std::uint32_t end : edges[e])
      for (std::size_t k = row[end]; k < end_of[end]; ++k) free.take(colours_at[k]);
    const std::uint32_t colour = free.find();
    for (const std::uint32_t end : edges[e]) colours_at[end_of[end]++] = colour;
    result.colour_of[e] = colour;
    result.colours = std::max(result.colours, colour + 1);
  }
  return result;
}

std::optional<std::string> validate_vertex_colouring(const CsrGraph& graph, const Colouring& colouring) {
  if (colouring.colour_of.size() != vertex_count(graph))
    return std::to_string(colouring.colour_of.size()) + " colours for " +
           std::to_string(vertex_count(graph)) + " vertices";
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) {
    if (colouring.colour_of[v] >= colouring.colours)
      return "vertex " + std::to_string(v) + " has colour " + std::to_string(colouring.colour_of[v]) +
             " of " + std::to_string(colouring.colours);
    for (const std::uint32_t w : neighbours(graph, v))
      if (colouring.colour_of[w] == colouring.colour_of[v])
        return "neighbours " + std::to_string(v) + " and " + std::to_string(w) + " have one colour";
  }
  return std::nullopt;
}

std::optional<std::string> validate_edge_colouring(const CsrGraph& graph, const Colouring& colouring) {
  const auto edges = edges_of(graph);
  if (colouring.colour_of.size() != edges.size())
    return std::to_string(colouring.colour_of.size()) + " colours for " + std::to_string(edges.size()) +
           " edges";
  std::vector<std::vector<std::uint32_t>> at(vertex_count(graph));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (colouring.colour_of[e] >= colouring.colours)
      return "edge " + std::to_string(e) + " has colour " + std::to_string(colouring.colour_of[e]) + " of " +
             std::to_string(colouring.colours);
    for (const std::uint32_t end : edges[e]) at[end].push_back(colouring.colour_of[e]);
  }
  for (std::uint32_t v = 0; v < at.size(); ++v) {
    std::ranges::sort(at[v]);
    if (const auto twice = std::ranges::adjacent_find(at[v]); twice != at[v].end())
      return "two edges of colour " + std::to_string(*twice) + " meet at vertex " + std::to_string(v);
  }
  return std::nullopt;
}

}  // namespace leonhard::graph
