// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tetrahedralize.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/report/points3_report.hpp"
#include "leonhard/app/report/tet_report.hpp"
#include "leonhard/mesh/draw/tet_picture.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/points3_file.hpp"
#include "leonhard/mesh/io/surface_file.hpp"
#include "leonhard/mesh/io/tet_mesh_file.hpp"

namespace leonhard::app {
namespace {

struct TetrahedralizeCommand {
  CommonOptions common;
  std::string input, algorithm = "insertion";
  std::uint64_t memory_limit = 0;
  bool no_check = false;
};

const std::vector<std::string>& picture_extensions() {
  static const std::vector<std::string> known{".png", ".svg", ".pdf"};
  return known;
}

bool is_one_of(const std::string& extension, const std::vector<std::string>& known) {
  return std::find(known.begin(), known.end(), extension) != known.end();
}

std::string output_extension(const TetrahedralizeCommand& command) {
  std::vector<std::string> known = io::tet_mesh_extensions();
  known.insert(known.end(), picture_extensions().begin(), picture_extensions().end());
  return io::known_extension(command.common.output, known, "tetrahedral mesh or picture");
}

// The one place that will know facets when surfaces are meshed: until then a surface is its vertices.
Points3File read_input(const std::filesystem::path& path) {
  const std::string extension = io::known_extension(path, io::point3_extensions(), "points or surface");
  Points3File file = io::read_points3(path);
  if (is_one_of(extension, io::surface_extensions())) {
    file.warnings.push_back(
        path.string() +
        ": only the vertices of the surface are used; its facets are not yet constraints, so the "
        "mesh fills their convex hull and need not have these facets");
  }
  if (file.set.attributes_each > 0)
    file.warnings.push_back(path.string() + ": the attributes of its points are not carried to the mesh");
  return file;
}

delaunay::TetrahedralizeOptions options_of(const TetrahedralizeCommand& command, Console& console,
                                           const StopOnSignal& signals) {
  delaunay::TetrahedralizeOptions options;
  options.algorithm =
      delaunay::tet_algorithm_named(command.algorithm).value_or(delaunay::TetAlgorithm::insertion);
  options.threads = static_cast<unsigned>(command.common.threads);
  options.seed = command.common.seed;
  options.memory_limit_bytes = command.memory_limit;
  options.progress.stop = signals.token();
  options.progress.report = [&console](std::string_view stage, double fraction) {
    console.transient(fmt::format("{:<11}{:3.0f} %", stage, 100 * fraction));
  };
  return options;
}

std::string bytes_in_words(std::size_t bytes) {
  return bytes < 1'000'000'000 ? fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6)
                               : fmt::format("{:.2f} GB", static_cast<double>(bytes) / 1e9);
}

// Of duplicates the first marker that is not 0 stays.
void carry_markers(const PointSet3& set, delaunay::Tetrahedralization& result) {
  for (std::size_t i = 0; i < set.markers.size(); ++i) {
    if (!result.vertex_of_input[i]) continue;
    Marker& marker = result.mesh.vertex_markers[*result.vertex_of_input[i]];
    if (marker == 0) marker = set.markers[i];
  }
}

void write(const TetrahedralizeCommand& command, const std::string& extension, const TetMesh& mesh) {
  if (is_one_of(extension, picture_extensions())) {
    draw::draw_tet_mesh(command.common.output, mesh);
  } else {
    io::write_tet_mesh(command.common.output, mesh);
  }
}

/// What there is to say, of which the mesh's part is missing where there is no mesh.
struct Answer {
  delaunay::TetrahedralizeOutcome outcome{};
  Points3Account account;
  std::size_t expected_bytes{};
  std::string words;              ///< why there is no mesh
  std::optional<TetReport> mesh;  ///< without the check: vertices and tetrahedra alone
  Fingerprint fingerprint;        ///< of the mesh
  std::size_t hull_faces{};
};

std::string text_of(const TetrahedralizeCommand& command, const Answer& answer) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  line("points",
       grouped(answer.account.points) + ", " + grouped(answer.account.duplicates) + " duplicates merged");
  line("outcome", std::string(to_string(answer.outcome)));
  if (!answer.mesh) return text;
  line("hull faces", grouped(answer.hull_faces));
  if (!command.no_check) return text + text_of(*answer.mesh);
  line("vertices", grouped(answer.mesh->vertices));
  line("tetrahedra", grouped(answer.mesh->tetrahedra));
  line("fingerprint", answer.fingerprint.hex());
  return text;
}

Json json_of(const TetrahedralizeCommand& command, const Answer& answer) {
  Json json{{"input", command.input}, {"algorithm", command.algorithm}, {"outcome", to_string(answer.outcome)}};
  json.update(to_json(answer.account));
  json["expected_memory_bytes"] = answer.expected_bytes;
  json["words"] = answer.words.empty() ? Json() : Json(answer.words);
  if (!answer.mesh) return json;
  json["hull_faces"] = answer.hull_faces;
  if (command.no_check)
    json.update(Json{{"vertices", answer.mesh->vertices},
                     {"tetrahedra", answer.mesh->tetrahedra},
                     {"fingerprint", answer.fingerprint.hex()}});
  else
    json.update(to_json(*answer.mesh));
  json["output"] = command.common.output;
  return json;
}

/// The account of a mesh, or without the check its size.
TetReport report_of(const TetrahedralizeCommand& command, const TetMesh& mesh) {
  if (!command.no_check) return tet_mesh_report(mesh);
  TetReport size;
  size.vertices = mesh.vertex_count();
  size.tetrahedra = mesh.tet_count();
  return size;
}

ExitCode exit_code_of(delaunay::TetrahedralizeOutcome outcome) {
  switch (outcome) {
    case delaunay::TetrahedralizeOutcome::done:
      return ExitCode::done;
    case delaunay::TetrahedralizeOutcome::stopped:
      return ExitCode::stopped;
    default:
      return ExitCode::goal_not_met;
  }
}

ExitCode tetrahedralize(const TetrahedralizeCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  const std::string extension = output_extension(command);  // before any work
  Points3File input = read_input(command.input);
  timer.lap("read");

  const std::vector<Point3>& points = input.set.points;
  Answer answer;
  answer.expected_bytes = delaunay::expected_bytes(points.size());
  if (!command.common.quiet) {
    fmt::print(stderr, "leonhard: {} points, about {} of memory expected\n", grouped(points.size()),
               bytes_in_words(answer.expected_bytes));
  }
  auto result = delaunay::tetrahedralize(points, options_of(command, console, signals));
  timer.lap("tetrahedralize");
  if (signals.token().stop_requested()) result.outcome = delaunay::TetrahedralizeOutcome::stopped;
  input.warnings.insert(input.warnings.end(), result.repairs.begin(), result.repairs.end());
  for (const std::string& warning : input.warnings) console.warning(warning);

  const bool done = result.outcome == delaunay::TetrahedralizeOutcome::done;
  const std::size_t distinct = done ? result.mesh.vertex_count() : count_distinct(points);
  answer.outcome = result.outcome;
  answer.account = points3_account(points, distinct);
  answer.words = why_no_tetrahedra(result.outcome, distinct);
  if (!answer.words.empty()) answer.words = command.input + ": " + answer.words;
  if (done) {
    carry_markers(input.set, result);
    answer.hull_faces = result.mesh.boundary.size();
    answer.mesh = report_of(command, result.mesh);
    if (command.no_check) answer.fingerprint = mesh::fingerprint(result.mesh);
    timer.lap("check");
    write(command, extension, result.mesh);
    timer.lap("write");
  }
  if (command.common.json) {
    Json json = json_of(command, answer);
    json["warnings"] = input.warnings;
    json["seconds"] = timer.seconds();
    json["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", json.text());
  } else {
    fmt::print("{}", text_of(command, answer));
  }
  if (!answer.words.empty()) fmt::print(stderr, "leonhard: {}\n", answer.words);
  return exit_code_of(result.outcome);
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names;
  for (const delaunay::NamedTetAlgorithm& known : delaunay::named_tet_algorithms)
    names.emplace_back(known.name);
  return names;
}

}  // namespace

Command tetrahedralize_command() {
  const auto options = std::make_shared<TetrahedralizeCommand>();
  options->common.output = "mesh.vtu";
  Command command{
      .name = "tetrahedralize",
      .help = "The Delaunay tetrahedralisation of points of space, filling their convex hull",
      .options = {{"points",
                   "Points (.node .xyz .csv .txt), or a surface (.off .obj .stl .ply .mesh .msh .poly "
                   ".smesh), of which "
                   "the vertices are taken",
                   &options->input, true},
                  {.names = "--algorithm",
                   .help = "The way to the tetrahedralisation, which is the same for all",
                   .target = &options->algorithm,
                   .shows_default = true,
                   .choices = algorithm_names()},
                  {.names = "--memory-limit",
                   .help = "Refuse, before any work, points that need more; bytes, or as 4GB; 0: no limit",
                   .target = &options->memory_limit,
                   .shows_default = true,
                   .rule = OptionRule::bytes},
                  {"--no-check",
                   "Leave out Euler's account, validity and quality, which take about as long as the mesh",
                   &options->no_check}},
      .run = [options] { return tetrahedralize(*options); }};
  add_common_options(
      command, options->common,
      "The mesh (.vtu .su2 .msh .mesh .node .ele) or a picture of it, cut open (.png .svg .pdf); default "
      "mesh.vtu");
  return command;
}

}  // namespace leonhard::app
