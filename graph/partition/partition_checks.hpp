// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/graph/partition.hpp"

namespace leonhard::graph::detail {

/// What every partitioner refuses.
///
/// throws  InputError on no parts, more parts than vertices (but one part of no vertices is fine), and an imbalance that
///         is negative or not finite
void check_partition_request(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options);

}  // namespace leonhard::graph::detail
