// SPDX-License-Identifier: MIT
#include "leonhard/app/report/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/mesh/draw/draw.hpp"

namespace leonhard::app {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The smallest box about points, grown by a share of its larger side.
class GrowingBox {
 public:
  void add(Point2 p) {
    box_.low = {std::min(box_.low.x, p.x), std::min(box_.low.y, p.y)};
    box_.high = {std::max(box_.high.x, p.x), std::max(box_.high.y, p.y)};
  }
  [[nodiscard]] bool empty() const { return !(box_.low.x <= box_.high.x); }
  [[nodiscard]] draw::Box with_margin(double share) const {
    const double margin = share * std::max(box_.high.x - box_.low.x, box_.high.y - box_.low.y);
    return {box_.low + Vec2{-margin, -margin}, box_.high + Vec2{margin, margin}};
  }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  draw::Box box_{{far, far}, {-far, -far}};
};

/// The case's own close-up; else the walls with a margin, but no more than the mesh; the whole mesh without walls.
draw::View close_up(const SolveRun& run) {
  if (const auto& box = run.the_case.output.close_up)
    return {draw::Box{{(*box)[0], (*box)[1]}, {(*box)[2], (*box)[3]}}};
  GrowingBox walls, mesh;
  for (const SurfaceLine& line : run.flow.surface)
    for (const SurfacePoint& point : line.points) walls.add(point.at);
  if (walls.empty()) return {};
  for (const Point2 p : run.mesh.points) mesh.add(p);
  const draw::Box near = walls.with_margin(0.35), whole = mesh.with_margin(0.02);
  return {draw::Box{{std::max(near.low.x, whole.low.x), std::max(near.low.y, whole.low.y)},
                    {std::min(near.high.x, whole.high.x), std::min(near.high.y, whole.high.y)}}};
}

std::vector<double> mach_numbers(const SolveRun& run) {
  std::vector<double> mach;
  mach.reserve(run.flow.state.size());
  for (const State<2>& state : run.flow.state)
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
        {{cl}, {.title = {}, .x_label = "iteration", .y_label = "CL"}},
        {{cd}, {.title = {}, .x_label = "iteration", .y_label = "CD"}}};
    draw::draw_panels(path("history.png"), panels, "Convergence", 1, {.width = 1600, .height = 1200});
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
        path("partition.png"), run_.mesh, run_.triangle_parts.part_of.flat(), run_.triangle_parts.parts,
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
