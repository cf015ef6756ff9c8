// SPDX-License-Identifier: MIT
#include "leonhard/app/report/geometry_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/exact_area.hpp"

namespace leonhard::app {
namespace {

std::size_t open_ends_of(const Pslg& pslg) {
  std::vector<std::size_t> segments_at(pslg.points.size(), 0);
  for (const Pslg::Segment& segment : pslg.segments) {
    ++segments_at[segment.from];
    ++segments_at[segment.to];
  }
  return static_cast<std::size_t>(std::ranges::count(segments_at, 1U));
}

std::vector<GeometryReport::Part> parts_of(const Pslg& pslg) {
  std::map<Marker, GeometryReport::Part> parts;
  for (const Pslg::Segment& segment : pslg.segments) {
    GeometryReport::Part& part = parts[segment.marker];
    ++part.segments;
    part.length += distance(pslg.points[segment.from], pslg.points[segment.to]);
  }
  std::vector<GeometryReport::Part> list;
  for (auto& [marker, part] : parts) {
    const auto name = pslg.marker_names.find(marker);
    part.marker = marker;
    part.name = name == pslg.marker_names.end() ? std::to_string(marker) : name->second;
    list.push_back(part);
  }
  return list;
}

}  // namespace

GeometryReport geometry_report(const Pslg& pslg, const delaunay::TriangulateOptions& options) {
  GeometryReport report;
  report.account = points_account(pslg.points);
  report.segments = pslg.segments.size();
  report.holes = pslg.holes.size();
  report.open_ends = open_ends_of(pslg);
  report.parts = parts_of(pslg);
  delaunay::TriangulateOptions work = options;
  work.keep_convex_hull = !report.is_closed();
  work.crossings = delaunay::Crossings::split;
  delaunay::Triangulation result = delaunay::triangulate(pslg, work);
  report.outcome = result.outcome;
  report.triangles = result.mesh.triangle_count();
  report.area = mesh::exact_area2(result.mesh).get_d() / 2;
  report.crossings = result.crossings.size();
  report.repairs = std::move(result.repairs);
  return report;
}

Json to_json(const GeometryReport& report) {
  Json json = to_json(report.account);
  json["segments"] = report.segments;
  json["holes"] = report.holes;
  json["crossings"] = report.crossings;
  json["open_ends"] = report.open_ends;
  json["closed"] = report.is_closed();
  json["outcome"] = to_string(report.outcome);
  json["triangles"] = report.triangles;
  json["area"] = report.area;
  Json boundary = Json::array();
  for (const GeometryReport::Part& part : report.parts)
    boundary.push_back(
        {{"marker", part.marker}, {"name", part.name}, {"segments", part.segments}, {"length", part.length}});
  json["boundary"] = boundary;
  return json;
}

std::string text_of(const GeometryReport& report) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const PointsAccount& account = report.account;
  line("points", grouped(account.points));
  line("duplicates", grouped(account.duplicates));
  line("box",
       fmt::format("({}, {}) to ({}, {})", account.low.x, account.low.y, account.high.x, account.high.y));
  line("segments", grouped(report.segments));
  line("closed", report.is_closed() ? "yes"
                                    : fmt::format("NO: {} points are the end of one segment alone",
                                                  grouped(report.open_ends)));
  line("holes", grouped(report.holes));
  line("crossings", report.crossings == 0 ? "none" : grouped(report.crossings));
  line("triangles", grouped(report.triangles));
  line("area", fmt::format("{:.15g}{}", report.area, report.is_closed() ? "" : " of the convex hull"));
  for (const GeometryReport::Part& part : report.parts)
    line("boundary", fmt::format("{} (marker {}): {} segments, length {:.6g}", part.name, part.marker,
                                 grouped(part.segments), part.length));
  const std::string words = why_no_triangles(report.outcome, account.distinct());
  if (!words.empty()) line("outcome", words);
  return text;
}

}  // namespace leonhard::app
