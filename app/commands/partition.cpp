// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#ifdef LEONHARD_HAS_METIS
#include "leonhard/graph/metis.hpp"
#endif
#ifdef LEONHARD_HAS_SCOTCH
#include "leonhard/graph/scotch.hpp"
#endif
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/draw.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

using graph::Effort;
using graph::Partition;
using graph::PartitionMethod;
using graph::PartitionOutcome;

struct PartitionCommand {
  CommonOptions common;
  std::string input, method = "multilevel", effort = "normal", of = "triangles";
  std::uint32_t parts = 8;
  double imbalance = 0.03;
  bool connected = false;
};

constexpr std::array<std::pair<std::string_view, PartitionMethod>, 6> named_methods{{
    {"coordinate", PartitionMethod::coordinate},
    {"inertial", PartitionMethod::inertial},
    {"cuthill-mckee", PartitionMethod::cuthill_mckee},
    {"cuthill-mckee-levels", PartitionMethod::cuthill_mckee_levels},
    {"spectral", PartitionMethod::spectral},
    {"multilevel", PartitionMethod::multilevel},
}};

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const auto& known : named_methods) names.emplace_back(known.first);
#ifdef LEONHARD_HAS_METIS
  names.insert(names.end(), {"metis", "metis-recursive"});
#endif
#ifdef LEONHARD_HAS_SCOTCH
  names.emplace_back("scotch");
#endif
  return names;
}

/// A graph, where it came from, and what else the methods want.
struct Input {
  graph::CsrGraph graph;
  std::optional<TriangleMesh> mesh;
  std::vector<Point3> points;  ///< one a vertex of the graph, or none
  std::vector<std::uint32_t> vertex_weights, edge_weights;
  std::vector<std::string> warnings;
};

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

Input read_graph_input(const std::string& path) {
  graph::GraphFile file = graph::read_graph(path);
  Input input;
  if (file.weights_each > 1)
    throw InputError(path, fmt::format("{} weights a vertex", file.weights_each),
                     "partitions balance one weight a vertex");
  input.vertex_weights = as_weights(file.vertex_weights, path);
  input.edge_weights = as_weights(file.edge_weights, path);
  input.warnings = std::move(file.warnings);
  if (auto beside = graph::read_coordinates_beside(path, graph::vertex_count(file.graph)))
    input.points = std::move(beside->points);
  input.graph = std::move(file.graph);
  return input;
}

Input read_mesh_input(const std::string& path, bool of_triangles) {
  MeshFile file = io::read_mesh(path);
  const TriangleMesh& mesh = file.mesh;
  Input input;
  if (of_triangles) {
    input.graph = graph::dual_graph(mesh);
    for (const auto& corners : mesh.corners) {
      const Point2 a = mesh.points[corners[0]], b = mesh.points[corners[1]], c = mesh.points[corners[2]];
      input.points.push_back({a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3, 0});
    }
  } else {
    input.graph = graph::vertex_graph(mesh, mesh::build_edges(mesh));
    for (const Point2 p : mesh.points) input.points.push_back({p.x, p.y, 0});
  }
  input.warnings = std::move(file.warnings);
  input.mesh = std::move(file.mesh);
  return input;
}

Input read_input(const PartitionCommand& command) {
  std::vector<std::string> known = graph::graph_extensions();
  const std::vector<std::string>& meshes = io::mesh_extensions();
  known.insert(known.end(), meshes.begin(), meshes.end());
  const std::string extension = io::known_extension(command.input, known, "graph or mesh");
  const bool is_mesh = std::ranges::count(meshes, extension) > 0;
  return is_mesh ? read_mesh_input(command.input, command.of == "triangles")
                 : read_graph_input(command.input);
}

Partition partition_by(const PartitionCommand& command, const Input& input,
                       const graph::PartitionOptions& options) {
#ifdef LEONHARD_HAS_METIS
  if (command.method == "metis") return graph::partition_with_metis(input.graph, command.parts, options);
  if (command.method == "metis-recursive")
    return graph::partition_with_metis(input.graph, command.parts, options, graph::MetisScheme::recursive);
#endif
#ifdef LEONHARD_HAS_SCOTCH
  if (command.method == "scotch") return graph::partition_with_scotch(input.graph, command.parts, options);
#endif
  return graph::partition(input.graph, command.parts, options);
}

graph::PartitionOptions options_of(const PartitionCommand& command, const Input& input, Console& console,
                                   const StopOnSignal& signals) {
  graph::PartitionOptions options;
  for (const auto& [name, method] : named_methods)
    if (name == command.method) options.method = method;
  options.effort = command.effort == "low"    ? Effort::low
                   : command.effort == "high" ? Effort::high
                                              : Effort::normal;
  options.imbalance = command.imbalance;
  options.seed = command.common.seed;
  options.connected = command.connected;
  options.vertex_weights = input.vertex_weights;
  options.edge_weights = input.edge_weights;
  options.coordinates = std::span<const Point3>(input.points);
  options.progress.stop = signals.token();
  options.progress.report = [&console](std::string_view stage, double fraction) {
    console.transient(fmt::format("{:<21}{:3.0f} %", stage, 100 * fraction));
  };
  return options;
}

const char* word(PartitionOutcome outcome) {
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

Json report_of(const PartitionCommand& command, const Input& input, const Partition& partition) {
  const graph::PartitionCost cost =
      graph::partition_cost(input.graph, partition, input.vertex_weights, input.edge_weights);
  return {{"input", command.input},
          {"vertices", graph::vertex_count(input.graph)},
          {"edges", graph::edge_count(input.graph)},
          {"method", command.method},
          {"effort", command.effort},
          {"seed", command.common.seed},
          {"parts", command.parts},
          {"outcome", word(partition.outcome)},
          {"cut", cost.cut},
          {"cut_weight", cost.cut_weight},
          {"imbalance", cost.imbalance},
          {"imbalance_allowed", command.imbalance},
          {"smallest", cost.smallest},
          {"largest", cost.largest},
          {"max_components", cost.max_components},
          {"max_neighbours", cost.max_neighbours},
          {"max_halo", cost.max_halo},
          {"total_halo", cost.total_halo},
          {"sizes", cost.sizes},
          {"weights", cost.weights},
          {"components", cost.components},
          {"neighbours", cost.neighbours},
          {"halo", cost.halo}};
}

void print(const Json& report) {
  const auto count = [&](const char* key) { return grouped(report[key].get<std::uint64_t>()); };
  fmt::print("{:<12}{} vertices, {} edges\n", "graph", count("vertices"), count("edges"));
  fmt::print("{:<12}{} by {}: {}\n", "parts", count("parts"), report["method"].get<std::string>(),
             report["outcome"].get<std::string>());
  fmt::print("{:<12}{} edges, weight {}\n", "cut", count("cut"), count("cut_weight"));
  fmt::print("{:<12}{} to {} vertices, imbalance {:.4f} (allowed {:g})\n", "balance", count("smallest"),
             count("largest"), report["imbalance"].get<double>(), report["imbalance_allowed"].get<double>());
  fmt::print("{:<12}{} at most in a part\n", "components", count("max_components"));
  fmt::print("{:<12}{} at most\n", "neighbours", count("max_neighbours"));
  fmt::print("{:<12}{} vertices at most, {} in all\n", "halo", count("max_halo"), count("total_halo"));
}

const std::vector<std::string>& output_extensions() {
  static const std::vector<std::string> known{".txt", ".vtu", ".png", ".svg", ".pdf"};
  return known;
}

/// Before any work: a known extension, and a mesh where a picture or a grid is asked for.
void check_output(const PartitionCommand& command) {
  if (command.common.output.empty()) return;
  const std::string extension = io::known_extension(command.common.output, output_extensions(), "partition");
  const std::string input = std::filesystem::path(command.input).extension().string();
  if (extension != ".txt" && std::ranges::count(graph::graph_extensions(), input) > 0)
    throw InputError(command.common.output, "a graph file has no triangles to draw the parts on",
                     "write .txt, or partition a mesh");
}

void write(const PartitionCommand& command, Input& input, const Partition& partition) {
  const std::filesystem::path path = command.common.output;
  if (path.empty()) return;
  const bool of_triangles = command.of == "triangles";
  if (path.extension() == ".txt") {
    std::string text;
    for (const std::uint32_t part : partition.part_of) text += std::to_string(part) + "\n";
    AtomicFile file(path);
    file.write(text);
    file.commit();
  } else if (path.extension() == ".vtu" && of_triangles) {
    for (const TriangleId t : input.mesh->corners.ids())
      input.mesh->regions[t] = static_cast<double>(partition.part_of[t.index()]);
    io::write_vtu(path, *input.mesh);
  } else if (path.extension() == ".vtu") {
    io::write_vtu(path, *input.mesh, {{"part", 1, {partition.part_of.begin(), partition.part_of.end()}}});
  } else {
    draw::draw_partition(path, *input.mesh, partition.part_of, partition.parts,
                         {.title = fmt::format("{} parts, {}", partition.parts, command.method)});
  }
}

ExitCode exit_code_of(PartitionOutcome outcome) {
  if (outcome == PartitionOutcome::done) return ExitCode::done;
  return outcome == PartitionOutcome::stopped ? ExitCode::stopped : ExitCode::goal_not_met;
}

ExitCode partition_file(const PartitionCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  check_output(command);
  Input input = read_input(command);
  timer.lap("read");
  const Partition partition = partition_by(command, input, options_of(command, input, console, signals));
  timer.lap("partition");
  for (const std::string& warning : input.warnings) console.warning(warning);
  Json report = report_of(command, input, partition);
  write(command, input, partition);
  timer.lap("write");
  report["output"] = command.common.output.empty() ? Json(nullptr) : Json(command.common.output);
  report["warnings"] = input.warnings;
  report["seconds"] = timer.seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  if (command.common.json)
    fmt::print("{}\n", report.dump(2));
  else
    print(report);
  return exit_code_of(partition.outcome);
}

}  // namespace

void add_partition(CLI::App& program, ExitCode& code) {
  auto options = std::make_shared<PartitionCommand>();
  CLI::App* command = program.add_subcommand("partition", "Parts of equal size with few edges between them");
  command
      ->add_option("input", options->input,
                   "A mesh (.su2 .vtu .node .ele .poly) or a graph (.graph .mtx .edges .csv)")
      ->required();
  command->add_option("-k,--parts", options->parts, "How many parts")
      ->check(CLI::Range(1U, std::numeric_limits<std::uint32_t>::max()))
      ->capture_default_str();
  command->add_option("--method", options->method, "How to find them")
      ->check(CLI::IsMember(method_names()))
      ->capture_default_str();
  command->add_option("--effort", options->effort, "How long the multilevel method tries")
      ->check(CLI::IsMember({"low", "normal", "high"}))
      ->capture_default_str();
  command
      ->add_option("--imbalance", options->imbalance,
                   "How much heavier than the mean a part may be: 0.03 is 3 %")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--of", options->of, "What of a mesh is parted")
      ->check(CLI::IsMember({"triangles", "vertices"}))
      ->capture_default_str();
  command->add_flag("--connected", options->connected, "Try to have every part in one piece");
  add_common_flags(*command, options->common,
                   "One part a line (.txt), the mesh with its parts (.vtu), or a picture (.png .svg .pdf)");
  command->callback([options, &code] { code = partition_file(*options); });
}

}  // namespace leonhard::app
