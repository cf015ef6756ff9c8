// SPDX-License-Identifier: MIT
#include "leonhard/app/report/mesh_report.hpp"

#include <fmt/core.h>

#include <iterator>
#include <map>
#include <string_view>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::app {
namespace {

std::vector<BoundaryPart> boundary_parts(const TriangleMesh& mesh) {
  std::map<Marker, BoundaryPart> parts;
  for (const MarkedEdge& edge : mesh.boundary) {
    BoundaryPart& part = parts[edge.marker];
    ++part.edges;
    part.length += distance(mesh.points[edge.from], mesh.points[edge.to]);
  }
  std::vector<BoundaryPart> list;
  for (auto& [marker, part] : parts) {
    const auto name = mesh.marker_names.find(marker);
    part.marker = marker;
    part.name = name == mesh.marker_names.end() ? std::to_string(marker) : name->second;
    list.push_back(part);
  }
  return list;
}

Json boundary_json(const std::vector<BoundaryPart>& parts) {
  Json list = Json::array();
  for (const BoundaryPart& part : parts)
    list.push_back(
        {{"marker", part.marker}, {"name", part.name}, {"edges", part.edges}, {"length", part.length}});
  return list;
}

}  // namespace

MeshReport mesh_report(const TriangleMesh& mesh) {
  const EdgeStructure edges = mesh::build_edges(mesh);
  MeshReport report;
  report.vertices = mesh.vertex_count();
  report.edges = edges.ends.size();
  report.triangles = mesh.triangle_count();
  report.fingerprint = mesh::fingerprint(mesh);
  report.invalid = mesh::validate(mesh);
  if (!report.invalid) report.invalid = mesh::validate_embedding(mesh);
  report.euler = mesh::euler_account(mesh, edges);
  if (!report.invalid) report.not_delaunay = mesh::validate_delaunay(mesh);
  report.quality = mesh::quality(mesh);
  report.area = mesh::exact_area2(mesh).get_d() / 2;
  report.boundary = boundary_parts(mesh);
  return report;
}

Json to_json(const MeshReport& report) {
  Json json{{"vertices", report.vertices},        {"edges", report.edges},
            {"triangles", report.triangles},      {"fingerprint", report.fingerprint.hex()},
            {"valid", !report.invalid},           {"invalid", report.invalid},
            {"euler", to_json(report.euler)},     {"delaunay", report.is_delaunay()},
            {"not_delaunay", report.not_delaunay}};
  json.update(to_json(report.quality));
  json["area"] = report.area;
  json["boundary"] = boundary_json(report.boundary);
  return json;
}

std::string text_of(const MeshReport& report) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const EulerAccount& euler = report.euler;
  const MeshQuality& quality = report.quality;
  line("vertices", grouped(report.vertices));
  line("edges", grouped(report.edges));
  line("triangles", grouped(report.triangles));
  line("valid", report.invalid ? "NO: " + *report.invalid : "yes");
  line("Euler", euler.balances() ? "balances" : "DOES NOT BALANCE");
  for (const auto& f : euler.formulas)
    line("", fmt::format("{:<72} {:>10} {} {}", f.words, f.lhs, f.holds() ? "=" : "≠", f.rhs));
  line("topology", fmt::format("{} component(s), {} hole(s), {} boundary loop(s), {} pinched",
                               euler.components, euler.holes, euler.boundary_loops, euler.pinches));
  line("Delaunay", report.is_delaunay()  ? "yes, constrained edges excepted"
                   : report.not_delaunay ? "no: " + *report.not_delaunay
                                         : "not checked");
  line("angles", fmt::format("{:.3f}° to {:.3f}°, mean smallest {:.1f}°", quality.min_angle_deg,
                             quality.max_angle_deg, quality.mean_min_angle_deg));
  line("aspect ratio", fmt::format("up to {:.2f}", quality.max_aspect_ratio));
  line("size growth", fmt::format("up to {:.2f} between neighbours", quality.max_size_growth));
  line("area", fmt::format("{:.15g}", report.area));
  for (const BoundaryPart& part : report.boundary)
    line("boundary", fmt::format("{} (marker {}): {} edges, length {:.6g}", part.name, part.marker,
                                 grouped(part.edges), part.length));
  line("fingerprint", report.fingerprint.hex());
  return text;
}

}  // namespace leonhard::app
