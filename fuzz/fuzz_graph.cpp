// SPDX-License-Identifier: MIT
// Random graphs through the readers of graph files and through every ordering, orientation, colouring, separator and
// communication schedule: readers return a valid graph or throw InputError, and what the methods promise holds.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "fuzz/fuzz_text.hpp"
#include "leonhard/graph/communication.hpp"
#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/graph/order.hpp"
#include "leonhard/graph/orientation.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/separator/separator.hpp"

namespace {

using namespace leonhard;
using namespace leonhard::graph;

using fuzzing::report;

/// The graph as the METIS file that a test can read.
[[noreturn]] void report(const std::string& broken, const CsrGraph& graph) {
  report(broken, format_metis_graph(graph));
}

// ---- readers ----

void check_file(const GraphFile& file, std::string_view text) {
  if (const auto broken = validate(file.graph))
    report("a reader returned an invalid graph: " + *broken, text);
  if (file.components != components(file.graph).count()) report("the components were miscounted", text);
  if (!file.edge_weights.empty() && file.edge_weights.size() != 2 * edge_count(file.graph))
    report("the edges' weights are too few", text);
  if (file.vertex_weights.size() != std::size_t{file.weights_each} * vertex_count(file.graph))
    report("the vertices' weights are too few", text);
}

void check_round_trip(const GraphFile& file, std::string_view text) {
  const GraphFile again =
      parse_metis_graph(format_metis_graph(file.graph, file.vertex_weights, file.edge_weights), "again");
  if (again.vertex_weights != file.vertex_weights || again.edge_weights != file.edge_weights ||
      edges_of(again.graph) != edges_of(file.graph))
    report("a graph changed on its way through METIS's format", text);
}

void try_metis(const std::string& text) {
  const GraphFile file = parse_metis_graph(text, "fuzz");
  check_file(file, text);
  check_round_trip(file, text);
}
void try_matrix(const std::string& text) { check_file(parse_matrix_market(text, "fuzz"), text); }
void try_edges(const std::string& text) { check_file(parse_edge_list(text, "fuzz"), text); }
void try_coordinates(const std::string& text) {
  if (parse_coordinates(text, "fuzz", 3).points.size() != 3) report("coordinates are missing", text);
}

std::vector<fuzzing::Format> formats() {
  return {{"% comment\n4 3\n2 3\n1 3\n1 2\n\n", try_metis},
          {"3 2 111 2\n9 4 0 2 7\n9 5 1 3 8 1 7\n9 6 2 2 8\n", try_metis},
          {"%%MatrixMarket matrix coordinate real symmetric\n% c\n3 3 4\n1 1 2.0\n2 1 -1e0\n3 2 -1\n3 3 2\n",
           try_matrix},
          {"%%MatrixMarket matrix coordinate pattern general\n3 3 4\n1 2\n2 1\n2 3\n3 2\n", try_matrix},
          {"source,target,weight\n0,1,5\n3,1,6\n# end\n", try_edges},
          {"2\n3\n1 0 0\n2 1 0.5\n3 -1e3 0\n", try_coordinates}};
}

// ---- methods ----

/// Fill by definition: the neighbours of an eliminated vertex that come later become a clique.
std::uint64_t nonzeros_by_elimination(const CsrGraph& graph, const std::vector<std::uint32_t>& order) {
  const std::uint32_t n = vertex_count(graph);
  const std::vector<std::uint32_t> place = invert(order);
  std::vector<std::vector<bool>> entry(n, std::vector<bool>(n, false));
  for (const auto& [a, b] : edges_of(graph)) entry[place[a]][place[b]] = entry[place[b]][place[a]] = true;
  std::uint64_t count = n;
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t i = k + 1; i < n; ++i) {
      if (!entry[k][i]) continue;
      ++count;
      for (std::uint32_t j = k + 1; j < n; ++j)
        if (j != i && entry[k][j]) entry[i][j] = true;
    }
  return count;
}

void check_orders(const CsrGraph& graph, std::uint64_t seed) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    points.push_back({static_cast<double>((v * seed) % 7), static_cast<double>(v % 5), 0});
  for (const auto& [name, method, of_boost] : named_order_methods) {
    (void)of_boost;
    const OrderResult found = order(graph, {.method = method, .coordinates = points, .seed = seed});
    std::vector<std::uint32_t> sorted = found.order;
    std::ranges::sort(sorted);
    if (sorted != natural_order(graph)) report(std::string(name) + " gave no permutation", graph);
    if (cholesky_fill(graph, found.order).nonzeros != nonzeros_by_elimination(graph, found.order))
      report("the fill of " + std::string(name) + " was miscounted", graph);
  }
}

void check_orientation(const CsrGraph& graph) {
  const PlanarOrientation found = orient_planar(graph);
  if (const auto broken = validate(graph, found.orientation))
    report("the orientation is broken: " + *broken, graph);
  const bool three = found.outcome == OrientationOutcome::three_bounded;
  if (three && found.orientation.max_out_degree() > 3) report("more than three edges leave a vertex", graph);
  if (!three && is_planar(graph)) report("a planar graph was called not planar", graph);
}

void check_colourings(const CsrGraph& graph, std::uint64_t seed) {
  std::uint32_t delta = 0;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) delta = std::max(delta, degree(graph, v));
  const EdgeColouring edges = colour_edges(graph, {.rounds = 2, .seed = seed});
  if (const auto broken = validate_edge_colouring(graph, edges))
    report("the edges' colours: " + *broken, graph);
  if (edges.colours > delta + 1) report("more than Delta + 1 colours", graph);
  if (const auto broken = validate_edge_colouring(graph, colour_edges_greedily(graph)))
    report("the edges' greedy colours: " + *broken, graph);
  const Colouring vertices = colour_vertices(graph);
  if (const auto broken = validate_vertex_colouring(graph, vertices))
    report("the vertices' colours: " + *broken, graph);
}

void check_separator(const CsrGraph& graph, std::uint64_t seed) {
  const VertexSeparator found = vertex_separator(graph, {.tries = 1, .seed = seed});
  for (const auto& [a, b] : edges_of(graph))
    if (found.side_of[a] + found.side_of[b] == 1) report("an edge crosses the separator", graph);
}

void check_communication(const CsrGraph& graph, std::uint32_t parts, std::uint64_t seed) {
  Partition partition;
  partition.parts = parts;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    partition.part_of.push_back(static_cast<std::uint32_t>((v * seed + v / 3) % parts));
  const CommunicationGraph found = communication_graph(graph, partition);
  if (const auto broken = validate(found.graph))
    report("the communication graph is broken: " + *broken, graph);
  const CommunicationCost cost = communication_cost(communication_schedule(found, {.rounds = 2}), {1, 1});
  if (cost.values != partition_cost(graph, partition).total_halo)
    report("messages do not add up to halos", graph);
  if (cost.busiest_part_seconds > cost.synchronous_seconds * (1 + 1e-9))
    report("a part is busier than the schedule is long", graph);
}

CsrGraph taken_graph(fuzzing::Input& input) {
  const std::uint32_t n = input.take<std::uint8_t>() % 49U;
  std::vector<std::array<std::uint32_t, 2>> edges;
  while (n > 0 && !input.empty() && edges.size() < 400) {
    const std::uint32_t a = input.take<std::uint8_t>() % n, b = input.take<std::uint8_t>() % n;
    edges.push_back({a, b});
  }
  return graph_from_edges(n, edges).graph;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input input(data, size);
  const auto choice = input.take<std::uint8_t>();
  if (choice % 2 == 0) {
    static const std::vector<fuzzing::Format> all = fuzzing::accepted(formats());
    fuzzing::try_one(all, input);
    return 0;
  }
  const std::uint64_t seed = input.take<std::uint8_t>();
  const CsrGraph graph = taken_graph(input);
  check_orders(graph, seed);
  check_orientation(graph);
  check_colourings(graph, seed);
  check_separator(graph, seed);
  check_communication(graph, 1 + choice / 2 % 9U, seed);
  return 0;
}
