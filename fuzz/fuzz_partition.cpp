// SPDX-License-Identifier: MIT
// Random graphs through every partitioner: no part is heavier than allowed, none is empty, the same call gives the same
// partition, connected parts are connected where the outcome says so.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/graph/partition.hpp"

namespace {

using namespace leonhard;
using namespace leonhard::graph;

struct Case {
  std::uint32_t vertices{}, parts{};
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> weights;
  std::vector<Point2> points;
  PartitionOptions options;
};

Case case_from(fuzzing::Input& in) {
  Case c;
  c.vertices = 1 + in.take<std::uint8_t>();
  c.parts = 1 + in.take<std::uint8_t>() % c.vertices;
  c.options.method = static_cast<PartitionMethod>(in.take<std::uint8_t>() % 6);
  c.options.effort = static_cast<Effort>(in.take<std::uint8_t>() % 2);
  c.options.imbalance = in.take<std::uint8_t>() / 200.0;
  c.options.seed = in.take<std::uint8_t>();
  const auto flags = in.take<std::uint8_t>();
  c.options.connected = (flags & 1) != 0;
  for (std::uint32_t v = 0; v < c.vertices; ++v) {
    if (flags & 2) c.weights.push_back(1 + in.take<std::uint8_t>());
    c.points.push_back({in.small(), in.small()});
  }
  while (!in.empty()) {
    const std::uint32_t from = in.take<std::uint8_t>(), to = in.take<std::uint8_t>();
    c.edges.push_back({from % c.vertices, to % c.vertices});
  }
  return c;
}

[[noreturn]] void report(const std::string& broken, const Case& c) {
  std::fprintf(stderr, "\n%s, for %u parts by method %d, effort %d, imbalance %.17g, seed %d, connected %d\n",
               broken.c_str(), c.parts, static_cast<int>(c.options.method),
               static_cast<int>(c.options.effort), c.options.imbalance, static_cast<int>(c.options.seed),
               static_cast<int>(c.options.connected));
  std::fprintf(stderr, "graph_from_edges(%u, Edges{", c.vertices);
  for (const auto& e : c.edges) std::fprintf(stderr, "{%u, %u}, ", e[0], e[1]);
  std::fprintf(stderr, "});\nweights {");
  for (const std::uint32_t w : c.weights) std::fprintf(stderr, "%u, ", w);
  std::fprintf(stderr, "}\n");
  std::abort();
}

void check(const Case& c) {
  const CsrGraph graph = graph_from_edges(c.vertices, c.edges).graph;
  PartitionOptions options = c.options;
  options.vertex_weights = c.weights;
  options.coordinates = std::span<const Point2>(c.points);
  const Partition found = partition(graph, c.parts, options);
  if (found.part_of.size() != c.vertices || found.parts != c.parts) report("wrong size", c);
  const PartitionCost cost = partition_cost(graph, found, c.weights);  // throws on a part out of range
  std::int64_t total = 0;
  for (const std::uint64_t weight : cost.weights) total += static_cast<std::int64_t>(weight);
  const auto heaviest =
      static_cast<std::int64_t>(*std::max_element(cost.weights.begin(), cost.weights.end()));
  const bool balanced = heaviest <= heaviest_allowed(total, c.parts, options.imbalance);
  if (balanced == (found.outcome == PartitionOutcome::unbalanced))
    report("the outcome is wrong about the balance", c);
  if (c.weights.empty() && !balanced) report("a part is too heavy", c);
  if (cost.smallest == 0) report("a part is empty", c);
  if (options.connected && found.outcome == PartitionOutcome::done && cost.max_components > 1)
    report("a part is not connected", c);
  if (options.connected && found.outcome == PartitionOutcome::disconnected && cost.max_components == 1)
    report("the parts are connected", c);
  if (partition(graph, c.parts, options).part_of != found.part_of) report("twice is not the same", c);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input in(data, size);
  if (size < 8) return 0;
  check(case_from(in));
  return 0;
}
