// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "leonhard/app/report/json.hpp"
#include "leonhard/graph/colouring.hpp"

namespace leonhard::app {

/// Colours for loops over a mesh that threads share: what has one colour may be worked on at the same time. Loops over
/// vertices write to a vertex and read its neighbours; loops over edges write to both ends.
struct LoopColours {
  std::uint32_t max_degree{};
  graph::Colouring vertices;
  graph::Colouring edges_greedily;  ///< found faster, with some more colours
  graph::EdgeColouring edges;
};

/// Cost O(m max_degree) in practice.
[[nodiscard]] LoopColours loop_colours(const graph::CsrGraph& graph,
                                       const graph::EdgeColouringOptions& options);

/// Counts of colours, and of what has each; in the text vertices are named `of` (vertices_are).
[[nodiscard]] Json to_json(const LoopColours& colours);
[[nodiscard]] std::string loop_colours_text(const LoopColours& colours, std::string_view of);

/// The colour of each vertex on a line, and of each edge after its ends, smaller end first: "3 17 0". All numbers begin
/// at 0. Files appear whole or not at all. throws OutputError
void write_vertex_colours(const std::filesystem::path& path, const LoopColours& colours);
void write_edge_colours(const std::filesystem::path& path, const graph::CsrGraph& graph,
                        const LoopColours& colours);

}  // namespace leonhard::app
