// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition.hpp"

#include <fmt/core.h>

#include <memory>
#include <string>
#include <string_view>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/graphs/partition_output.hpp"
#include "leonhard/app/graphs/partition_request.hpp"
#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/partition_report.hpp"
#include "leonhard/app/report/peak_memory.hpp"

namespace leonhard::app {
namespace {

struct PartitionCommand {
  CommonOptions common;
  PartitionRequest request;
  ReadRequest reading;
  std::string input;
  PartitionOutput output;  ///< its path is common.output
};

ExitCode exit_code_of(graph::PartitionOutcome outcome) {
  if (outcome == graph::PartitionOutcome::done) return ExitCode::done;
  return outcome == graph::PartitionOutcome::stopped ? ExitCode::stopped : ExitCode::goal_not_met;
}

Json report_of(const PartitionCommand& command, const AnyGraph& input, const graph::Partition& partition,
               const graph::PartitionCost& cost) {
  Json report{{"input", command.input},
              {"vertices", graph::vertex_count(input.graph)},
              {"of", vertices_are(input, command.request.graph_of())},
              {"edges", graph::edge_count(input.graph)},
              {"seed", command.common.seed}};
  report.update(partition_report(partition, cost, command.request));
  report["output"] = command.common.output.empty() ? Json() : Json(command.common.output);
  report["warnings"] = input.warnings;
  return report;
}

ExitCode partition_file(const PartitionCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  PartitionOutput output = command.output;
  output.path = command.common.output;
  if (!output.path.empty()) check_partition_output(output, command.input);
  const GraphOf which = command.request.graph_of();
  AnyGraph input = read_any_graph(command.input, which, command.reading.options());
  if (!output.path.empty()) check_partition_output(output, input, which, command.input);
  timer.lap("read");
  Progress progress;
  progress.stop = signals.token();
  progress.report = [&console](std::string_view stage, double fraction) {
    console.transient(fmt::format("{:<21}{:3.0f} %", stage, 100 * fraction));
  };
  const Partitioner part(input, command.input, command.request, command.common.seed, progress);
  const graph::Partition partition = part(command.request.parts);
  timer.lap("partition");
  for (const std::string& warning : input.warnings) console.warning(warning);
  const graph::PartitionCost cost = part.cost_of(partition);
  if (!output.path.empty())
    write_partition(output, input, which, partition,
                    fmt::format("{} parts, {}", partition.parts, command.request.method));
  timer.lap("write");
  if (command.common.json) {
    Json report = report_of(command, input, partition, cost);
    report["seconds"] = timer.seconds();
    report["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", report.text());
  } else {
    const std::string_view of = vertices_are(input, which);
    fmt::print("{}{}", graph_text(graph::vertex_count(input.graph), graph::edge_count(input.graph), of),
               partition_report_text(partition, cost, command.request, of));
  }
  return exit_code_of(partition.outcome);
}

}  // namespace

Command partition_command() {
  const auto options = std::make_shared<PartitionCommand>();
  Command command{
      .name = "partition",
      .help = "Parts of equal size with few edges between them",
      .options = {{"input", "A mesh of the plane or of space, or a graph (.graph .mtx .edges .csv)",
                   &options->input, true}},
      .run = [options] { return partition_file(*options); }};
  add_partition_options(command, options->request);
  add_read_options(command, options->reading);
  command.options.push_back(
      {.names = "--view",
       .help = "Of a picture of the plane: xmin,ymin,xmax,ymax; of space: azimuth,elevation of the viewer",
       .target = &options->output.view,
       .length = OptionLength{2, 4}});
  command.options.push_back({"--cut",
                             "Of a picture of tetrahedra: what is cut away, in the words of leonhard draw",
                             &options->output.cut});
  add_common_options(command, options->common,
                     "One part a line (.txt), the mesh with its parts (.vtu), or a picture (.png .svg .pdf)");
  return command;
}

}  // namespace leonhard::app
