// SPDX-License-Identifier: MIT
#include "leonhard/graph/order.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/meshes/renumber_file.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/graph/fill.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/number_text.hpp"

namespace leonhard::app {
namespace {

struct OrderCommand {
  CommonOptions common;
  ReadRequest reading;
  std::string input, method = "reverse-cuthill-mckee", start = "natural", picture;
  bool cells = false;
};

/// One line of the table.
struct Ordered {
  std::string name;
  graph::OrderResult result;
  graph::OrderingCost cost;
  graph::CholeskyFill fill;
  double seconds{};
};

class Orderer {
 public:
  Orderer(const AnyGraph& input, const OrderCommand& command, Console& console, const StopOnSignal& signals)
      : input_(input) {
    options_.coordinates = input.coordinates;
    options_.seed = command.common.seed;
    options_.start = *graph::order_method_named(command.start);
    options_.progress.stop = signals.token();
    options_.progress.report = [&console](std::string_view stage, double fraction) {
      console.transient(fmt::format("{:<18}{:3.0f} %", stage, 100 * fraction));
    };
  }

  Ordered operator()(const graph::NamedOrderMethod& named) {
    options_.method = named.method;
    const auto start = std::chrono::steady_clock::now();
    Ordered ordered;
    ordered.name = named.name;
    ordered.result = graph::order(input_.graph, options_);
    ordered.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ordered.cost = graph::ordering_cost(input_.graph, ordered.result.order);
    ordered.fill = graph::cholesky_fill(input_.graph, ordered.result.order);
    return ordered;
  }

 private:
  const AnyGraph& input_;
  graph::OrderOptions options_;
};

/// Rosen's exchanges take long on large graphs: with `all` they are left out there, which a warning tells.
constexpr std::uint32_t largest_for_rosen = 5000;

std::vector<Ordered> ordered_by(const OrderCommand& command, AnyGraph& input, Orderer& orderer) {
  std::vector<Ordered> table;
  for (const graph::NamedOrderMethod& named : graph::named_order_methods) {
    if (command.method != "all" && command.method != named.name &&
        named.method != graph::OrderMethod::natural)
      continue;
    if (command.method == "all" && named.of_boost) continue;
    if (command.method == "all" && named.method == graph::OrderMethod::hilbert && input.coordinates.empty())
      continue;
    if (command.method == "all" && named.method == graph::OrderMethod::rosen &&
        graph::vertex_count(input.graph) > largest_for_rosen) {
      input.warnings.push_back("rosen is left out: it takes long on so large a graph; ask for it by name");
      continue;
    }
    table.push_back(orderer(named));
  }
  return table;
}

Json table_json(const std::vector<Ordered>& table) {
  Json list = Json::array();
  for (const Ordered& line : table)
    list.push_back({{"method", line.name},
                    {"bandwidth", line.cost.bandwidth},
                    {"envelope", line.cost.envelope},
                    {"rms_wavefront", line.cost.rms_wavefront},
                    {"fill", line.fill.fill},
                    {"nonzeros", line.fill.nonzeros},
                    {"flops", line.fill.flops},
                    {"seconds", line.seconds},
                    {"outcome", to_string(line.result.outcome)}});
  return list;
}

void print_table(const std::vector<Ordered>& table) {
  fmt::print("{:<24}{:>10}{:>16}{:>12}{:>16}{:>11}{:>10}\n", "method", "bandwidth", "envelope", "wavefront",
             "nonzeros of L", "flops", "seconds");
  for (const Ordered& line : table)
    fmt::print("{:<24}{:>10}{:>16}{:>12.1f}{:>16}{:>11.3g}{:>10.3f}\n", line.name,
               grouped(line.cost.bandwidth), grouped(line.cost.envelope), line.cost.rms_wavefront,
               grouped(line.fill.nonzeros), line.fill.flops, line.seconds);
}

void draw_patterns(const OrderCommand& command, const AnyGraph& input, const std::vector<Ordered>& table) {
  const std::vector<std::string> shown_of_all{"natural", "reverse-cuthill-mckee", "spectral",
                                              "nested-dissection"};
  std::vector<Numbering> numberings;
  for (const Ordered& line : table)
    if (command.method != "all" || std::ranges::count(shown_of_all, line.name) > 0)
      numberings.push_back({line.name, line.cost, line.fill.fill, line.result.order});
  draw_matrix(command.picture, input.graph, numberings,
              std::filesystem::path(command.input).filename().string());
}

std::string order_text(const std::vector<std::uint32_t>& order) {
  std::string text;
  for (const std::uint32_t old : order) {
    io::append_number(text, old);
    text += '\n';
  }
  return text;
}

graph::CsrGraph renumbered_graph(const graph::CsrGraph& graph, const std::vector<std::uint32_t>& order) {
  graph::SubgraphExtractor extract(graph);
  return extract(order);
}

std::vector<std::string> output_extensions(const AnyGraph& input) {
  std::vector<std::string> known{".txt", ".graph"};
  if (!input.file) return known;
  const std::vector<std::string> of_meshes = io::any_mesh_output_extensions(*input.file);
  known.insert(known.end(), of_meshes.begin(), of_meshes.end());
  return known;
}

/// What cannot be written is said before any work.
void check_output(const OrderCommand& command, const AnyGraph& input) {
  if (command.common.output.empty()) return;
  if (command.method == "all")
    throw InputError("--method", "all is a comparison, not one order that could be written",
                     "name one method");
  const std::string extension =
      io::known_extension(command.common.output, output_extensions(input), "output");
  if (command.cells && extension != ".txt" && extension != ".graph")
    throw InputError(command.common.output, "a mesh is renumbered by its vertices",
                     "write the cells' order as .txt or their graph as .graph");
}

void write_output(const std::filesystem::path& path, AnyGraph& input,
                  const std::vector<std::uint32_t>& order) {
  const std::string extension = io::known_extension(path, output_extensions(input), "output");
  if (extension == ".txt") return io::write_file_atomically(path, order_text(order));
  if (extension == ".graph") return graph::write_graph(path, renumbered_graph(input.graph, order));
  const AnyMeshFile file = renumbered(*input.file, order);
  if (const std::string lost = io::left_behind(path, file); !lost.empty())
    input.warnings.push_back(extension + " files have no place for these, which were left behind: " + lost);
  io::write_any_mesh(path, file);
}

ExitCode order_file(const OrderCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  if (!command.picture.empty()) io::known_extension(command.picture, {".png", ".svg", ".pdf"}, "picture");
  if (command.cells && is_graph_file(command.input))
    throw InputError(command.input, "is a graph: it has no cells", "leave out --cells, or give a mesh");
  AnyGraph input = read_any_graph(command.input, command.cells ? GraphOf::cells : GraphOf::vertices,
                                  command.reading.options());
  check_output(command, input);
  timer.lap("read");
  Orderer orderer(input, command, console, signals);
  const std::vector<Ordered> table = ordered_by(command, input, orderer);
  timer.lap("order");
  if (!command.common.output.empty()) write_output(command.common.output, input, table.back().result.order);
  if (!command.picture.empty()) draw_patterns(command, input, table);
  timer.lap("write");
  for (const std::string& warning : input.warnings) console.warning(warning);
  if (command.common.json) {
    Json report = graph_report(command.input, input);
    report["orderings"] = table_json(table);
    if (!command.common.output.empty()) report["output"] = command.common.output;
    if (!command.picture.empty()) report["picture"] = command.picture;
    report["warnings"] = input.warnings;
    report["seconds"] = timer.seconds();
    report["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", report.text());
  } else {
    print_table(table);
  }
  const bool stopped = std::ranges::any_of(
      table, [](const Ordered& line) { return line.result.outcome == graph::OrderOutcome::stopped; });
  return stopped ? ExitCode::stopped : ExitCode::done;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const graph::NamedOrderMethod& known : graph::named_order_methods) names.emplace_back(known.name);
  return names;
}

}  // namespace

Command order_command() {
  const auto options = std::make_shared<OrderCommand>();
  const std::vector<std::string> methods = method_names();
  std::vector<std::string> methods_and_all = methods;
  methods_and_all.emplace_back("all");
  Command command{
      .name = "order",
      .help = "Number a mesh's or graph's vertices for a small bandwidth, envelope or fill",
      .options = {{"input", "A mesh of the plane or of space, or a graph (.graph .mtx .edges .csv)",
                   &options->input, true},
                  {.names = "--start",
                   .help = "The order that rosen improves",
                   .target = &options->start,
                   .shows_default = true,
                   .choices = methods},
                  {.names = "--method",
                   .help = "How; all compares them",
                   .target = &options->method,
                   .shows_default = true,
                   .choices = methods_and_all},
                  {"--cells", "Order the cells of a mesh, by its dual graph", &options->cells},
                  {"--picture", "Draw the matrix's pattern as it is and as ordered", &options->picture}},
      .run = [options] { return order_file(*options); }};
  add_read_options(command, options->reading);
  add_common_options(
      command, options->common,
      "Write the renumbered mesh or .graph, or the order as .txt (old numbers in new sequence)");
  return command;
}

}  // namespace leonhard::app
