// SPDX-License-Identifier: MIT
#include "leonhard/app/report/points_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "leonhard/app/console.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/mesh/fingerprint.hpp"

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

Json points_account(std::span<const Point2> points) {
  if (points.empty()) return {{"points", 0}, {"duplicates", 0}, {"box", nullptr}};
  const std::size_t distinct = count_distinct(points);
  Point2 low = points.front(), high = low;
  for (const Point2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {{"points", points.size()},
          {"duplicates", points.size() - distinct},
          {"box", {{"low", {low.x, low.y}}, {"high", {high.x, high.y}}}}};
}

Json points_report(std::span<const Point2> points, const delaunay::AlgorithmOptions& options) {
  Json report = points_account(points);
  delaunay::TriangulateOptions triangulate;
  triangulate.threads = options.threads;
  triangulate.seed = options.seed;
  triangulate.progress = options.progress;
  const auto result = delaunay::triangulate(std::vector<Point2>(points.begin(), points.end()), triangulate);
  const bool done = result.outcome == TriangulateOutcome::done;
  report["outcome"] = to_string(result.outcome);
  // One point or two lie on a line as well.
  report["collinear"] = !done && result.outcome != TriangulateOutcome::stopped;
  report["triangles"] = result.mesh.triangle_count();
  report["hull_points"] = done ? Json(result.mesh.boundary.size()) : Json(nullptr);
  report["fingerprint"] = done ? Json(mesh::fingerprint(result.mesh).hex()) : Json(nullptr);
  return report;
}

std::string points_report_text(const Json& r) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto count = [&r](const char* key) { return grouped(r[key].get<std::uint64_t>()); };
  line("points", count("points"));
  line("duplicates", count("duplicates"));
  line("collinear", r["collinear"].get<bool>() ? "yes" : "no");
  const Json& low = r["box"]["low"];
  const Json& high = r["box"]["high"];
  line("box", fmt::format("({}, {}) to ({}, {})", low[0].get<double>(), low[1].get<double>(),
                          high[0].get<double>(), high[1].get<double>()));
  line("triangles", count("triangles"));
  if (r["hull_points"].is_number()) line("hull points", count("hull_points"));
  line("fingerprint", r["fingerprint"].is_string()
                          ? r["fingerprint"].get<std::string>() + " of the Delaunay triangulation"
                          : "none: there is no triangulation");
  return text;
}

}  // namespace leonhard::app
