// SPDX-License-Identifier: MIT
// Orderings beside Boost.Graph's and METIS': same graph, turn and turn about; the shortest turn of each counts.
//   compare_graph [VERTICES = 1000000] [TURNS = 3]     a triangulation of random points of so many vertices
//   compare_graph GRAPH...                             graph files
#include <fmt/format.h>
#include <metis.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <boost/graph/sloan_ordering.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "bench/point_sets.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/graph/nested_dissection.hpp"
#include "leonhard/graph/order.hpp"
#include "leonhard/graph/orientation.hpp"
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

CsrGraph mesh_graph(std::size_t vertices) {
  delaunay::TriangulateOptions options;
  options.threads = 1;
  const TriangleMesh mesh = delaunay::triangulate(benching::uniform_points(vertices), options).mesh;
  return graph::vertex_graph(mesh, mesh::build_edges(mesh));
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
  const auto index = boost::get(boost::vertex_index, graph);
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
      {"Leonhard Sloan", [&] { return graph::sloan(graph); }},
      {"Leonhard spectral", [&] { return graph::spectral_order(graph).order; }},
      {"Leonhard nested dissection", [&] { return graph::nested_dissection(graph).order; }},
      {"METIS NodeND", [&] { return metis.dissection(); }}};
  if (graph::vertex_count(graph) <= largest_for_list_sort)
    contenders.push_back({"Boost sloan", [&] { return boost_sloan(lists); }});
  compare(graph, contenders, turns);
}

/// Seconds by size, each method once.
void show_growth(std::size_t largest) {
  fmt::print("\nseconds on triangulations of random points\n{:<26}", "");
  std::vector<std::size_t> sizes;
  for (std::size_t n = 1000; n <= largest; n *= 10) sizes.push_back(n);
  std::vector<CsrGraph> graphs;
  for (const std::size_t n : sizes) {
    graphs.push_back(mesh_graph(n));
    fmt::print("{:>10}", n);
  }
  const auto line = [&](std::string_view name, std::size_t up_to, const auto& work) {
    fmt::print("\n{:<26}", name);
    for (std::size_t i = 0; i < sizes.size() && sizes[i] <= up_to; ++i) {
      fmt::print("{:>10.3f}", seconds_of([&] { work(graphs[i]); }));
      std::fflush(stdout);
    }
  };
  for (const auto& [name, method] : graph::named_order_methods) {
    if (method == graph::OrderMethod::hilbert || method == graph::OrderMethod::natural) continue;
    const std::size_t up_to = method == graph::OrderMethod::rosen ? 1000 : largest;
    line(name, up_to,
         [&](const CsrGraph& graph) { static_cast<void>(graph::order(graph, {.method = method})); });
  }
  line("orientation", largest, [](const CsrGraph& graph) { static_cast<void>(graph::orient_planar(graph)); });
  line("edge colouring", largest,
       [](const CsrGraph& graph) { static_cast<void>(graph::colour_edges(graph)); });
  line("greedy edge colouring", largest,
       [](const CsrGraph& graph) { static_cast<void>(graph::colour_edges_greedily(graph)); });
  line("vertex colouring", largest,
       [](const CsrGraph& graph) { static_cast<void>(graph::colour_vertices(graph)); });
  line("fill by column counts", largest, [](const CsrGraph& graph) {
    static_cast<void>(graph::cholesky_fill(graph, graph::natural_order(graph)));
  });
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const bool files = argc > 1 && std::atol(argv[1]) == 0;
  if (files) {
    for (int i = 1; i < argc; ++i) compare_graph(argv[i], graph::read_graph(argv[i]).graph, 3);
    return 0;
  }
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atol(argv[1]) : 1'000'000);
  const int turns = argc > 2 ? std::atoi(argv[2]) : 3;
  compare_graph("triangulation of random points", mesh_graph(n), turns);
  show_growth(n);
}
