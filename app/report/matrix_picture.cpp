// SPDX-License-Identifier: MIT
#include "leonhard/app/report/matrix_picture.hpp"

#include <fmt/core.h>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/draw/pattern.hpp"

namespace leonhard::app {

Numbering numbering(std::string name, const graph::CsrGraph& graph, std::vector<std::uint32_t> order) {
  return {std::move(name), graph::ordering_cost(graph, order), graph::cholesky_fill(graph, order).fill,
          std::move(order)};
}

std::vector<Numbering> both_numberings(const graph::CsrGraph& graph) {
  std::vector<Numbering> both;
  both.push_back(numbering("as meshed", graph, graph::natural_order(graph)));
  both.push_back(numbering("reverse Cuthill-McKee", graph, graph::reverse_cuthill_mckee(graph)));
  return both;
}

void draw_matrix(const std::filesystem::path& path, const graph::CsrGraph& graph,
                 std::span<const Numbering> numberings, const std::string& title,
                 const draw::PictureSize& size) {
  std::vector<std::uint32_t> offsets{0}, links;
  for (std::uint32_t row = 0; row < graph::vertex_count(graph); ++row) {
    const auto neighbours = graph::neighbours(graph, row);
    links.insert(links.end(), neighbours.begin(), neighbours.end());
    offsets.push_back(static_cast<std::uint32_t>(links.size()));
  }
  std::vector<draw::MatrixPattern> patterns;
  for (const Numbering& numbering : numberings) {
    patterns.push_back(
        {.offsets = offsets,
         .links = links,
         .order = numbering.order,
         .title = numbering.name,
         .subtitle = fmt::format("bandwidth {}, envelope {}, fill {}", grouped(numbering.cost.bandwidth),
                                 grouped(numbering.cost.envelope), grouped(numbering.fill))});
  }
  draw::draw_pattern(path, patterns, title, size);
}

}  // namespace leonhard::app
