// SPDX-License-Identifier: MIT
#include "leonhard/app/report/points3_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/fingerprint.hpp"

namespace leonhard::app {

using delaunay::TetrahedralizeOutcome;

std::string why_no_tetrahedra(TetrahedralizeOutcome outcome, std::size_t distinct_points) {
  switch (outcome) {
    case TetrahedralizeOutcome::done:
      return "";
    case TetrahedralizeOutcome::too_few_points:
      return fmt::format("no tetrahedra: {} distinct {}, a tetrahedron needs four; add points",
                         grouped(distinct_points), distinct_points == 1 ? "point" : "points");
    case TetrahedralizeOutcome::all_collinear:
      return fmt::format(
          "no tetrahedra: all {} distinct points lie exactly on one line; add two points off it",
          grouped(distinct_points));
    case TetrahedralizeOutcome::all_coplanar:
      return fmt::format(
          "no tetrahedra: all {} distinct points lie exactly in one plane; add a point off it, or give two "
          "coordinates to "
          "leonhard triangulate",
          grouped(distinct_points));
    case TetrahedralizeOutcome::stopped:
      return "stopped before the tetrahedralisation was done";
  }
  return "";
}

std::size_t count_distinct(std::span<const Point3> points) {
  std::vector<Point3> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const Point3& a, const Point3& b) { return a < b; });
  return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}

Json points3_account(std::span<const Point3> points, std::size_t distinct) {
  if (points.empty()) return {{"points", 0}, {"duplicates", 0}, {"box", nullptr}};
  Point3 low = points.front(), high = low;
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {{"points", points.size()},
          {"duplicates", points.size() - distinct},
          {"box", {{"low", {low.x, low.y, low.z}}, {"high", {high.x, high.y, high.z}}}}};
}

Json points3_report(std::span<const Point3> points, const delaunay::TetrahedralizeOptions& options) {
  const auto result = delaunay::tetrahedralize(std::vector<Point3>(points.begin(), points.end()), options);
  const bool done = result.outcome == TetrahedralizeOutcome::done;
  Json report = points3_account(points, done ? result.mesh.vertex_count() : count_distinct(points));
  std::set<VertexId> hull;
  for (const MarkedFace& face : result.mesh.boundary) hull.insert(face.corners.begin(), face.corners.end());
  report["outcome"] = to_string(result.outcome);
  report["tetrahedra"] = result.mesh.tet_count();
  report["hull_faces"] = done ? Json(result.mesh.boundary.size()) : Json(nullptr);
  report["hull_points"] = done ? Json(hull.size()) : Json(nullptr);
  report["fingerprint"] = done ? Json(mesh::fingerprint(result.mesh).hex()) : Json(nullptr);
  return report;
}

std::string points3_report_text(const Json& r) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto count = [&r](const char* key) { return grouped(r[key].get<std::uint64_t>()); };
  const auto place = [](const Json& p) {
    return fmt::format("({}, {}, {})", p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
  };
  line("points", count("points"));
  line("duplicates", count("duplicates"));
  line("box", place(r["box"]["low"]) + " to " + place(r["box"]["high"]));
  line("outcome", r["outcome"].get<std::string>());
  line("tetrahedra", count("tetrahedra"));
  if (r["hull_faces"].is_number())
    line("hull", count("hull_faces") + " faces, " + count("hull_points") + " points");
  line("fingerprint", r["fingerprint"].is_string()
                          ? r["fingerprint"].get<std::string>() + " of the Delaunay tetrahedralisation"
                          : "none: there is no tetrahedralisation");
  return text;
}

}  // namespace leonhard::app
