// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/voronoi.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <vector>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/points/read_any_points.hpp"
#include "leonhard/app/report/cells_file.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/delaunay/voronoi_clip.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/diagram.hpp"
#include "leonhard/mesh/io/extension.hpp"

namespace leonhard::app {
namespace {

using delaunay::ClippedVoronoi;
using delaunay::VoronoiDiagram;

struct VoronoiCommand {
  CommonOptions common;
  std::string points, fill = "none", title;
  std::vector<double> box;
  std::array<int, 2> size{1600, 1000};
  bool sites = false;
};

using Window = std::array<Point2, 4>;

Window window_of(const VoronoiCommand& command, std::span<const Point2> points) {
  if (command.box.empty()) return delaunay::window_about(points);
  const auto& b = command.box;
  if (!(b[0] < b[2] && b[1] < b[3]))
    throw InputError("--box", fmt::format("{:g},{:g},{:g},{:g} is no box", b[0], b[1], b[2], b[3]),
                     "give xmin,ymin,xmax,ymax");
  return delaunay::box_window({b[0], b[1]}, {b[2], b[3]});
}

draw::Diagram picture_of(const VoronoiCommand& command, const VoronoiDiagram& diagram,
                         const ClippedVoronoi& cells, const Window& window) {
  const double air = 0.01 * std::max(window[2].x - window[0].x, window[2].y - window[0].y);
  draw::Diagram picture;
  picture.title = command.title;
  picture.axes = true;
  picture.scale_label = "area of the cell";
  picture.region = draw::Box{window[0] + Vec2{-air, -air}, window[2] + Vec2{air, air}};
  // Many cells: thinner lines and smaller dots, so that they keep apart.
  const double fine = std::clamp(40 / std::sqrt(static_cast<double>(diagram.sites.size()) + 1), 0.3, 1.0);
  const bool by_area = command.fill == "area";
  // Over the scale's colours, dark and light, other ones are seen than over white.
  const draw::Colour edge = by_area ? draw::Colour{0.9, 0.9, 0.9} : draw::Colour{0.22, 0.27, 0.36};
  const draw::Colour dot = by_area ? draw::Colour{0.9, 0.25, 0.1} : draw::Colour{0.1, 0.1, 0.1};
  for (const VertexId site : diagram.sites.ids()) {
    const auto corners = cells.cell(site);
    if (corners.empty()) continue;
    const std::vector<Point2> polygon(corners.begin(), corners.end());
    if (by_area) picture.areas.push_back({.corners = polygon, .value = cells.area[site]});
    picture.paths.push_back({polygon, {.colour = edge, .width = fine}, true});
    if (command.sites) picture.dots.push_back({diagram.sites[site], dot, fine});
  }
  picture.paths.push_back({{window.begin(), window.end()}, {.colour = {0.1, 0.1, 0.1}, .width = 2}, true});
  return picture;
}

void write(const VoronoiCommand& command, const std::string& extension, const VoronoiDiagram& diagram,
           const ClippedVoronoi& cells, const Window& window) {
  const std::string& path = command.common.output;
  if (extension == ".vtu") return write_cells_vtu(path, diagram, cells);
  if (extension == ".geojson") return write_cells_geojson(path, diagram, cells);
  if (extension == ".json") return write_cells_json(path, diagram, cells);
  draw::draw_diagram(path, picture_of(command, diagram, cells, window), {command.size[0], command.size[1]});
}

struct VoronoiReport {
  std::size_t points{}, sites{}, duplicates{}, unbounded{}, vertices{}, edges{};
  Point2 low, high;  ///< of the box
  std::size_t cells_in_box{};
  double area_sum{}, box_area{}, largest_area{};
};

VoronoiReport report_of(const VoronoiDiagram& diagram, const ClippedVoronoi& cells, const Window& window) {
  VoronoiReport report;
  report.points = diagram.site_of_input.size();
  report.sites = diagram.sites.size();
  report.duplicates = report.points - report.sites;
  report.vertices = diagram.vertices.size();
  report.edges = diagram.edges.size();
  report.low = window[0];
  report.high = window[2];
  report.box_area = (window[2].x - window[0].x) * (window[2].y - window[0].y);
  for (const double area : cells.area) {
    report.area_sum += area;
    report.largest_area = std::max(report.largest_area, area);
  }
  for (const VertexId site : diagram.sites.ids()) {
    if (!cells.cell(site).empty()) ++report.cells_in_box;
    if (diagram.is_unbounded(site)) ++report.unbounded;
  }
  return report;
}

Json to_json(const VoronoiReport& report) {
  const auto place = [](Point2 p) { return Json::array({p.x, p.y}); };
  return {{"points", report.points},
          {"sites", report.sites},
          {"duplicates", report.duplicates},
          {"unbounded_cells", report.unbounded},
          {"vertices", report.vertices},
          {"edges", report.edges},
          {"box", Json{{"low", place(report.low)}, {"high", place(report.high)}}},
          {"cells_in_box", report.cells_in_box},
          {"area_sum", report.area_sum},
          {"box_area", report.box_area},
          {"largest_area", report.largest_area}};
}

std::string text_of(const VoronoiReport& report) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<17}{}\n", name, value);
  };
  line("points", fmt::format("{}, {} duplicates merged", grouped(report.points), grouped(report.duplicates)));
  line("sites", grouped(report.sites));
  line("unbounded cells", grouped(report.unbounded));
  line("vertices", grouped(report.vertices));
  line("edges", grouped(report.edges));
  line("cells in the box", grouped(report.cells_in_box));
  line("their areas", fmt::format("{:.15g} together, the box has {:.15g}", report.area_sum, report.box_area));
  return text;
}

ExitCode voronoi(const VoronoiCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  static const std::vector<std::string> known{".png", ".svg", ".pdf", ".vtu", ".json", ".geojson"};
  const std::string extension =
      io::known_extension(command.common.output, known, "Voronoi");  // before any work
  const PointsFile file = read_any_points(command.points);
  for (const std::string& warning : file.warnings) console.warning(warning);
  const Window window = window_of(command, file.set.points);
  timer.lap("read");

  delaunay::TriangulateOptions options;
  options.threads = static_cast<unsigned>(command.common.threads);
  options.seed = command.common.seed;
  options.progress.stop = signals.token();
  const auto diagram = delaunay::voronoi_diagram(file.set.points, options);
  if (!diagram) {
    fmt::print(stderr, "leonhard: {}: stopped before the diagram was done\n", command.points);
    return ExitCode::stopped;
  }
  timer.lap("diagram");
  const ClippedVoronoi cells = delaunay::clip(*diagram, window);
  timer.lap("clip");
  write(command, extension, *diagram, cells, window);
  timer.lap("write");

  const VoronoiReport report = report_of(*diagram, cells, window);
  if (command.common.json) {
    Json json = to_json(report);
    json["output"] = command.common.output;
    json["warnings"] = file.warnings;
    json["seconds"] = timer.seconds();
    json["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", json.text());
  } else {
    fmt::print("{}", text_of(report));
  }
  return ExitCode::done;
}

}  // namespace

Command voronoi_command() {
  const auto options = std::make_shared<VoronoiCommand>();
  options->common.output = "voronoi.png";
  Command command{
      .name = "voronoi",
      .help = "The Voronoi diagram of points, its cells clipped to a box, with areas",
      .options = {{"points", "Points (.node .xy .csv .txt .json .geojson)", &options->points, true},
                  {.names = "--box",
                   .help = "xmin,ymin,xmax,ymax; otherwise the points' box and a margin",
                   .target = &options->box,
                   .length = OptionLength{4, 4}},
                  {"--sites", "Picture: show the sites", &options->sites},
                  {.names = "--fill",
                   .help = "Picture: colour of the cells",
                   .target = &options->fill,
                   .shows_default = true,
                   .choices = {"none", "area"}},
                  {.names = "--size",
                   .help = "Picture: width,height in pixels",
                   .target = &options->size,
                   .shows_default = true},
                  {"--title", "Title of the picture", &options->title}},
      .run = [options] { return voronoi(*options); }};
  add_common_options(command, options->common,
                     "A picture (.png .svg .pdf), or the clipped cells with areas (.vtu .json .geojson); "
                     "default voronoi.png");
  return command;
}

}  // namespace leonhard::app
