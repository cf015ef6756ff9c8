// SPDX-License-Identifier: MIT
#include <algorithm>

#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/ordering/by_component.hpp"

namespace leonhard::graph {

OrderResult spectral_order(const CsrGraph& graph, std::uint64_t seed, const Progress& progress) {
  OrderResult result;
  result.order = detail::order_by_component(graph, [&](const CsrGraph& connected, const auto&) {
    FiedlerOptions options;
    options.tolerance = 1e-4;
    options.seed = seed;
    options.stop = progress.stop;
    const Fiedler pair = fiedler(connected, options);
    if (pair.outcome == FiedlerOutcome::stopped) result.outcome = OrderOutcome::stopped;
    std::vector<std::uint32_t> order = natural_order(connected);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t v) { return pair.vector[v]; });
    return detail::better_direction(connected, std::move(order));
  });
  return result;
}

}  // namespace leonhard::graph
