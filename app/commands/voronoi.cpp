// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/voronoi.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/geometry/geometry_file.hpp"
#include "leonhard/app/geometry/hole_seeds.hpp"
#include "leonhard/app/geometry/outline_checks.hpp"
#include "leonhard/app/points/read_any_points.hpp"
#include "leonhard/app/report/cells_file.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/report/points_report.hpp"
#include "leonhard/delaunay/voronoi_clip.hpp"
#include "leonhard/delaunay/voronoi_pieces.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/diagram.hpp"
#include "leonhard/mesh/io/extension.hpp"

namespace leonhard::app {
namespace {

using delaunay::VoronoiDiagram;
using delaunay::VoronoiPieces;

struct VoronoiCommand {
  CommonOptions common;
  std::string points, fill = "none", title, clip;
  std::vector<double> box;
  std::array<int, 2> size{1600, 1000};
  bool sites = false;
};

/// What the cells are cut to: a box, or a polygon.
struct Window {
  std::vector<Point2> corners;
  Point2 low, high;
  bool is_box = true;
};

Window window_of(std::span<const Point2> corners, bool is_box) {
  const PointsAccount account = points_account(corners);
  return {{corners.begin(), corners.end()}, account.low, account.high, is_box};
}

/// The one closed outline of a geometry.
Window polygon_window(const std::string& path) {
  GeometryFile file = read_any_geometry(path);
  if (file.pslg.segments.empty()) file = as_outline(std::move(file));
  const auto outlines = closed_outlines(file.pslg.segments, file.pslg.points.size());
  if (!outlines || outlines->size() != 1 || !file.pslg.holes.empty())
    throw InputError("--clip", path + " is not one closed outline", "give a polygon without holes");
  std::vector<Point2> corners;
  for (const std::size_t p : outlines->front()) corners.push_back(file.pslg.points[p]);
  return window_of(corners, false);
}

Window window_of(const VoronoiCommand& command, std::span<const Point2> points) {
  if (!command.clip.empty()) return polygon_window(command.clip);
  if (command.box.empty()) return window_of(delaunay::window_about(points), true);
  const auto& b = command.box;
  if (!(b[0] < b[2] && b[1] < b[3]))
    throw InputError("--box", fmt::format("{:g},{:g},{:g},{:g} is no box", b[0], b[1], b[2], b[3]),
                     "give xmin,ymin,xmax,ymax");
  return window_of(delaunay::box_window({b[0], b[1]}, {b[2], b[3]}), true);
}

double area_of(const Window& window) {
  if (window.is_box) return (window.high.x - window.low.x) * (window.high.y - window.low.y);
  return std::abs(rounded_area2(window.corners)) / 2;
}

draw::Diagram picture_of(const VoronoiCommand& command, const VoronoiDiagram& diagram,
                         const VoronoiPieces& pieces, const Window& window) {
  const double air = 0.01 * std::max(window.high.x - window.low.x, window.high.y - window.low.y);
  draw::Diagram picture;
  picture.title = command.title;
  picture.axes = true;
  picture.scale_label = "area of the cell";
  picture.region = draw::Box{window.low + Vec2{-air, -air}, window.high + Vec2{air, air}};
  // Many cells: thinner lines and smaller dots, so that they keep apart.
  const double fine = std::clamp(40 / std::sqrt(static_cast<double>(diagram.sites.size()) + 1), 0.3, 1.0);
  const bool by_area = command.fill == "area";
  // Over the scale's colours, dark and light, other ones are seen than over white.
  const draw::Colour edge = by_area ? draw::Colour{0.9, 0.9, 0.9} : draw::Colour{0.22, 0.27, 0.36};
  const draw::Colour dot = by_area ? draw::Colour{0.9, 0.25, 0.1} : draw::Colour{0.1, 0.1, 0.1};
  std::optional<VertexId> last;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto corners = pieces.piece(i);
    const std::vector<Point2> polygon(corners.begin(), corners.end());
    if (by_area) picture.areas.push_back({.corners = polygon, .value = pieces.area[i]});
    picture.paths.push_back({polygon, {.colour = edge, .width = fine}, true});
    if (command.sites && last != pieces.site[i])
      picture.dots.push_back({diagram.sites[pieces.site[i]], dot, fine});
    last = pieces.site[i];
  }
  picture.paths.push_back({window.corners, {.colour = {0.1, 0.1, 0.1}, .width = 2}, true});
  return picture;
}

void write(const VoronoiCommand& command, const std::string& extension, const VoronoiDiagram& diagram,
           const VoronoiPieces& pieces, const Window& window) {
  const std::string& path = command.common.output;
  if (extension == ".vtu") return write_cells_vtu(path, diagram, pieces);
  if (extension == ".geojson") return write_cells_geojson(path, diagram, pieces);
  if (extension == ".json") return write_cells_json(path, diagram, pieces);
  draw::draw_diagram(path, picture_of(command, diagram, pieces, window), {command.size[0], command.size[1]});
}

struct VoronoiReport {
  std::size_t points{}, sites{}, duplicates{}, unbounded{}, vertices{}, edges{};
  Point2 low, high;  ///< of the window
  bool is_box = true;
  std::size_t pieces{};
  std::size_t cells_in_box{};
  double area_sum{}, box_area{}, largest_area{};
};

VoronoiReport report_of(const VoronoiDiagram& diagram, const VoronoiPieces& pieces, const Window& window) {
  VoronoiReport report;
  report.points = diagram.site_of_input.size();
  report.sites = diagram.sites.size();
  report.duplicates = report.points - report.sites;
  report.vertices = diagram.vertices.size();
  report.edges = diagram.edges.size();
  report.low = window.low;
  report.high = window.high;
  report.is_box = window.is_box;
  report.box_area = area_of(window);
  report.pieces = pieces.size();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    report.area_sum += pieces.area[i];
    report.largest_area = std::max(report.largest_area, pieces.area[i]);
    if (i == 0 || pieces.site[i] != pieces.site[i - 1]) ++report.cells_in_box;
  }
  for (const VertexId site : diagram.sites.ids())
    if (diagram.is_unbounded(site)) ++report.unbounded;
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
          {"pieces", report.pieces},
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
  const char* window = report.is_box ? "the box" : "the polygon";
  line(
      fmt::format("cells in {}", window),
      grouped(report.cells_in_box) +
          (report.pieces > report.cells_in_box ? fmt::format(", in {} pieces", grouped(report.pieces)) : ""));
  line("their areas",
       fmt::format("{:.15g} together, {} has {:.15g}", report.area_sum, window, report.box_area));
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
  const VoronoiPieces pieces = window.is_box ? delaunay::pieces_of(delaunay::clip(*diagram, window.corners))
                                             : delaunay::clip_to_polygon(*diagram, window.corners);
  timer.lap("clip");
  write(command, extension, *diagram, pieces, window);
  timer.lap("write");

  const VoronoiReport report = report_of(*diagram, pieces, window);
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
      .help = "The Voronoi diagram of points, its cells clipped to a box or a polygon, with areas",
      .options = {{"points", "Points (.node .xy .csv .txt .json .geojson)", &options->points, true},
                  {.names = "--box",
                   .help = "xmin,ymin,xmax,ymax; otherwise the points' box and a margin",
                   .target = &options->box,
                   .length = OptionLength{4, 4}},
                  {.names = "--clip",
                   .help = "A polygon, convex or not, in place of the box (.wkt .geojson .poly .xy .csv ...)",
                   .target = &options->clip,
                   .excludes = "--box"},
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
