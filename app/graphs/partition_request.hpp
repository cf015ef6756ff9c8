// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/app/command_line/command.hpp"
#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/graph/partition.hpp"

namespace leonhard::app {

/// How a graph is parted, in the words of the command line: what every subcommand that makes parts asks for.
struct PartitionRequest {
  std::string method = "multilevel", effort = "normal", of = "cells";
  std::uint32_t parts = 8;
  double imbalance = 0.03;
  bool connected = false;

  [[nodiscard]] GraphOf graph_of() const { return of == "vertices" ? GraphOf::vertices : GraphOf::cells; }
};

/// Adds -k, --method, --effort, --imbalance, --of and --connected to a subcommand.
void add_partition_options(Command& command, PartitionRequest& request);

/// Parts one graph into as many parts as asked for, also several times.
class Partitioner {
 public:
  /// input   must outlive the partitioner
  /// source  names the input in errors
  /// throws  InputError on weights of the input that partitions cannot take
  Partitioner(const AnyGraph& input, const std::string& source, const PartitionRequest& request,
              std::uint64_t seed, Progress progress);
  Partitioner(const Partitioner&) = delete;
  Partitioner& operator=(const Partitioner&) = delete;

  /// throws  InputError as graph::partition does, or METIS's and Scotch's
  [[nodiscard]] graph::Partition operator()(std::uint32_t parts) const;

  /// With the input's weights.
  [[nodiscard]] graph::PartitionCost cost_of(const graph::Partition& partition) const;

 private:
  const AnyGraph& input_;
  std::string method_;
  std::vector<std::uint32_t> vertex_weights_, edge_weights_;
  graph::PartitionOptions options_;
};

}  // namespace leonhard::app
