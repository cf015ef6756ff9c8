// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator.hpp"

#include <string>

#include "leonhard/graph/multilevel_separator.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {

VertexSeparator vertex_separator(const CsrGraph& graph, const SeparatorOptions& options) {
  if (!(options.largest_side > 0.5) || options.largest_side > 1 || options.tries == 0)
    throw InputError("options",
                     "largest side " + std::to_string(options.largest_side) + ", " +
                         std::to_string(options.tries) + " tries",
                     "give a side in (1/2, 1] and at least one try");
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
