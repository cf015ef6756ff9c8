// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/graphs/communication_picture.hpp"
#include "leonhard/app/graphs/loop_colours.hpp"
#include "leonhard/app/graphs/partition_request.hpp"
#include "leonhard/app/graphs/parts_file.hpp"
#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/app/graphs/what_if.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/report/communication_report.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/partition_report.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"

namespace leonhard::app {
namespace {

struct CommunicateCommand {
  CommonOptions common;
  PartitionRequest request;
  StepCost cost;
  ReadRequest reading;
  std::string input, parts_file, picture, vertex_colours, edge_colours;
  std::vector<std::uint32_t> what_if;
};

/// What is asked for, computed.
struct Answer {
  graph::Partition partition;
  graph::PartitionCost partition_cost;
  Communication communication;
  LoopColours loops;
  std::vector<WhatIf> what_if;
};

/// Names of files that could not be written are refused before any work.
void check_names(const CommunicateCommand& command) {
  const auto check = [](const std::string& path, const std::vector<std::string>& known, const char* what) {
    if (!path.empty()) io::known_extension(path, known, what);
  };
  check(command.picture, {".png", ".svg", ".pdf"}, "picture");
  check(command.common.output, {".json"}, "report");
  check(command.vertex_colours, {".txt"}, "colouring");
  check(command.edge_colours, {".txt"}, "colouring");
}

class Communicator {
 public:
  Communicator(const CommunicateCommand& command, Console& console, std::stop_token stop)
      : command_(command), console_(console), stop_(std::move(stop)) {
    colouring_.seed = command.common.seed;
    colouring_.progress = progress();
  }

  [[nodiscard]] Answer operator()(const AnyGraph& input) const {
    const Partitioner part(input, command_.input, command_.request, command_.common.seed, progress());
    Answer answer;
    check_what_if(input, command_.what_if);
    answer.partition = command_.parts_file.empty()
                           ? part(command_.request.parts)
                           : read_parts(command_.parts_file, graph::vertex_count(input.graph));
    answer.partition_cost = part.cost_of(answer.partition);
    answer.communication = communication_of(input.graph, answer.partition, command_.cost.message, colouring_);
    answer.loops = loop_colours(input.graph, colouring_);
    answer.what_if = what_if(input, part, command_.what_if, command_.cost, stop_);
    return answer;
  }

 private:
  [[nodiscard]] Progress progress() const {
    Progress progress;
    progress.stop = stop_;
    progress.report = [&console = console_](std::string_view stage, double fraction) {
      console.transient(fmt::format("{:<21}{:3.0f} %", stage, 100 * fraction));
    };
    return progress;
  }

  const CommunicateCommand& command_;
  Console& console_;
  std::stop_token stop_;
  graph::EdgeColouringOptions colouring_;
};

Json report_of(const CommunicateCommand& command, const AnyGraph& input, const Answer& answer) {
  Json report{{"input", command.input},
              {"vertices", graph::vertex_count(input.graph)},
              {"of", vertices_are(input, command.request.graph_of())},
              {"edges", graph::edge_count(input.graph)},
              {"seed", command.common.seed}};
  report.update(partition_report(answer.partition, answer.partition_cost, command.request));
  if (!command.parts_file.empty()) {
    report["parts_file"] = command.parts_file;
    for (const char* not_asked : {"method", "effort", "imbalance_allowed"}) report.erase(not_asked);
  }
  report["communication"] = to_json(answer.communication);
  report["loops"] = to_json(answer.loops);
  if (!answer.what_if.empty()) report["what_if"] = to_json(answer.what_if);
  report["warnings"] = input.warnings;
  return report;
}

std::string text_of(const CommunicateCommand& command, const AnyGraph& input, const Answer& answer) {
  const graph::PartitionCost& cost = answer.partition_cost;
  const std::string_view of = vertices_are(input, command.request.graph_of());
  std::string text = graph_text(graph::vertex_count(input.graph), graph::edge_count(input.graph), of);
  text +=
      fmt::format("{:<12}{} {}; {} cut edges, imbalance {:.4f}\n", "parts", grouped(answer.partition.parts),
                  command.parts_file.empty()
                      ? fmt::format("by {}: {}", command.request.method, to_string(answer.partition.outcome))
                      : "from " + command.parts_file,
                  grouped(cost.cut), cost.imbalance);
  text += parts_text(cost, answer.communication, of);
  text += communication_text(answer.communication);
  text += loop_colours_text(answer.loops, of);
  if (!answer.what_if.empty()) text += "\n" + what_if_text(answer.what_if);
  return text;
}

void write_files(const CommunicateCommand& command, const AnyGraph& input, const Answer& answer) {
  if (!command.vertex_colours.empty()) write_vertex_colours(command.vertex_colours, answer.loops);
  if (!command.edge_colours.empty()) write_edge_colours(command.edge_colours, input.graph, answer.loops);
  if (!command.picture.empty())
    draw_communication(command.picture, input, command.request.graph_of(), answer.partition,
                       answer.communication, std::filesystem::path(command.input).filename().string());
}

ExitCode exit_code_of(const Answer& answer, bool stopped) {
  if (stopped) return ExitCode::stopped;
  return answer.partition.outcome == graph::PartitionOutcome::done ? ExitCode::done : ExitCode::goal_not_met;
}

ExitCode communicate(const CommunicateCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  check_names(command);
  check_step_cost(command.cost);
  const AnyGraph input = read_any_graph(command.input, command.request.graph_of(), command.reading.options());
  for (const std::string& warning : input.warnings) console.warning(warning);
  timer.lap("read");
  const Answer answer = Communicator(command, console, signals.token())(input);
  timer.lap("compute");
  write_files(command, input, answer);
  timer.lap("write");
  Json report = report_of(command, input, answer);
  report["seconds"] = timer.seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  const std::string json = report.text() + "\n";
  if (!command.common.output.empty()) io::write_file_atomically(command.common.output, json);
  fmt::print("{}", command.common.json ? json : text_of(command, input, answer));
  return exit_code_of(answer, signals.token().stop_requested());
}

}  // namespace

Command communicate_command() {
  const auto options = std::make_shared<CommunicateCommand>();
  Command command{
      .name = "communicate",
      .help = "What the parts of a mesh or graph send one another, in which sequence, and at what cost",
      .options = {{"input", "A mesh of the plane or of space, or a graph (.graph .mtx .edges .csv)",
                   &options->input, true}},
      .run = [options] { return communicate(*options); }};
  add_partition_options(command, options->request);
  add_read_options(command, options->reading);
  const std::vector<Option> own{
      {.names = "--parts-file",
       .help = "The parts, one a line, in place of making them",
       .target = &options->parts_file,
       .excludes = "--parts"},
      {.names = "--alpha",
       .help = "Seconds to begin a message",
       .target = &options->cost.message.alpha,
       .shows_default = true},
      {.names = "--beta",
       .help = "Seconds a value of a message",
       .target = &options->cost.message.beta,
       .shows_default = true},
      {"--what-if", "Numbers of parts to reckon with as well, such as 16,64,1024: a table, nothing is run",
       &options->what_if},
      {"--work", "Seconds to compute at one vertex, for speed-up and efficiency in that table",
       &options->cost.work},
      {"--picture", "Draw the parts and the communication graph, its edges coloured by cycles",
       &options->picture},
      {"--vertex-colours", "Write colours of vertices for threaded loops, one a line (.txt)",
       &options->vertex_colours},
      {"--edge-colours", "Write colours of edges for threaded loops: both ends and the colour a line (.txt)",
       &options->edge_colours}};
  command.options.insert(command.options.end(), own.begin(), own.end());
  add_common_options(command, options->common, "Also write the report as JSON to this file");
  return command;
}

}  // namespace leonhard::app
