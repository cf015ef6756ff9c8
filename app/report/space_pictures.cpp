// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/app/report/album.hpp"
#include "leonhard/app/report/flow_files.hpp"
#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/app/report/space_report.hpp"
#include "leonhard/mesh/draw/draw.hpp"
#include "leonhard/mesh/plane_section.hpp"

namespace leonhard::app {
namespace {

using Triangles = std::vector<std::array<VertexId, 3>>;

/// A facet as triangles that the flow sees counter-clockwise.
void add_triangles(Triangles& triangles, const MixedFacet<3>& facet) {
  for (std::size_t i = 2; i < facet.size(); ++i) triangles.push_back({facet[0], facet[i], facet[i - 1]});
}

/// The walls by marker, and where they are.
struct Walls {
  std::map<Marker, Triangles> by_marker;
  Triangles all;
  draw::Box3 box;
};

Walls walls_of(const SpaceRun& run) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Walls walls{{}, {}, {{far, far, far}, {-far, -far, -far}}};
  for (const auto& facet : run.mesh.boundary) {
    if (!is_wall(run.conditions.at(facet.marker).kind)) continue;
    add_triangles(walls.by_marker[facet.marker], facet.corners);
    add_triangles(walls.all, facet.corners);
    for (const VertexId v : facet.corners) {
      const Point3 p = run.mesh.points[v];
      auto& [low, high] = walls.box;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return walls;
}

/// The values of a field, one a vertex of the mesh.
const std::vector<double>& values_of(const std::vector<PointField>& fields, const std::string& name) {
  return std::ranges::find(fields, name, &PointField::name)->values;
}

/// The pictures of one run.
class SpacePictures {
 public:
  SpacePictures(const SpaceRun& run, const std::filesystem::path& folder)
      : run_(run), album_(folder), fields_(flow_fields(run.the_case.flow, run.states())), walls_(walls_of(run)) {
    if (walls_.all.empty()) {
      middle_ = 0;
      for (const Point3& p : run.mesh.points) middle_ += p.y / static_cast<double>(run.mesh.vertex_count());
    } else {
      middle_ = walls_.box.low.y / 2 + walls_.box.high.y / 2;
    }
  }

  void surface(draw::View3 view, const std::string& file, const std::string& from) {
    if (walls_.all.empty()) return;
    draw::TetPictureOptions options;
    options.title = run_.the_case.title + ": Cp on the walls";
    options.view = view;
    options.show_edges = false;
    draw::draw_surface_field(album_.path(file), run_.mesh.points, walls_.all, values_of(fields_, "cp"), {.label = "Cp"},
                             options);
    album_.add("Cp on the walls, " + from, "What the flow sees of the walls, coloured by the pressure coefficient.");
  }

  /// Mach number on the plane through the middle of the walls across the span.
  void section() {
    if (!run_.tets) return;
    const PlaneSection cut = mesh::plane_section(*run_.tets, SpaceAxis::y, middle_);
    if (cut.mesh.corners.empty()) return;
    std::vector<double> mach;
    for (const SectionPoint& point : cut.vertices) mach.push_back(point.of(values_of(fields_, "mach")));
    draw::draw_field(album_.path("section.png"), cut.mesh, mach,
                     {.view = view_of(cut.mesh),
                      .title = fmt::format("{}: Mach number at y = {:.4g}", run_.the_case.title, middle_),
                      .y_label = "z",
                      .value_label = "Mach number"});
    album_.add("Mach number on a section", fmt::format("The plane y = {:.4g}, the middle of the walls.", middle_));
  }

  /// Cp where planes across the span cut the walls.
  void cp() {
    std::vector<double> stations = run_.the_case.output.stations;
    if (stations.empty()) stations.push_back(middle_);
    std::vector<draw::Curve> curves;
    for (const double y : stations) add_cp(y, stations.size() > 1, curves);
    if (curves.empty()) return;
    const std::string where = stations.size() > 1 ? "" : fmt::format(" at y = {:.4g}", stations.front());
    draw::draw_curves(album_.path("cp.png"), curves,
                      {.title = "Pressure coefficient on the walls" + where, .x_label = "x", .y_label = "Cp", .invert_y = true});
    album_.add("Pressure coefficient", stations.size() > 1
                                           ? "Cp along the walls on planes across the span, low pressure upwards as is the custom."
                                           : "Cp along the walls on that plane, low pressure upwards as is the custom.");
  }

  void history() { album_.add_history(run_.flow.history); }

  void pattern() {
    draw_matrix(album_.path("matrix.png"), *run_.vertex_graph, run_.numberings, "Non-zeros of the matrix, one block a vertex");
    album_.add("Matrix pattern", "Where the matrix of the implicit scheme is not zero, before and after ordering.");
  }

  [[nodiscard]] std::vector<ReportPicture> take() { return album_.take(); }

 private:
  /// A curve a wall that the plane cuts.
  void add_cp(double y, bool tell_the_plane, std::vector<draw::Curve>& curves) const {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> x_of;
    for (const Point3& p : run_.mesh.points) x_of.push_back(p.x);
    for (const auto& [marker, triangles] : walls_.by_marker) {
      draw::Curve curve{.name = run_.conditions.at(marker).name, .x = {}, .y = {}};
      if (tell_the_plane) curve.name += fmt::format(", y = {:.4g}", y);
      for (const SectionSegment& segment : mesh::plane_section(run_.mesh.points, triangles, SpaceAxis::y, y)) {
        for (const SectionPoint& point : segment) {
          curve.x.push_back(point.of(x_of));
          curve.y.push_back(point.of(values_of(fields_, "cp")));
        }
        curve.x.push_back(gap), curve.y.push_back(gap);
      }
      if (!curve.x.empty()) curves.push_back(std::move(curve));
    }
  }

  /// The walls with a margin, but no more than the section.
  draw::View view_of(const TriangleMesh& section) const {
    if (walls_.all.empty()) return {};
    const auto& [low, high] = walls_.box;
    const double margin = 0.35 * std::max(high.x - low.x, high.z - low.z);
    constexpr double far = std::numeric_limits<double>::infinity();
    draw::Box whole{{far, far}, {-far, -far}};
    for (const Point2 p : section.points) {
      whole.low = {std::min(whole.low.x, p.x), std::min(whole.low.y, p.y)};
      whole.high = {std::max(whole.high.x, p.x), std::max(whole.high.y, p.y)};
    }
    return {draw::Box{{std::max(low.x - margin, whole.low.x), std::max(low.z - margin, whole.low.y)},
                      {std::min(high.x + margin, whole.high.x), std::min(high.z + margin, whole.high.y)}}};
  }

  const SpaceRun& run_;
  Album album_;
  std::vector<PointField> fields_;
  Walls walls_;
  double middle_;  ///< the section's y
};

}  // namespace

std::vector<ReportPicture> draw_pictures(const SpaceRun& run, const std::filesystem::path& folder) {
  SpacePictures album(run, folder);
  album.surface({.azimuth_deg = -140, .elevation_deg = 35}, "surface.png", "from upstream");
  album.section();
  album.cp();
  album.history();
  album.pattern();
  return album.take();
}

}  // namespace leonhard::app
