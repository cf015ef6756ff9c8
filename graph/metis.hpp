// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/graph/partition.hpp"

/// METIS behind the same door, to compare with: target leonhard::graph_metis, built with -DLEONHARD_METIS=ON. METIS 5.1
/// is under the Apache licence 2.0; nothing else of the library needs it.
namespace leonhard::graph {

enum class MetisScheme { k_way, recursive };

/// A partition by METIS_PartGraphKway or METIS_PartGraphRecursive.
///
/// options  imbalance (in steps of 0.001), seed, weights and connected (k-way only) count; the others do not. METIS may
///          miss the imbalance; the outcome then is `unbalanced`.
/// throws   InputError as partition() does, and where METIS finds the input wrong
/// METIS keeps global state: one thread at a time.
Partition partition_with_metis(const CsrGraph& graph, std::uint32_t parts,
                               const PartitionOptions& options = {}, MetisScheme scheme = MetisScheme::k_way);

}  // namespace leonhard::graph
