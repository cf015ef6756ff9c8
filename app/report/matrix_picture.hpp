// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "leonhard/app/solve/run.hpp"
#include "leonhard/mesh/draw/picture.hpp"

namespace leonhard::app {

/// What a numbering of a graph's vertices costs.
///
/// order  order[new] = old
[[nodiscard]] Numbering numbering(std::string name, const graph::CsrGraph& graph,
                                  std::vector<std::uint32_t> order);

/// The graph as it is numbered and in reverse Cuthill-McKee order.
[[nodiscard]] std::vector<Numbering> both_numberings(const graph::CsrGraph& graph);

/// Patterns of the matrix of a graph in one or more numberings, side by side, with their costs.
void draw_matrix(const std::filesystem::path& path, const graph::CsrGraph& graph,
                 std::span<const Numbering> numberings, const std::string& title,
                 const draw::PictureSize& size = {});

}  // namespace leonhard::app
