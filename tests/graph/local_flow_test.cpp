// SPDX-License-Identifier: MIT
#include "leonhard/graph/multilevel/local_flow.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

using leonhard::graph::detail::LocalFlow;

namespace {

/// Capacities between each two vertices, and of the source's and the sink's edges.
struct Network {
  std::vector<std::vector<std::int32_t>> capacity;
  std::vector<std::int32_t> from_source, to_sink;

  Network(std::uint32_t n, std::uint64_t seed) : capacity(n, std::vector<std::int32_t>(n, 0)) {
    std::mt19937_64 random(seed);
    const auto some = [&](unsigned largest) {
      return random() % 2 == 0 ? 0 : static_cast<std::int32_t>(random() % largest);
    };
    for (std::uint32_t v = 0; v < n; ++v) {
      for (std::uint32_t w = 0; w < v; ++w) {
        capacity[v][w] = some(6);
        capacity[w][v] = seed % 2 == 0 ? capacity[v][w] : some(6);
      }
      from_source.push_back(some(9));
      to_sink.push_back(some(9));
    }
  }

  void fill(LocalFlow& flow) const {
    flow.clear();
    for (std::uint32_t v = 0; v < capacity.size(); ++v) {
      flow.add_vertex();
      flow.add_source_edge(from_source[v]);
      flow.add_sink_edge(to_sink[v]);
      for (std::uint32_t w = 0; w < v; ++w)
        if (capacity[v][w] > 0 || capacity[w][v] > 0) flow.add_edge(w, capacity[v][w], capacity[w][v]);
    }
  }

  /// What leads out of a set of vertices and the source.
  [[nodiscard]] std::int64_t cut(std::uint32_t set) const {
    std::int64_t sum = 0;
    for (std::uint32_t v = 0; v < capacity.size(); ++v) {
      const bool inside = ((set >> v) & 1U) != 0;
      sum += inside ? to_sink[v] : from_source[v];
      for (std::uint32_t w = 0; inside && w < capacity.size(); ++w)
        if (((set >> w) & 1U) == 0) sum += capacity[v][w];
    }
    return sum;
  }
};

}  // namespace

TEST_CASE("a_maximum_flow_is_the_least_of_all_cuts_and_leads_to_the_smallest_and_the_largest_of_them") {
  LocalFlow flow;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    const auto n = static_cast<std::uint32_t>(1 + seed % 9);
    const Network network(n, seed);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::uint32_t common = 0, any = 0;  // of the source's sides of the least cuts
    for (std::uint32_t set = 0; set < 1U << n; ++set) {
      const std::int64_t cut = network.cut(set);
      if (cut > least) continue;
      common = cut < least ? set : common & set;
      any = cut < least ? set : any | set;
      least = cut;
    }
    network.fill(flow);
    CHECK(flow.maximum(std::numeric_limits<std::int64_t>::max()) == least);
    const std::vector<char> to_sink = flow.reaching_sink();
    for (std::uint32_t v = 0; v < n; ++v) {
      CHECK(flow.reached_from_source(v) == (((common >> v) & 1U) != 0));
      CHECK((to_sink[v] != 0) == (((any >> v) & 1U) == 0));
    }
  }
}
