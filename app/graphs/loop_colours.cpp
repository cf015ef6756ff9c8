// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/loop_colours.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/number_text.hpp"

namespace leonhard::app {
namespace {

std::vector<std::size_t> sizes_of(const graph::Colouring& colouring) {
  std::vector<std::size_t> sizes(colouring.colours, 0);
  for (const std::uint32_t colour : colouring.colour_of) ++sizes[colour];
  return sizes;
}

std::string range_text(const graph::Colouring& colouring, std::string_view what) {
  const std::vector<std::size_t> sizes = sizes_of(colouring);
  if (sizes.empty()) return fmt::format("0 {}", what);
  const auto [least, most] = std::ranges::minmax(sizes);
  if (least == most) return fmt::format("{} {} each", grouped(most), what);
  return fmt::format("{} to {} {} each", grouped(least), grouped(most), what);
}

}  // namespace

LoopColours loop_colours(const graph::CsrGraph& graph, const graph::EdgeColouringOptions& options) {
  LoopColours colours;
  for (std::uint32_t v = 0; v < graph::vertex_count(graph); ++v)
    colours.max_degree = std::max(colours.max_degree, graph::degree(graph, v));
  colours.vertices = graph::colour_vertices(graph);
  colours.edges_greedily = graph::colour_edges_greedily(graph);
  colours.edges = graph::colour_edges(graph, options);
  return colours;
}

Json to_json(const LoopColours& colours) {
  return {{"max_degree", colours.max_degree},
          {"vertex_colours", colours.vertices.colours},
          {"vertices_of_colour", sizes_of(colours.vertices)},
          {"edge_colours", colours.edges.colours},
          {"edge_colours_are_fewest", colours.edges.certain},
          {"edges_of_colour", sizes_of(colours.edges)},
          {"edge_colours_greedily", colours.edges_greedily.colours}};
}

std::string loop_colours_text(const LoopColours& colours, std::string_view of) {
  std::string text = fmt::format("{:<12}{} in {} colours, {}\n", "loops", of, colours.vertices.colours,
                                 range_text(colours.vertices, of));
  text += fmt::format("{:<12}edges in {} colours{}, {}; the largest degree is {}; greedily {} colours\n", "",
                      colours.edges.colours, colours.edges.certain ? ", the fewest there can be" : "",
                      range_text(colours.edges, "edges"), colours.max_degree, colours.edges_greedily.colours);
  return text;
}

void write_vertex_colours(const std::filesystem::path& path, const LoopColours& colours) {
  std::string text;
  for (const std::uint32_t colour : colours.vertices.colour_of) {
    io::append_number(text, colour);
    text += '\n';
  }
  io::write_file_atomically(path, text);
}

void write_edge_colours(const std::filesystem::path& path, const graph::CsrGraph& graph,
                        const LoopColours& colours) {
  std::string text;
  std::size_t edge = 0;
  for (const auto& [from, to] : graph::edges_of(graph)) {
    io::append_number(text, from);
    text += ' ';
    io::append_number(text, to);
    text += ' ';
    io::append_number(text, colours.edges.colour_of[edge++]);
    text += '\n';
  }
  io::write_file_atomically(path, text);
}

}  // namespace leonhard::app
