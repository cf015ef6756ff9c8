// SPDX-License-Identifier: MIT
#include "leonhard/app/report/matrix_picture.hpp"

#include <fmt/format.h>

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
  std::vector<std::vector<std::size_t>> offsets(numberings.size());
  std::vector<std::vector<std::uint32_t>> links(numberings.size());
  std::vector<draw::MatrixPattern> patterns;
  for (std::size_t i = 0; i < numberings.size(); ++i) {
    const Numbering& numbering = numberings[i];
    const auto new_of_old = graph::invert(numbering.order);
    offsets[i].push_back(0);
    for (const std::uint32_t old : numbering.order) {
      for (const std::uint32_t neighbour : graph::neighbours(graph, old))
        links[i].push_back(new_of_old[neighbour]);
      offsets[i].push_back(links[i].size());
    }
    patterns.push_back({offsets[i], links[i], numbering.name,
                        fmt::format("bandwidth {}, envelope {}, fill {}", grouped(numbering.cost.bandwidth),
                                    grouped(numbering.cost.envelope), grouped(numbering.fill))});
  }
  draw::draw_pattern(path, patterns, title, size);
}

}  // namespace leonhard::app
