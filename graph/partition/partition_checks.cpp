// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/partition_checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph::detail {

void check_partition_request(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options) {
  const std::uint32_t n = vertex_count(graph);
  if (parts == 0) throw InputError("parts", "a partition into 0 parts", "ask for at least 1");
  if (parts > std::max(n, 1U))
    throw InputError("parts", std::to_string(parts) + " parts of " + std::to_string(n) + " vertices",
                     "ask for no more parts than there are vertices");
  if (!(options.imbalance >= 0) || !std::isfinite(options.imbalance))
    throw InputError("imbalance", "it is " + std::to_string(options.imbalance),
                     "give 0 or more, such as 0.03");
}

void check_partition(const PartitionView& partition, std::size_t expected, const char* what) {
  if (partition.parts == 0) throw InputError("partition", "it has 0 parts", "give at least 1");
  if (partition.part_of.size() != expected)
    throw InputError(
        "partition",
        std::to_string(partition.part_of.size()) + " entries for " + std::to_string(expected) + " " + what,
        "give the partition of these " + std::string(what));
  for (std::size_t i = 0; i < expected; ++i)
    if (partition.part_of[i] >= partition.parts)
      throw InputError("partition",
                       "entry " + std::to_string(i) + " names part " + std::to_string(partition.part_of[i]) +
                           " of " + std::to_string(partition.parts),
                       "number parts from 0");
}

}  // namespace leonhard::graph::detail
