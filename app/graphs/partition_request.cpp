// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/partition_request.hpp"

#include <fmt/core.h>

#include <limits>
#include <string_view>
#include <utility>

#ifdef LEONHARD_HAS_METIS
#include "leonhard/graph/metis.hpp"
#endif
#ifdef LEONHARD_HAS_SCOTCH
#include "leonhard/graph/scotch.hpp"
#endif
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

using graph::Effort;
using graph::PartitionOutcome;

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const auto& known : graph::named_partition_methods) names.emplace_back(known.first);
#ifdef LEONHARD_HAS_METIS
  names.insert(names.end(), {"metis", "metis-recursive"});
#endif
#ifdef LEONHARD_HAS_SCOTCH
  names.emplace_back("scotch");
#endif
  return names;
}

Effort effort_named(std::string_view name) {
  return name == "low" ? Effort::low : name == "high" ? Effort::high : Effort::normal;
}

std::vector<std::uint32_t> as_weights(const std::vector<std::int64_t>& given, const std::string& file) {
  std::vector<std::uint32_t> weights;
  for (const std::int64_t weight : given) {
    if (weight < 1 || weight > std::numeric_limits<std::uint32_t>::max())
      throw InputError(file, fmt::format("a weight of {}", weight),
                       "partitions take weights from 1 to 2^32 - 1");
    weights.push_back(static_cast<std::uint32_t>(weight));
  }
  return weights;
}

}  // namespace

void add_partition_options(Command& command, PartitionRequest& request) {
  const std::vector<Option> options{
      {.names = "-k,--parts",
       .help = "How many parts",
       .target = &request.parts,
       .shows_default = true,
       .range = OptionRange{1, std::numeric_limits<std::uint32_t>::max()}},
      {.names = "--method",
       .help = "How to find them",
       .target = &request.method,
       .shows_default = true,
       .choices = method_names()},
      {.names = "--effort",
       .help = "How long the multilevel method tries",
       .target = &request.effort,
       .shows_default = true,
       .choices = {"low", "normal", "high"}},
      {.names = "--imbalance",
       .help = "How much heavier than the mean a part may be: 0.03 is 3 %",
       .target = &request.imbalance,
       .shows_default = true,
       .rule = OptionRule::not_negative},
      {.names = "--of",
       .help = "What of a mesh is parted: its triangles or tetrahedra, or its vertices",
       .target = &request.of,
       .shows_default = true,
       .choices = {"cells", "vertices"}},
      {"--connected", "Try to have every part in one piece", &request.connected}};
  command.options.insert(command.options.end(), options.begin(), options.end());
}

Partitioner::Partitioner(const AnyGraph& input, const std::string& source, const PartitionRequest& request,
                         std::uint64_t seed, Progress progress)
    : input_(input), method_(request.method) {
  if (input.weights_each > 1)
    throw InputError(source, fmt::format("{} weights a vertex", input.weights_each),
                     "partitions balance one weight a vertex");
  vertex_weights_ = as_weights(input.vertex_weights, source);
  edge_weights_ = as_weights(input.edge_weights, source);
  for (const auto& [name, method] : graph::named_partition_methods)
    if (name == method_) options_.method = method;
  options_.effort = effort_named(request.effort);
  options_.imbalance = request.imbalance;
  options_.seed = seed;
  options_.connected = request.connected;
  options_.vertex_weights = vertex_weights_;
  options_.edge_weights = edge_weights_;
  options_.coordinates = std::span<const Point3>(input.coordinates);
  options_.progress = std::move(progress);
}

graph::Partition Partitioner::operator()(std::uint32_t parts) const {
#ifdef LEONHARD_HAS_METIS
  if (method_ == "metis") return graph::partition_with_metis(input_.graph, parts, options_);
  if (method_ == "metis-recursive")
    return graph::partition_with_metis(input_.graph, parts, options_, graph::MetisScheme::recursive);
#endif
#ifdef LEONHARD_HAS_SCOTCH
  if (method_ == "scotch") return graph::partition_with_scotch(input_.graph, parts, options_);
#endif
  return graph::partition(input_.graph, parts, options_);
}

graph::PartitionCost Partitioner::cost_of(const graph::Partition& partition) const {
  return graph::partition_cost(input_.graph, partition, vertex_weights_, edge_weights_);
}

}  // namespace leonhard::app
