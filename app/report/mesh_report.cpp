// SPDX-License-Identifier: MIT
#include "leonhard/app/report/mesh_report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::app {
namespace {

Json boundary_json(const TriangleMesh& mesh) {
  struct Part {
    std::size_t edges = 0;
    double length = 0;
  };
  std::map<Marker, Part> parts;
  for (const MarkedEdge& edge : mesh.boundary) {
    ++parts[edge.marker].edges;
    parts[edge.marker].length += distance(mesh.points[edge.from], mesh.points[edge.to]);
  }
  Json list = Json::array();
  for (const auto& [marker, part] : parts) {
    const auto name = mesh.marker_names.find(marker);
    list.push_back({{"marker", marker},
                    {"name", name == mesh.marker_names.end() ? std::to_string(marker) : name->second},
                    {"edges", part.edges},
                    {"length", part.length}});
  }
  return list;
}

/// null where nothing is wrong, else the words.
Json words_or_null(const std::optional<std::string>& words) { return words ? Json(*words) : Json(nullptr); }

}  // namespace

Json mesh_report(const TriangleMesh& mesh) {
  const EdgeStructure edges = mesh::build_edges(mesh);
  auto invalid = mesh::validate(mesh);
  if (!invalid) invalid = mesh::validate_embedding(mesh);
  Json report = {{"vertices", mesh.vertex_count()},
                 {"edges", edges.ends.size()},
                 {"triangles", mesh.triangle_count()},
                 {"fingerprint", mesh::fingerprint(mesh).hex()}};
  report["valid"] = !invalid;
  report["invalid"] = words_or_null(invalid);
  report["euler"] = to_json(mesh::euler_account(mesh, edges));
  const auto not_delaunay = invalid ? std::nullopt : mesh::validate_delaunay(mesh);
  report["delaunay"] = !invalid && !not_delaunay;
  report["not_delaunay"] = words_or_null(not_delaunay);
  report.update(to_json(mesh::quality(mesh)));
  report["area"] = mesh::exact_area2(mesh).get_d() / 2;
  report["boundary"] = boundary_json(mesh);
  return report;
}

std::string mesh_report_text(const Json& r) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto count = [&r](const char* key) { return grouped(r[key].get<std::uint64_t>()); };
  line("vertices", count("vertices"));
  line("edges", count("edges"));
  line("triangles", count("triangles"));
  line("valid", r["valid"].get<bool>() ? "yes" : "NO: " + r["invalid"].get<std::string>());
  const Json& euler = r["euler"];
  line("Euler", euler["balances"].get<bool>() ? "balances" : "DOES NOT BALANCE");
  for (const auto& f : euler["formulas"]) {
    line("", fmt::format("{:<72} {:>10} {} {}", f["words"].get<std::string>(), f["left"].get<std::int64_t>(),
                         f["left"] == f["right"] ? "=" : "≠", f["right"].get<std::int64_t>()));
  }
  line("topology", fmt::format("{} component(s), {} hole(s), {} boundary loop(s), {} pinched",
                               euler["components"].get<int>(), euler["holes"].get<int>(),
                               euler["boundary_loops"].get<int>(), euler["pinches"].get<int>()));
  line("Delaunay", r["delaunay"].get<bool>()       ? "yes, constrained edges excepted"
                   : r["not_delaunay"].is_string() ? "no: " + r["not_delaunay"].get<std::string>()
                                                   : "not checked");
  line("angles", fmt::format("{:.3f}° to {:.3f}°, mean smallest {:.1f}°", r["min_angle_deg"].get<double>(),
                             r["max_angle_deg"].get<double>(), r["mean_min_angle_deg"].get<double>()));
  line("aspect ratio", fmt::format("up to {:.2f}", r["max_aspect_ratio"].get<double>()));
  line("size growth", fmt::format("up to {:.2f} between neighbours", r["max_size_growth"].get<double>()));
  line("area", fmt::format("{:.15g}", r["area"].get<double>()));
  for (const auto& part : r["boundary"]) {
    line("boundary", fmt::format("{} (marker {}): {} edges, length {:.6g}", part["name"].get<std::string>(),
                                 part["marker"].get<int>(), grouped(part["edges"].get<std::uint64_t>()),
                                 part["length"].get<double>()));
  }
  line("fingerprint", r["fingerprint"].get<std::string>());
  return text;
}

bool is_sound(const Json& report) {
  return report["valid"].get<bool>() && report["euler"]["balances"].get<bool>();
}

}  // namespace leonhard::app
