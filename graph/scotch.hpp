// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/graph/partition.hpp"

/// Scotch behind the same door, to compare with: target leonhard::graph_scotch, built with -DLEONHARD_SCOTCH=ON. Scotch
/// is under the CeCILL-C licence, which asks something of those who pass on programs linked with it; nothing else of the
/// library needs it.
namespace leonhard::graph {

/// A partition by SCOTCH_graphPart.
///
/// options  imbalance, effort (high: Scotch's strategy for quality), seed and weights count; the others do not. Scotch
///          may miss the imbalance; the outcome then is `unbalanced`.
/// throws   InputError as partition() does, and where Scotch finds the input wrong
/// Scotch keeps global state: one thread at a time.
Partition partition_with_scotch(const CsrGraph& graph, std::uint32_t parts,
                                const PartitionOptions& options = {});

}  // namespace leonhard::graph
