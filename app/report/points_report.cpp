// SPDX-License-Identifier: MIT
#include "leonhard/app/report/points_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "leonhard/app/console.hpp"
#include "leonhard/delaunay/triangulate.hpp"

namespace leonhard::app {

using delaunay::TriangulateOutcome;

std::string why_no_triangles(TriangulateOutcome outcome, std::size_t distinct_points) {
  switch (outcome) {
    case TriangulateOutcome::done:
      return "";
    case TriangulateOutcome::too_few_points:
      return fmt::format("no triangles: {} distinct {}, a triangle needs three", grouped(distinct_points),
                         distinct_points == 1 ? "point" : "points");
    case TriangulateOutcome::all_collinear:
      return fmt::format("no triangles: all {} distinct points lie exactly on one line; add a point off it",
                         grouped(distinct_points));
    case TriangulateOutcome::stopped:
      return "stopped before the triangulation was done";
  }
  return "";
}

namespace {

std::size_t count_distinct(std::span<const Point2> points) {
  std::vector<Point2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}

}  // namespace

PointsAccount points_account(std::span<const Point2> points) {
  PointsAccount account;
  if (points.empty()) return account;
  account.points = points.size();
  account.duplicates = points.size() - count_distinct(points);
  account.low = account.high = points.front();
  for (const Point2 p : points) {
    account.low = {std::min(account.low.x, p.x), std::min(account.low.y, p.y)};
    account.high = {std::max(account.high.x, p.x), std::max(account.high.y, p.y)};
  }
  return account;
}

Json to_json(const PointsAccount& account) {
  const auto place = [](Point2 p) { return Json::array({p.x, p.y}); };
  Json box;
  if (account.points > 0) box = Json{{"low", place(account.low)}, {"high", place(account.high)}};
  return {{"points", account.points}, {"duplicates", account.duplicates}, {"box", box}};
}

PointsReport points_report(std::span<const Point2> points, const delaunay::AlgorithmOptions& options) {
  delaunay::TriangulateOptions triangulate;
  triangulate.threads = options.threads;
  triangulate.seed = options.seed;
  triangulate.progress = options.progress;
  const auto result = delaunay::triangulate(std::vector<Point2>(points.begin(), points.end()), triangulate);
  PointsReport report;
  report.account = points_account(points);
  report.outcome = result.outcome;
  report.triangles = result.mesh.triangle_count();
  if (result.outcome == TriangulateOutcome::done)
    report.hull = {result.mesh.boundary.size(), mesh::fingerprint(result.mesh)};
  return report;
}

Json to_json(const PointsReport& report) {
  Json json = to_json(report.account);
  json["outcome"] = to_string(report.outcome);
  json["collinear"] = report.is_collinear();
  json["triangles"] = report.triangles;
  json["hull_points"] = nullptr;
  json["fingerprint"] = nullptr;
  if (report.hull) {
    json["hull_points"] = report.hull->points;
    json["fingerprint"] = report.hull->fingerprint.hex();
  }
  return json;
}

std::string text_of(const PointsReport& report) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto place = [](Point2 p) { return fmt::format("({}, {})", p.x, p.y); };
  line("points", grouped(report.account.points));
  line("duplicates", grouped(report.account.duplicates));
  line("collinear", report.is_collinear() ? "yes" : "no");
  line("box", place(report.account.low) + " to " + place(report.account.high));
  line("triangles", grouped(report.triangles));
  if (report.hull) line("hull points", grouped(report.hull->points));
  line("fingerprint", report.hull ? report.hull->fingerprint.hex() + " of the Delaunay triangulation"
                                  : "none: there is no triangulation");
  return text;
}

}  // namespace leonhard::app
