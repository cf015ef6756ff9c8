// SPDX-License-Identifier: MIT
// Orderings beside Boost.Graph's and METIS': same graph, turn and turn about; the shortest of three turns counts.
//   compare_graph orderings [SIZE | GRAPH...]     a triangulation of so many random points (10^6), or graph files
//   compare_graph growth [SIZE | NAME...]         seconds of all methods by size (10^3 10^4 10^5 10^6), or of those
//                                                 whose names hold one of the words
//   compare_graph spectral GRAPH...               lambda_2 and the cuts of recursive spectral bisection
//   compare_graph                                 the first two
#include <fmt/format.h>
#include <metis.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <boost/graph/sloan_ordering.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/point_sets.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/boost_graph.hpp"
#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/graph/order.hpp"
#include "leonhard/graph/ordering/nested_dissection.hpp"
#include "leonhard/graph/orientation.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/mesh/edges.hpp"

namespace {

using namespace leonhard;
using graph::CsrGraph;
using Order = std::vector<std::uint32_t>;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct MeshGraph {
  CsrGraph graph;
  std::vector<Point2> points;
};

MeshGraph mesh_graph(std::size_t vertices) {
  delaunay::TriangulateOptions options;
  options.threads = 1;
  const TriangleMesh mesh = delaunay::triangulate(benching::uniform_points(vertices), options).mesh;
  return {graph::vertex_graph(mesh, mesh::build_edges(mesh)), {mesh.points.begin(), mesh.points.end()}};
}

// ---- peers ----

using BoostGraph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::undirectedS,
    boost::property<
        boost::vertex_color_t, boost::default_color_type,
        boost::property<boost::vertex_degree_t, int, boost::property<boost::vertex_priority_t, double>>>>;

BoostGraph boost_graph(const CsrGraph& graph) {
  BoostGraph result(graph::vertex_count(graph));
  for (const auto& [a, b] : graph::edges_of(graph)) boost::add_edge(a, b, result);
  const auto degree = boost::get(boost::vertex_degree, result);
  for (std::uint32_t v = 0; v < graph::vertex_count(graph); ++v)
    degree[v] = static_cast<int>(graph::degree(graph, v));
  return result;
}

/// Reversed, as boost_cuthill_mckee_example does it.
Order boost_reverse_cuthill_mckee(BoostGraph& graph) {
  Order order(boost::num_vertices(graph));
  boost::cuthill_mckee_ordering(graph, order.rbegin(), boost::get(boost::vertex_color, graph),
                                boost::get(boost::vertex_degree, graph));
  return order;
}

/// The same algorithm on our compressed rows.
Order boost_reverse_cuthill_mckee(const CsrGraph& graph) {
  const std::uint32_t n = graph::vertex_count(graph);
  Order order(n);
  std::vector<boost::default_color_type> colour(n);
  std::vector<std::uint32_t> degree(n);
  for (std::uint32_t v = 0; v < n; ++v) degree[v] = graph::degree(graph, v);
  const auto index = get(boost::vertex_index, graph);
  boost::cuthill_mckee_ordering(graph, order.rbegin(),
                                boost::make_iterator_property_map(colour.begin(), index),
                                boost::make_iterator_property_map(degree.begin(), index));
  return order;
}

Order boost_sloan(BoostGraph& graph) {
  Order order(boost::num_vertices(graph));
  boost::sloan_ordering(graph, order.begin(), boost::get(boost::vertex_color, graph),
                        boost::get(boost::vertex_degree, graph), boost::get(boost::vertex_priority, graph));
  return order;
}

struct MetisGraph {
  std::vector<idx_t> start{0}, links;
  explicit MetisGraph(const CsrGraph& graph) {
    for (std::uint32_t v = 0; v < graph::vertex_count(graph); ++v) {
      for (const std::uint32_t w : graph::neighbours(graph, v)) links.push_back(static_cast<idx_t>(w));
      start.push_back(static_cast<idx_t>(links.size()));
    }
  }
  [[nodiscard]] Order dissection() {
    auto n = static_cast<idx_t>(start.size() - 1);
    std::vector<idx_t> order(start.size() - 1), place(start.size() - 1);
    METIS_NodeND(&n, start.data(), links.data(), nullptr, nullptr, order.data(), place.data());
    return {order.begin(), order.end()};
  }
};

// ---- tables ----

struct Contender {
  std::string name;
  std::function<Order()> order;
};

void compare(const CsrGraph& graph, const std::vector<Contender>& contenders, int turns) {
  fmt::print("{:<34}{:>9}{:>10}{:>14}{:>16}{:>11}\n", "", "seconds", "bandwidth", "envelope", "nonzeros of L",
             "flops");
  std::vector<double> shortest(contenders.size(), std::numeric_limits<double>::max());
  std::vector<Order> orders(contenders.size());
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t i = 0; i < contenders.size(); ++i)
      if (turn == 0 || shortest[i] < 10)
        shortest[i] = std::min(shortest[i], seconds_of([&] { orders[i] = contenders[i].order(); }));
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    const graph::OrderingCost cost = graph::ordering_cost(graph, orders[i]);
    const graph::CholeskyFill fill = graph::cholesky_fill(graph, orders[i]);
    fmt::print("{:<34}{:>9.3f}{:>10}{:>14}{:>16}{:>11.3g}\n", contenders[i].name, shortest[i], cost.bandwidth,
               cost.envelope, fill.nonzeros, fill.flops);
  }
  std::fflush(stdout);
}

void compare_graph(const std::string& name, const CsrGraph& graph, int turns) {
  fmt::print("\n{}: {} vertices, {} edges\n", name, graph::vertex_count(graph), graph::edge_count(graph));
  BoostGraph lists = boost_graph(graph);
  MetisGraph metis(graph);
  constexpr std::uint32_t largest_for_list_sort = 50000;
  std::vector<Contender> contenders{
      {"Leonhard reverse Cuthill-McKee", [&] { return graph::reverse_cuthill_mckee(graph); }},
      {"Boost cuthill_mckee, adjacency list", [&] { return boost_reverse_cuthill_mckee(lists); }},
      {"Boost cuthill_mckee, our rows", [&] { return boost_reverse_cuthill_mckee(graph); }},
      {"Leonhard King", [&] { return graph::king(graph); }},
      {"Leonhard Sloan", [&] { return graph::sloan(graph); }},
      {"Leonhard spectral", [&] { return graph::spectral_order(graph).order; }},
      {"Leonhard nested dissection", [&] { return graph::nested_dissection(graph).order; }},
      {"METIS NodeND", [&] { return metis.dissection(); }}};
  if (graph::vertex_count(graph) <= largest_for_list_sort)
    contenders.push_back({"Boost sloan", [&] { return boost_sloan(lists); }});
  compare(graph, contenders, turns);
}

// ---- growth ----

/// Seconds of one method after another by size, each once. A size is left out where what went before makes one expect
/// more than `patience` seconds.
class GrowthTable {
 public:
  GrowthTable(const std::vector<std::size_t>& sizes, std::vector<std::string> wanted)
      : wanted_(std::move(wanted)) {
    fmt::print("\nseconds on triangulations of random points ({} s at most expected)\n{:<36}", patience, "");
    for (const std::size_t n : sizes) {
      graphs_.push_back(mesh_graph(n));
      fmt::print("{:>10}", n);
    }
    fmt::print("\n");
  }

  /// exponent  of the growth expected, where less is measured
  template <class Work>
  void line(const std::string& name, const Work& work, double exponent = 1) {
    if (!is_wanted(name)) return;
    fmt::print("{:<36}", name);
    double last = 0;
    for (std::size_t i = 0; i < graphs_.size(); ++i) {
      if (i > 0 && last * std::pow(size(i) / size(i - 1), exponent) > patience) break;
      const double before = std::exchange(last, seconds_of([&] { work(graphs_[i]); }));
      if (i > 0 && before > 0)
        exponent = std::max(exponent, std::log(last / before) / std::log(size(i) / size(i - 1)));
      fmt::print("{:>10.3f}", last);
      std::fflush(stdout);
    }
    fmt::print("\n");
  }

 private:
  static constexpr double patience = 60;

  [[nodiscard]] bool is_wanted(const std::string& name) const {
    return wanted_.empty() || std::ranges::any_of(wanted_, [&](const std::string& word) {
             return name.find(word) != std::string::npos;
           });
  }

  [[nodiscard]] double size(std::size_t i) const { return graph::vertex_count(graphs_[i].graph); }

  std::vector<std::string> wanted_;
  std::vector<MeshGraph> graphs_;
};

void show_orderings(GrowthTable& table) {
  for (const auto& [name, method, of_boost] : graph::named_order_methods) {
    if (of_boost) continue;  // hours, some of them
    table.line(
        std::string(name),
        [method = method](const MeshGraph& mesh) {
          std::vector<Point3> points;
          if (method == graph::OrderMethod::hilbert)
            for (const Point2& p : mesh.points) points.push_back({p.x, p.y, 0});
          static_cast<void>(graph::order(mesh.graph, {.method = method, .coordinates = points}));
        },
        method == graph::OrderMethod::rosen ? 3 : 1);
  }
}

void show_partitions(GrowthTable& table) {
  using graph::Effort;
  using graph::PartitionMethod;
  struct Line {
    const char* name;
    PartitionMethod method;
    std::uint32_t parts;
    Effort effort = Effort::normal;
  };
  for (const Line& line :
       {Line{"coordinate, 16 parts", PartitionMethod::coordinate, 16},
        Line{"inertial, 16 parts", PartitionMethod::inertial, 16},
        Line{"cuthill-mckee, 16 parts", PartitionMethod::cuthill_mckee, 16},
        Line{"cuthill-mckee-levels, 16 parts", PartitionMethod::cuthill_mckee_levels, 16},
        Line{"spectral, 2 parts", PartitionMethod::spectral, 2},
        Line{"spectral, 16 parts", PartitionMethod::spectral, 16},
        Line{"multilevel, effort low, 16 parts", PartitionMethod::multilevel, 16, Effort::low},
        Line{"multilevel, effort normal, 16 parts", PartitionMethod::multilevel, 16, Effort::normal},
        Line{"multilevel, effort high, 16 parts", PartitionMethod::multilevel, 16, Effort::high}})
    table.line(line.name, [&](const MeshGraph& mesh) {
      graph::PartitionOptions options;
      options.method = line.method;
      options.effort = line.effort;
      options.coordinates = std::span<const Point2>(mesh.points);
      static_cast<void>(graph::partition(mesh.graph, line.parts, options));
    });
}

void show_growth(const std::vector<std::size_t>& sizes, const std::vector<std::string>& wanted) {
  GrowthTable table(sizes, wanted);
  show_orderings(table);
  show_partitions(table);
  const auto line = [&](const char* name, const auto& work) {
    table.line(name, [&](const MeshGraph& mesh) { static_cast<void>(work(mesh.graph)); });
  };
  line("orientation", [](const CsrGraph& graph) { return graph::orient_planar(graph); });
  line("edge colouring", [](const CsrGraph& graph) { return graph::colour_edges(graph); });
  line("edge colouring, greedy", [](const CsrGraph& graph) { return graph::colour_edges_greedily(graph); });
  line("vertex colouring", [](const CsrGraph& graph) { return graph::colour_vertices(graph); });
  line("fill by column counts",
       [](const CsrGraph& graph) { return graph::cholesky_fill(graph, graph::natural_order(graph)); });
}

// ---- spectral ----

void show_spectral(const std::vector<std::string>& files) {
  fmt::print("{:<24}{:>14}{:>12}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}\n", "spectral bisection", "lambda_2",
             "residual", 2, 4, 8, 16, 32, 64);
  for (const std::string& file : files) {
    const CsrGraph graph = graph::read_graph(file).graph;
    graph::FiedlerOptions options;
    options.tolerance = 1e-7;
    const graph::Fiedler pair = graph::fiedler(graph, options);
    fmt::print("{:<24}{:>14.8g}{:>12.1e}", std::filesystem::path(file).stem().string(), pair.value,
               pair.residual);
    for (std::uint32_t parts = 2; parts <= 64; parts *= 2)
      fmt::print("{:>7}",
                 graph::partition_cost(graph, graph::recursive_spectral_bisection(graph, parts)).cut);
    fmt::print("\n");
    std::fflush(stdout);
  }
}

std::size_t size_named(const std::string& word) {
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
  return error == std::errc() && end == word.data() + word.size() ? size : 0;
}

void show_peers(const std::vector<std::string>& words) {
  constexpr int turns = 3;
  for (const std::string& word : words)
    if (const std::size_t size = size_named(word); size > 0)
      compare_graph("triangulation of random points", mesh_graph(size).graph, turns);
    else
      compare_graph(word, graph::read_graph(word).graph, turns);
}

int run(const std::string& subject, const std::vector<std::string>& words) {
  if (subject == "growth") {
    std::vector<std::size_t> sizes;
    std::vector<std::string> names;
    for (const std::string& word : words)
      if (const std::size_t size = size_named(word); size > 2)
        sizes.push_back(size);
      else
        names.push_back(word);
    show_growth(sizes.empty() ? std::vector<std::size_t>{1000, 10'000, 100'000, 1'000'000} : sizes, names);
  } else if (subject == "orderings") {
    show_peers(words.empty() ? std::vector<std::string>{"1000000"} : words);
  } else if (subject == "spectral" && !words.empty()) {
    show_spectral(words);
  } else if (subject.empty()) {
    return run("orderings", {}) + run("growth", {});
  } else {
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + std::min(argc, 2), argv + argc);
  const int outcome = run(argc > 1 ? argv[1] : "", words);
  if (outcome != 0)
    fmt::print(
        stderr,
        "usage: compare_graph [orderings [SIZE | GRAPH...] | growth [SIZE | NAME...] | spectral GRAPH...]\n");
  return outcome;
}
