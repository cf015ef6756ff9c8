// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard::graph {

enum class PartitionOutcome {
  done,
  empty_parts,  ///< more parts than vertices were asked for: the first n parts hold one vertex, the rest none
  stopped,      ///< stop was requested: a valid balanced partition, but not refined as it would have been
  unbalanced,   ///< vertices so heavy that no partition within the imbalance was found
  disconnected,  ///< connected parts were asked for, and none within the imbalance were found
};

/// The word for it, e.g. "done".
[[nodiscard]] constexpr std::string_view to_string(PartitionOutcome outcome) {
  switch (outcome) {
    case PartitionOutcome::done:
      return "done";
    case PartitionOutcome::empty_parts:
      return "empty_parts";
    case PartitionOutcome::stopped:
      return "stopped";
    case PartitionOutcome::unbalanced:
      return "unbalanced";
    case PartitionOutcome::disconnected:
      return "disconnected";
  }
  return "";
}

/// To each vertex of a graph, or to each point, its part.
struct [[nodiscard]] Partition {
  std::uint32_t parts{};
  std::vector<std::uint32_t> part_of;  ///< one a vertex, each below `parts`
  PartitionOutcome outcome = PartitionOutcome::done;
};

/// A partition that knows what was cut: the parts of triangles are no parts of vertices.
template <class IdT>
struct [[nodiscard]] PartitionOf {
  std::uint32_t parts{};
  PerId<IdT, std::uint32_t> part_of;  ///< each below `parts`
  PartitionOutcome outcome = PartitionOutcome::done;
};
using VertexPartition = PartitionOf<VertexId>;
using TrianglePartition = PartitionOf<TriangleId>;
using TetPartition = PartitionOf<TetId>;

/// Says what the vertices of a partitioned graph are in the mesh, such as triangles where the dual graph was cut:
///
///   const auto parts = partition_of<TriangleId>(partition(dual_graph(mesh), 16));
template <class IdT>
PartitionOf<IdT> partition_of(Partition partition) {
  return {partition.parts, PerId<IdT, std::uint32_t>(std::move(partition.part_of)), partition.outcome};
}

/// Any partition, for functions that look at the graph alone; valid as long as the partition is.
struct PartitionView {
  std::uint32_t parts;
  std::span<const std::uint32_t> part_of;

  PartitionView(const Partition& partition) : parts(partition.parts), part_of(partition.part_of) {}
  template <class IdT>
  PartitionView(const PartitionOf<IdT>& partition)
      : parts(partition.parts), part_of(partition.part_of.flat()) {}
};

}  // namespace leonhard::graph
