// SPDX-License-Identifier: MIT
#include "leonhard/app/report/points3_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include "leonhard/app/console.hpp"

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

Points3Account points3_account(std::span<const Point3> points, std::size_t distinct) {
  Points3Account account;
  if (points.empty()) return account;
  account.points = points.size();
  account.duplicates = points.size() - distinct;
  account.low = account.high = points.front();
  for (const Point3& p : points) {
    account.low = {std::min(account.low.x, p.x), std::min(account.low.y, p.y), std::min(account.low.z, p.z)};
    account.high = {std::max(account.high.x, p.x), std::max(account.high.y, p.y),
                    std::max(account.high.z, p.z)};
  }
  return account;
}

Json to_json(const Points3Account& account) {
  const auto place = [](const Point3& p) { return Json::array({p.x, p.y, p.z}); };
  Json box;
  if (account.points > 0) box = Json{{"low", place(account.low)}, {"high", place(account.high)}};
  return {{"points", account.points}, {"duplicates", account.duplicates}, {"box", box}};
}

Points3Report points3_report(std::span<const Point3> points, const delaunay::TetrahedralizeOptions& options) {
  const auto result = delaunay::tetrahedralize(std::vector<Point3>(points.begin(), points.end()), options);
  const bool done = result.outcome == TetrahedralizeOutcome::done;
  Points3Report report;
  report.account = points3_account(points, done ? result.mesh.vertex_count() : count_distinct(points));
  report.outcome = result.outcome;
  report.tetrahedra = result.mesh.tet_count();
  if (!done) return report;
  std::set<VertexId> hull;
  for (const MarkedFace& face : result.mesh.boundary) hull.insert(face.corners.begin(), face.corners.end());
  report.hull = {result.mesh.boundary.size(), hull.size(), mesh::fingerprint(result.mesh)};
  return report;
}

Json to_json(const Points3Report& report) {
  Json json = to_json(report.account);
  json["outcome"] = to_string(report.outcome);
  json["tetrahedra"] = report.tetrahedra;
  json["hull_faces"] = nullptr;
  json["hull_points"] = nullptr;
  json["fingerprint"] = nullptr;
  if (report.hull) {
    json["hull_faces"] = report.hull->faces;
    json["hull_points"] = report.hull->points;
    json["fingerprint"] = report.hull->fingerprint.hex();
  }
  return json;
}

std::string text_of(const Points3Report& report) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto place = [](const Point3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); };
  line("points", grouped(report.account.points));
  line("duplicates", grouped(report.account.duplicates));
  line("box", place(report.account.low) + " to " + place(report.account.high));
  line("outcome", std::string(to_string(report.outcome)));
  line("tetrahedra", grouped(report.tetrahedra));
  if (report.hull)
    line("hull", grouped(report.hull->faces) + " faces, " + grouped(report.hull->points) + " points");
  line("fingerprint", report.hull ? report.hull->fingerprint.hex() + " of the Delaunay tetrahedralisation"
                                  : "none: there is no tetrahedralisation");
  return text;
}

}  // namespace leonhard::app
