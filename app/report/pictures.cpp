// SPDX-License-Identifier: MIT
#include "leonhard/app/report/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/album.hpp"
#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/app/report/stream_function.hpp"
#include "leonhard/app/report/vorticity.hpp"
#include "leonhard/mesh/draw/draw.hpp"

namespace leonhard::app {
namespace {

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

/// The pictures of one run.
class PlanePictures {
 public:
  PlanePictures(const SolveRun& run, const std::filesystem::path& folder) : run_(run), album_(folder) {}

  void mach() {
    draw::FieldOptions options{
        .view = close_up(run_), .title = run_.the_case.title + ": Mach number", .value_label = "Mach number"};
    draw::draw_field(path("mach.png"), run_.mesh, mach_numbers(run_), options);
    add("Mach number",
        "Bands and contour lines of the local Mach number about the bodies; " + flow_words(run_) + ".");
  }
  void loss() {
    std::vector<double> values;
    for (const State<2>& state : run_.flow.state)
      values.push_back(1 - solver::total_pressure_ratio({run_.the_case.flow.gamma}, {run_.the_case.flow.mach}, state));
    draw::draw_field(path("total-pressure-loss.png"), run_.mesh, values,
                     {.view = close_up(run_),
                      .title = run_.the_case.title + ": loss of total pressure",
                      .value_label = "1 − p0 / p0 of the free stream",
                      .contour_lines = false});
    add("Loss of total pressure",
        "What shocks, friction and the scheme's own errors take from the total pressure of the free stream.");
  }
  void entropy() {
    std::vector<double> values;
    for (const State<2>& state : run_.flow.state) values.push_back(solver::entropy_ratio({run_.the_case.flow.gamma}, state) - 1);
    draw::draw_field(path("entropy.png"), run_.mesh, values,
                     {.view = close_up(run_),
                      .title = run_.the_case.title + ": entropy",
                      .value_label = "p / ρ^γ over that of the free stream − 1",
                      .contour_lines = false});
    add("Entropy", "Where shocks, friction and heat made entropy; where there are none, what the scheme made.");
  }
  /// White where the density is even, the darker the steeper, as in a schlieren photograph.
  void schlieren() {
    constexpr double darkness = 6;
    std::vector<double> values = density_slopes(run_.mesh, run_.flow.state);
    const double most = nearly_largest(values);
    if (!(most > 0)) return;
    for (double& value : values) value = std::exp(-darkness * std::min(value / most, 2.0));
    draw::draw_field(path("schlieren.png"), run_.mesh, values,
                     {.view = close_up(run_),
                      .title = run_.the_case.title + ": numerical schlieren",
                      .value_label = "even density light, steep dark",
                      .colour_map = draw::ColourMap::grey,
                      .value_range = draw::Range{0, 1},
                      .bands = 100,
                      .contour_lines = false});
    add("Numerical schlieren", "The steeper the density the darker: shocks, expansions, boundary layers and wakes.");
  }
  void streamlines() {
    const VertexId zero = run_.flow.surface.empty() ? VertexId{} : run_.flow.surface.front().points.front().vertex;
    const std::vector<double> psi = stream_function(run_.mesh, run_.edges, run_.flow.state, zero);
    draw::FieldOptions options{.view = close_up(run_),
                               .title = run_.the_case.title + ": streamlines",
                               .value_label = "Mach number",
                               .lines_of = psi,
                               .line_levels = stream_levels(psi)};
    if (options.line_levels.empty()) return;
    draw::draw_field(path("streamlines.png"), run_.mesh, mach_numbers(run_), options);
    const std::string closer = run_.flow.stresses.empty() ? "" : ", and closer ones near the walls' own value";
    add("Streamlines", "Contour lines of the stream function, as much mass between each two of them" + closer +
                           "; colours tell the Mach number.");
  }
  /// The vertices that keep the residual up, where the march did not get it down.
  void worst() {
    if (run_.flow.worst.empty()) return;
    draw::MeshOptions options{.title = run_.the_case.title + ": where the residual hangs"};
    GrowingBox box;
    for (const auto& share : run_.flow.worst) options.marks.push_back(share.at), box.add(share.at);
    const VertexId first = run_.flow.worst.front().vertex;
    for (const auto& ends : run_.edges.ends)  // at least some cells about the first one
      if (ends[0] == first || ends[1] == first)
        for (const VertexId v : ends) box.add(run_.mesh.points[first] + 4.0 * (run_.mesh.points[v] - run_.mesh.points[first]));
    options.view = {box.with_margin(0.2)};
    draw::draw_mesh(path("worst.png"), run_.mesh, options);
    add("Where the residual hangs", "Rings about the up to ten vertices that carry most of what is left of the residual.");
  }
  void vorticity() {
    std::vector<double> values = app::vorticity(run_.mesh, run_.flow.state);
    for (double& value : values) value *= run_.the_case.reference.length / run_.the_case.flow.mach;
    const double most = nearly_largest(values);
    if (!(most > 0)) return;
    draw::draw_field(path("vorticity.png"), run_.mesh, values,
                     {.view = close_up(run_),
                      .title = run_.the_case.title + ": vorticity",
                      .value_label = "vorticity × length / speed of the free stream",
                      .colour_map = draw::ColourMap::diverging,
                      .value_range = draw::Range{-most, most},
                      .contour_lines = false});
    add("Vorticity", "Counter-clockwise red, clockwise blue; the end colours take what is beyond the range, as at walls.");
  }
  void cp() {
    const std::vector<draw::Curve> curves = wall_curves([](const SurfacePoint& point) { return point.cp; });
    if (curves.empty()) return;
    draw::draw_curves(
        path("cp.png"), curves,
        {.title = "Pressure coefficient on the walls", .x_label = "x", .y_label = "Cp", .invert_y = true});
    add("Pressure coefficient", "Cp along each wall, low pressure upwards as is the custom.");
  }
  void friction() {
    if (run_.flow.stresses.empty()) return;
    draw::draw_curves(path("cf.png"), wall_curves([](const SurfacePoint& point) { return point.cf; }),
                      {.title = "Friction coefficient on the walls", .x_label = "x", .y_label = "Cf"});
    add("Friction", "Cf along each wall, positive where it pulls downstream: below 0 the flow runs back.");
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
  void history() { album_.add_history(run_.flow.history); }
  [[nodiscard]] std::vector<ReportPicture> take() { return album_.take(); }

 private:
  /// A curve a wall against x, closed where the wall is.
  std::vector<draw::Curve> wall_curves(double (*value)(const SurfacePoint&)) const {
    std::vector<draw::Curve> curves;
    for (const SurfaceLine& line : run_.flow.surface) {
      draw::Curve curve{.name = run_.conditions.at(line.marker).name, .x = {}, .y = {}};
      for (const SurfacePoint& point : line.points) {
        curve.x.push_back(point.at.x);
        curve.y.push_back(value(point));
      }
      if (line.closed && !curve.x.empty()) {
        curve.x.push_back(curve.x.front());
        curve.y.push_back(curve.y.front());
      }
      curves.push_back(std::move(curve));
    }
    return curves;
  }
  [[nodiscard]] bool in_view(const draw::View& view, Point2 p) const {
    return !view.region || (p.x > view.region->low.x && p.x < view.region->high.x && p.y > view.region->low.y &&
                            p.y < view.region->high.y);
  }
  /// About thirty levels half a step off the walls' value 0; by friction there are finer ones near it, to show what runs back.
  [[nodiscard]] std::vector<double> stream_levels(const std::vector<double>& psi) const {
    const draw::View view = close_up(run_);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const VertexId v : run_.mesh.points.ids())
      if (in_view(view, run_.mesh.points[v])) {
        low = std::min(low, psi[v.index()]);
        high = std::max(high, psi[v.index()]);
      }
    const double step = (high - low) / 30;
    std::vector<double> levels;
    if (!(step > 0)) return levels;
    // The picture shows more than was asked for, above and below or beside it, until it has its shape.
    const double first = std::floor(low / step) - 29.5;
    for (int k = 0; k < 91; ++k) levels.push_back((first + k) * step);
    if (!run_.flow.stresses.empty())
      for (const double part : {0.2, 0.06, 0.015}) levels.insert(levels.end(), {-part * step, part * step});
    std::ranges::sort(levels);
    return levels;
  }
  /// Of all values in view the one that only every fiftieth exceeds, by amount.
  double nearly_largest(const std::vector<double>& values) const {
    const draw::View view = close_up(run_);
    std::vector<double> amounts;
    for (const VertexId v : run_.mesh.points.ids())
      if (in_view(view, run_.mesh.points[v])) amounts.push_back(std::abs(values[v.index()]));
    if (amounts.empty()) return 0;
    const auto at = amounts.begin() + static_cast<std::ptrdiff_t>(amounts.size() - 1 - amounts.size() / 50);
    std::nth_element(amounts.begin(), at, amounts.end());
    return *at;
  }
  std::filesystem::path path(const std::string& name) { return album_.path(name); }
  void add(std::string title, std::string caption) { album_.add(std::move(title), std::move(caption)); }

  const SolveRun& run_;
  Album album_;
};

}  // namespace

std::vector<ReportPicture> draw_pictures(const SolveRun& run, const std::filesystem::path& folder) {
  PlanePictures album(run, folder);
  album.mach();
  album.cp();
  album.friction();
  album.streamlines();
  album.schlieren();
  album.entropy();
  album.loss();
  album.vorticity();
  album.worst();
  album.history();
  album.mesh_close();
  album.mesh_whole();
  album.partition();
  album.angles();
  album.pattern();
  return album.take();
}

}  // namespace leonhard::app
