// SPDX-License-Identifier: MIT
// Partitions beside METIS' and Scotch's: the same graphs, k = 2 ... 64 at 3 %, in one process, turn and turn about; the
// shortest turn of each counts. Cuts and times are over those of METIS' k-way method, geometric means over all k.
//   compare_partition [--effort low|normal|high] [--turns N] [GRAPH ...]     without graphs: generated meshes
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/point_sets.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/metis.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/scotch.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/edges.hpp"

namespace {

using namespace leonhard;
using graph::CsrGraph;

constexpr std::array<std::uint32_t, 6> part_counts{2, 4, 8, 16, 32, 64};

struct Named {
  std::string name;
  CsrGraph graph;
};

struct Method {
  const char* name;
  std::function<graph::Partition(const CsrGraph&, std::uint32_t, const graph::PartitionOptions&)> partition;
};

const std::array<Method, 4> methods{{
    {"METIS k-way", [](const CsrGraph& g, std::uint32_t k,
                       const graph::PartitionOptions& o) { return graph::partition_with_metis(g, k, o); }},
    {"METIS rec.",
     [](const CsrGraph& g, std::uint32_t k, const graph::PartitionOptions& o) {
       return graph::partition_with_metis(g, k, o, graph::MetisScheme::recursive);
     }},
    {"Scotch", [](const CsrGraph& g, std::uint32_t k,
                  const graph::PartitionOptions& o) { return graph::partition_with_scotch(g, k, o); }},
    {"Leonhard", [](const CsrGraph& g, std::uint32_t k,
                    const graph::PartitionOptions& o) { return graph::partition(g, k, o); }},
}};

/// A graph's or all graphs' sums of logarithms, by method.
struct Means {
  std::array<double, methods.size()> cut{}, time{};
  std::array<int, methods.size()> over_limit{};
  int count = 0;

  void add(const Means& other) {
    for (std::size_t i = 0; i < methods.size(); ++i) {
      cut[i] += other.cut[i];
      time[i] += other.time[i];
      over_limit[i] += other.over_limit[i];
    }
    count += other.count;
  }
  void print(const std::string& name) const {
    fmt::print("{:<22}", name);
    for (std::size_t i = 0; i < methods.size(); ++i)
      fmt::print("  {:6.3f} {:6.2f} {:3}", std::exp((cut[i] - cut[0]) / count),
                 std::exp((time[i] - time[0]) / count), over_limit[i]);
    fmt::print("\n");
    std::fflush(stdout);
  }
};

Means measured(const CsrGraph& graph, const graph::PartitionOptions& options, int turns) {
  Means means;
  for (const std::uint32_t parts : part_counts) {
    if (parts > graph::vertex_count(graph)) continue;
    const auto limit = static_cast<std::uint64_t>(
        graph::heaviest_allowed(graph::vertex_count(graph), parts, options.imbalance));
    std::array<double, methods.size()> shortest;
    shortest.fill(1e9);
    for (int turn = 0; turn < turns; ++turn)
      for (std::size_t i = 0; i < methods.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        const graph::Partition found = methods[i].partition(graph, parts, options);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        shortest[i] = std::min(shortest[i], taken.count());
        if (turn > 0) continue;
        const graph::PartitionCost cost = graph::partition_cost(graph, found);
        means.cut[i] += std::log(std::max<double>(1, static_cast<double>(cost.cut)));
        means.over_limit[i] += cost.largest > limit ? 1 : 0;
      }
    for (std::size_t i = 0; i < methods.size(); ++i) means.time[i] += std::log(shortest[i]);
    ++means.count;
  }
  return means;
}

CsrGraph box(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::uint32_t z = 0; z < nz; ++z)
    for (std::uint32_t y = 0; y < ny; ++y)
      for (std::uint32_t x = 0; x < nx; ++x) {
        const std::uint32_t v = (z * ny + y) * nx + x;
        if (x + 1 < nx) edges.push_back({v, v + 1});
        if (y + 1 < ny) edges.push_back({v, v + nx});
        if (z + 1 < nz) edges.push_back({v, v + nx * ny});
      }
  return graph::graph_from_edges(nx * ny * nz, edges).graph;
}

std::vector<Named> generated() {
  std::vector<Named> graphs;
  for (const std::size_t n : {std::size_t{10'000}, std::size_t{100'000}}) {
    const TriangleMesh mesh = delaunay::triangulate(benching::uniform_points(n)).mesh;
    graphs.push_back(
        {fmt::format("triangulation {}", n), graph::vertex_graph(mesh, mesh::build_edges(mesh))});
    graphs.push_back({fmt::format("its dual"), graph::dual_graph(mesh)});
  }
  graphs.push_back({"grid 200 x 200", box(200, 200, 1)});
  graphs.push_back({"grid 30 x 30 x 30", box(30, 30, 30)});
  return graphs;
}

graph::Effort effort_named(std::string_view name) {
  if (name == "low") return graph::Effort::low;
  if (name == "high") return graph::Effort::high;
  if (name == "normal") return graph::Effort::normal;
  throw InputError("--effort", std::string(name) + " is none", "give low, normal or high");
}

void compare(int argc, char** argv) {
  graph::PartitionOptions options;
  int turns = 3;
  std::vector<Named> graphs;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--effort" && i + 1 < argc)
      options.effort = effort_named(argv[++i]);
    else if (argument == "--turns" && i + 1 < argc)
      turns = std::max(1, std::atoi(argv[++i]));
    else
      graphs.push_back({std::filesystem::path(argument).stem().string(), graph::read_graph(argument).graph});
  }
  if (graphs.empty()) graphs = generated();
  fmt::print("k = 2 4 8 16 32 64 at 3 %: cut and time over METIS k-way, partitions over the bound\n{:<22}",
             "graph");
  for (const Method& method : methods) fmt::print("  {:>17}", method.name);
  fmt::print("\n");
  Means all;
  for (const Named& named : graphs) {
    const Means means = measured(named.graph, options, turns);
    means.print(named.name);
    all.add(means);
  }
  all.print("all");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    compare(argc, argv);
  } catch (const InputError& error) {
    fmt::print(stderr, "compare_partition: {}\n", error.what());
    return 1;
  }
  return 0;
}
