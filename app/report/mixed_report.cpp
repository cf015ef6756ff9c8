// SPDX-License-Identifier: MIT
#include "leonhard/app/report/mixed_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::app {
namespace {

template <int Dim>
std::vector<BoundaryFacets> boundary_facets_by_marker(const MeshDual<Dim>& dual) {
  std::map<Marker, BoundaryFacets> parts;
  for (const DualFacet<Dim>& facet : dual.boundary) {
    BoundaryFacets& part = parts[facet.marker];
    ++part.facets;
    part.size += norm(facet.normal);
  }
  std::vector<BoundaryFacets> list;
  for (auto& [marker, part] : parts) {
    const auto name = dual.marker_names.find(marker);
    part.marker = marker;
    part.name = name == dual.marker_names.end() ? std::to_string(marker) : name->second;
    list.push_back(part);
  }
  return list;
}

Json account_of_mixed(const MixedEulerAccount& account) {
  Json formulas = Json::array();
  for (const auto& formula : account.formulas) formulas.push_back(to_json(formula));
  return {{"balances", account.balances()}, {"components", account.components},
          {"cavities", account.cavities},   {"handles", account.handles},
          {"shells", account.shells},       {"formulas", formulas}};
}

}  // namespace

template <int Dim>
MixedReport mixed_report(const MixedMesh<Dim>& mesh) {
  MixedReport report;
  report.dimension = Dim;
  report.vertices = mesh.vertex_count();
  report.cells = mesh.cell_count();
  for (const CellKind kind : mesh.kinds) ++report.of_kind[static_cast<std::size_t>(kind)];
  report.invalid = mesh::validate(mesh);
  if (report.invalid) return report;
  report.invalid = mesh::validate_embedding(mesh);
  report.fingerprint = mesh::fingerprint(mesh);
  report.euler = mesh::euler_account(mesh);
  const MeshDual<Dim> dual = mesh::build_dual(mesh);
  report.smallest_volume = std::numeric_limits<double>::infinity();
  for (const double volume : dual.volume) {
    report.size += volume;
    report.smallest_volume = std::min(report.smallest_volume, volume);
  }
  report.boundary = boundary_facets_by_marker(dual);
  return report;
}

Json to_json(const MixedReport& report) {
  const bool plane = report.dimension == 2;
  Json json{{"vertices", report.vertices},
            {"edges", report.euler.edges},
            {"cells", report.cells},
            {"fingerprint", report.fingerprint.hex()},
            {"valid", !report.invalid},
            {"invalid", report.invalid},
            {"euler", account_of_mixed(report.euler)},
            {plane ? "area" : "volume", report.size},
            {"min_control_volume", report.smallest_volume}};
  if (!plane) json["faces"] = report.euler.facets;
  for (std::size_t k = 0; k < cell_kind_count; ++k)
    if (shape_of(static_cast<CellKind>(k)).dimension == report.dimension)
      json[shape_of(static_cast<CellKind>(k)).names] = report.of_kind[k];
  Json boundary = Json::array();
  for (const BoundaryFacets& part : report.boundary)
    boundary.push_back({{"marker", part.marker},
                        {"name", part.name},
                        {plane ? "edges" : "faces", part.facets},
                        {plane ? "length" : "area", part.size}});
  json["boundary"] = boundary;
  return json;
}

std::string text_of(const MixedReport& report) {
  const bool plane = report.dimension == 2;
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<15}{}\n", name, value);
  };
  line("vertices", grouped(report.vertices));
  line("edges", grouped(report.euler.edges));
  if (!plane) line("faces", grouped(report.euler.facets));
  for (std::size_t k = 0; k < cell_kind_count; ++k)
    if (report.of_kind[k] > 0) line(shape_of(static_cast<CellKind>(k)).names, grouped(report.of_kind[k]));
  line("valid", report.invalid ? "NO: " + *report.invalid : "yes");
  if (report.euler.formulas.empty()) return text;
  line("Euler", report.euler.balances() ? "balances" : "DOES NOT BALANCE");
  for (const auto& f : report.euler.formulas)
    line("", fmt::format("{:<86} {:>10} {} {}", f.words, f.lhs, f.holds() ? "=" : "≠", f.rhs));
  line("topology", fmt::format("{} component(s), {} {}, {} boundary {}(s)", report.euler.components,
                               report.euler.cavities, plane ? "hole(s)" : "cavities", report.euler.shells,
                               plane ? "loop" : "shell"));
  line(plane ? "area" : "volume", fmt::format("{:.15g}", report.size));
  line("control", fmt::format("volumes of vertices from {:.6g}", report.smallest_volume));
  for (const BoundaryFacets& part : report.boundary)
    line("boundary",
         fmt::format("{} (marker {}): {} {}, {} {:.6g}", part.name, part.marker, grouped(part.facets),
                     plane ? "edges" : "faces", plane ? "length" : "area", part.size));
  line("fingerprint", report.fingerprint.hex());
  return text;
}

template MixedReport mixed_report(const MixedMesh<2>&);
template MixedReport mixed_report(const MixedMesh<3>&);

}  // namespace leonhard::app
