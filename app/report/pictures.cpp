// SPDX-License-Identifier: MIT
#include "leonhard/app/report/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/mesh/draw/draw.hpp"

namespace leonhard::app {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Box of the walls with a margin, or the case's own close-up; the whole mesh where there is no wall.
draw::View close_up(const SolveRun& run) {
  if (const auto& box = run.the_case.output.close_up)
    return {draw::Box{{(*box)[0], (*box)[1]}, {(*box)[2], (*box)[3]}}};
  std::optional<draw::Box> walls;
  for (const SurfaceLine& line : run.flow.surface) {
    for (const SurfacePoint& point : line.points) {
      if (!walls) walls = draw::Box{point.at, point.at};
      walls->low = {std::min(walls->low.x, point.at.x), std::min(walls->low.y, point.at.y)};
      walls->high = {std::max(walls->high.x, point.at.x), std::max(walls->high.y, point.at.y)};
    }
  }
  if (!walls) return {};
  const double margin = 0.35 * std::max(walls->high.x - walls->low.x, walls->high.y - walls->low.y);
  walls->low = walls->low + Vec2{-margin, -margin};
  walls->high = walls->high + Vec2{margin, margin};
  return {walls};
}

std::vector<double> mach_numbers(const SolveRun& run) {
  std::vector<double> mach;
  mach.reserve(run.flow.state.size());
  for (const State& state : run.flow.state)
    mach.push_back(solver::mach_number({run.the_case.flow.gamma}, state));
  return mach;
}

std::string flow_words(const SolveRun& run) {
  return fmt::format("Mach {:g}, α = {:g}°", run.the_case.flow.mach, run.the_case.flow.alpha_deg);
}

/// Draws into one folder and collects what it drew.
class Album {
 public:
  Album(const SolveRun& run, std::filesystem::path folder) : run_(run), folder_(std::move(folder)) {}

  void mach() {
    draw::FieldOptions options{
        .view = close_up(run_), .title = run_.the_case.title + ": Mach number", .value_label = "Mach number"};
    draw::draw_field(path("mach.png"), run_.mesh, mach_numbers(run_), options);
    add("Mach number",
        "Bands and contour lines of the local Mach number about the bodies; " + flow_words(run_) + ".");
  }
  void cp() {
    std::vector<draw::Curve> curves;
    for (const SurfaceLine& line : run_.flow.surface) {
      draw::Curve curve{.name = run_.conditions.at(line.marker).name, .x = {}, .y = {}};
      for (const SurfacePoint& point : line.points) {
        curve.x.push_back(point.at.x);
        curve.y.push_back(point.cp);
      }
      if (line.closed && !curve.x.empty()) {
        curve.x.push_back(curve.x.front());
        curve.y.push_back(curve.y.front());
      }
      curves.push_back(std::move(curve));
    }
    if (curves.empty()) return;
    draw::draw_curves(
        path("cp.png"), curves,
        {.title = "Pressure coefficient on the walls", .x_label = "x", .y_label = "Cp", .invert_y = true});
    add("Pressure coefficient", "Cp along each wall, low pressure upwards as is the custom.");
  }
  void history() {
    draw::Curve residual{.name = "residual", .x = {}, .y = {}}, cl{.name = "CL", .x = {}, .y = {}},
        cd{.name = "CD", .x = {}, .y = {}};
    for (const Iteration& iteration : run_.flow.history) {
      for (draw::Curve* curve : {&residual, &cl, &cd}) curve->x.push_back(iteration.number);
      residual.y.push_back(std::pow(10.0, -iteration.residual_drop_orders));
      cl.y.push_back(iteration.cl);
      cd.y.push_back(iteration.cd);
    }
    const std::vector<draw::CurvePanel> panels{
        {{residual},
         {.title = {}, .x_label = "iteration", .y_label = "residual / first residual", .log_y = true}},
        {{cl, cd}, {.title = {}, .x_label = "iteration", .y_label = "coefficient"}}};
    draw::draw_panels(path("history.png"), panels, "Convergence");
    add("Convergence", "The residual against its first value, and the coefficients of lift and drag.");
  }
  void mesh_whole() {
    draw::draw_mesh(path("mesh.png"), run_.mesh, {.view = {}, .title = run_.the_case.title + ": mesh"});
    add("Mesh", grouped(run_.mesh.vertex_count()) + " vertices, " + grouped(run_.mesh.triangle_count()) +
                    " triangles, out to the far boundary.");
  }
  void mesh_close() {
    draw::draw_mesh(path("mesh-close-up.png"), run_.mesh,
                    {.view = close_up(run_), .title = run_.the_case.title + ": mesh, close-up"});
    add("Mesh, close-up", "About the bodies.");
  }
  void partition() {
    draw::draw_partition(
        path("partition.png"), run_.mesh, run_.triangle_parts.part_of, run_.triangle_parts.parts,
        {.view = close_up(run_), .title = fmt::format("{} parts", run_.triangle_parts.parts)});
    add("Partition", fmt::format("{} parts, {} edges cut, about the bodies.", run_.triangle_parts.parts,
                                 grouped(run_.partition_cost.cut)));
  }
  void pattern() {
    draw_matrix(path("matrix.png"), *run_.vertex_graph, run_.numberings,
                "Non-zeros of the matrix, one block a vertex");
    add("Matrix pattern", "Where the matrix of the implicit scheme is not zero, before and after ordering.");
  }
  void angles() {
    std::vector<double> edges, counts;
    for (std::size_t i = 0; i <= run_.quality.angle_histogram.size(); ++i)
      edges.push_back(10.0 * static_cast<double>(i));
    for (const auto count : run_.quality.angle_histogram) counts.push_back(static_cast<double>(count));
    draw::draw_histogram(path("angles.png"), edges, counts,
                         {.title = "Angles of the mesh", .x_label = "angle, degrees", .y_label = "corners"});
    add("Angles", fmt::format("All corners, from {:.1f}° to {:.1f}°.", run_.quality.min_angle_deg,
                              run_.quality.max_angle_deg));
  }
  [[nodiscard]] std::vector<ReportPicture> take() { return std::move(pictures_); }

 private:
  std::filesystem::path path(const std::string& name) {
    last_ = name;
    return folder_ / name;
  }
  void add(std::string title, std::string caption) {
    pictures_.push_back({std::move(title), std::move(caption), last_, bytes_of(folder_ / last_)});
  }
  const SolveRun& run_;
  std::filesystem::path folder_;
  std::string last_;
  std::vector<ReportPicture> pictures_;
};

}  // namespace

std::vector<ReportPicture> draw_pictures(const SolveRun& run, const std::filesystem::path& folder) {
  Album album(run, folder);
  album.mach();
  album.cp();
  album.history();
  album.mesh_close();
  album.mesh_whole();
  album.partition();
  album.angles();
  album.pattern();
  return album.take();
}

}  // namespace leonhard::app
