// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition_options.hpp"
#include "leonhard/graph/partition_parts.hpp"

namespace leonhard::graph::detail {

/// What every partitioner refuses.
///
/// throws  InputError on no parts, more parts than vertices (but one part of no vertices is fine), and an imbalance that
///         is negative or not finite
void check_partition_request(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options);

/// throws  InputError on no parts, entries that are not as many as there are `what`, and a part out of range
void check_partition(const PartitionView& partition, std::size_t expected, const char* what);

}  // namespace leonhard::graph::detail
