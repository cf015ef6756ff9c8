// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator/separator.hpp"

#include "leonhard/graph/separator/multilevel_separator.hpp"

namespace leonhard::graph {

VertexSeparator vertex_separator(const CsrGraph& graph, const SeparatorOptions& options) {
  detail::check_separator_options(options.largest_side, options.tries);
  VertexSeparator result;
  if (vertex_count(graph) == 0) return result;
  const detail::KwayGraph weighted = detail::weighted_graph(graph, {}, {});
  detail::Random random(options.seed);
  const detail::FoundSeparator found =
      detail::multilevel_separator(weighted, options.largest_side, options.tries, random, options.stop);
  result.side_of.assign(found.side.begin(), found.side.end());
  result.size = static_cast<std::uint32_t>(found.quality.weight);
  return result;
}

}  // namespace leonhard::graph
