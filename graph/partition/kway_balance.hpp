// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"

namespace leonhard::graph::detail {

/// Makes a partition keep the limit and leave no part empty, changing no more than that needs.
///
/// part_of  changed in place: first by moves that cost the cut least, if those do not lead there by filling the
///          lightest part with the heaviest vertex again and again (Graham 1969); untouched if it fits as it is
/// returns  whether every part keeps the limit; always if all vertices weigh the same
[[nodiscard]] bool keep_limit(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
                              std::vector<std::uint32_t>& part_of);

}  // namespace leonhard::graph::detail
