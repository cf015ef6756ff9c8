// SPDX-License-Identifier: MIT
#include "leonhard/app/report/tet_report.hpp"

#include <fmt/core.h>

#include <iterator>
#include <map>
#include <string_view>

#include "leonhard/app/console.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::app {
namespace {

std::size_t pinches(const TetEulerAccount& account) {
  return account.vertex_pinches + account.edge_pinches + account.sheet_pinches;
}

Json account_json(const TetEulerAccount& account) {
  Json formulas = Json::array();
  for (const auto& formula : account.formulas) formulas.push_back(to_json(formula));
  return {{"balances", account.balances()},
          {"characteristic", account.characteristic()},
          {"components", account.components},
          {"handles", account.handles},
          {"cavities", account.cavities},
          {"boundary_shells", account.shells},
          {"boundary_faces", account.boundary_faces},
          {"boundary_edges", account.boundary_edges},
          {"pinches", pinches(account)},
          {"formulas", formulas}};
}

Json quality_json(const TetMeshQuality& quality) {
  Json worst = Json::array();
  for (const auto& named : quality.worst) {
    worst.push_back({{"tetrahedron", named.tet.index()},
                     {"centroid", Json::array({named.centroid.x, named.centroid.y, named.centroid.z})},
                     {"min_dihedral_deg", named.figures.min_dihedral_deg}});
  }
  return {{"min_dihedral_deg", quality.min_dihedral_deg},
          {"max_dihedral_deg", quality.max_dihedral_deg},
          {"mean_min_dihedral_deg", quality.mean_min_dihedral_deg},
          {"max_aspect_ratio", quality.max_aspect_ratio},
          {"max_radius_edge_ratio", quality.max_radius_edge_ratio},
          {"max_size_growth", quality.max_size_growth},
          {"shortest_edge", quality.shortest_edge},
          {"longest_edge", quality.longest_edge},
          {"min_volume", quality.min_volume},
          {"max_volume", quality.max_volume},
          {"dihedral_histogram", quality.dihedral_histogram},
          {"worst", worst}};
}

std::vector<BoundaryFaces> boundary_faces(const TetMesh& mesh) {
  std::map<Marker, BoundaryFaces> parts;
  for (const MarkedFace& face : mesh.boundary) {
    const auto corner = [&](std::size_t i) { return mesh.points[face.corners[i]]; };
    BoundaryFaces& part = parts[face.marker];
    ++part.faces;
    part.area += norm(cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
  }
  std::vector<BoundaryFaces> list;
  for (auto& [marker, part] : parts) {
    const auto name = mesh.marker_names.find(marker);
    part.marker = marker;
    part.name = name == mesh.marker_names.end() ? std::to_string(marker) : name->second;
    list.push_back(part);
  }
  return list;
}

Json boundary_json(const std::vector<BoundaryFaces>& parts) {
  Json list = Json::array();
  for (const BoundaryFaces& part : parts)
    list.push_back(
        {{"marker", part.marker}, {"name", part.name}, {"faces", part.faces}, {"area", part.area}});
  return list;
}

ValidTetReport valid_report(const TetMesh& mesh) {
  const FaceStructure faces = mesh::build_faces(mesh);
  ValidTetReport report;
  report.euler = mesh::euler_account(mesh, faces, mesh::build_edges(faces, mesh.vertex_count()));
  report.fingerprint = mesh::fingerprint(mesh);
  report.not_delaunay = mesh::validate_delaunay(mesh);
  report.fills_convex_hull = !mesh::validate_convex(mesh);
  report.quality = mesh::quality(mesh);
  const mpq_class volume6 = mesh::exact_volume6(mesh), within6 = mesh::exact_boundary_volume6(mesh);
  report.volume = mpq_class(volume6 / 6).get_d();
  report.volume_within_boundary = mpq_class(within6 / 6).get_d();
  report.volumes_equal = volume6 == within6;
  report.boundary = boundary_faces(mesh);
  return report;
}

}  // namespace

TetReport tet_mesh_report(const TetMesh& mesh) {
  TetReport report;
  report.vertices = mesh.vertex_count();
  report.tetrahedra = mesh.tet_count();
  report.invalid = mesh::validate(mesh);
  if (!report.invalid) report.valid = valid_report(mesh);
  return report;
}

Json to_json(const TetReport& report) {
  Json json{{"vertices", report.vertices},
            {"edges", nullptr},
            {"faces", nullptr},
            {"tetrahedra", report.tetrahedra},
            {"fingerprint", nullptr},
            {"valid", !report.invalid},
            {"invalid", report.invalid},
            {"euler", nullptr},
            {"delaunay", false},
            {"not_delaunay", nullptr},
            {"fills_convex_hull", nullptr}};
  if (!report.valid) return json;
  const ValidTetReport& valid = *report.valid;
  json["edges"] = valid.euler.edges;
  json["faces"] = valid.euler.faces;
  json["fingerprint"] = valid.fingerprint.hex();
  json["euler"] = account_json(valid.euler);
  json["delaunay"] = !valid.not_delaunay;
  json["not_delaunay"] = valid.not_delaunay;
  json["fills_convex_hull"] = valid.fills_convex_hull;
  json.update(quality_json(valid.quality));
  json["volume"] = valid.volume;
  json["volume_within_boundary"] = valid.volume_within_boundary;
  json["volumes_equal"] = valid.volumes_equal;
  json["boundary"] = boundary_json(valid.boundary);
  return json;
}

std::string text_of(const TetReport& report) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  line("vertices", grouped(report.vertices));
  if (report.valid) line("edges", grouped(report.valid->euler.edges));
  if (report.valid) line("faces", grouped(report.valid->euler.faces));
  line("tetrahedra", grouped(report.tetrahedra));
  line("valid", report.invalid ? "NO: " + *report.invalid : "yes");
  if (!report.valid) return text;
  const ValidTetReport& r = *report.valid;
  const TetEulerAccount& euler = r.euler;
  const TetMeshQuality& quality = r.quality;
  line("Euler", euler.balances() ? "balances" : "DOES NOT BALANCE");
  for (const auto& f : euler.formulas)
    line("", fmt::format("{:<86} {:>10} {} {}", f.words, f.lhs, f.holds() ? "=" : "≠", f.rhs));
  line("topology",
       fmt::format("{} component(s), {} handle(s), {} cavities, {} boundary shell(s), {} pinched",
                   euler.components, euler.handles, euler.cavities, euler.shells, pinches(euler)));
  line("Delaunay", r.not_delaunay        ? "no: " + *r.not_delaunay
                   : r.fills_convex_hull ? "yes, and the whole convex hull is filled"
                                         : "yes, locally: marked faces inside excepted");
  line("angles",
       fmt::format("{:.3f}° to {:.3f}° between faces, mean smallest {:.1f}°", quality.min_dihedral_deg,
                   quality.max_dihedral_deg, quality.mean_min_dihedral_deg));
  line("aspect ratio", fmt::format("up to {:.4g}", quality.max_aspect_ratio));
  line("edge lengths", fmt::format("{:.6g} to {:.6g}", quality.shortest_edge, quality.longest_edge));
  line("size growth", fmt::format("up to {:.2f} between neighbours", quality.max_size_growth));
  line("volume", fmt::format("{:.15g}; within the boundary {:.15g}: {}", r.volume, r.volume_within_boundary,
                             r.volumes_equal ? "equal, exactly" : "NOT EQUAL"));
  for (const BoundaryFaces& part : r.boundary)
    line("boundary", fmt::format("{} (marker {}): {} faces, area {:.6g}", part.name, part.marker,
                                 grouped(part.faces), part.area));
  line("fingerprint", r.fingerprint.hex());
  return text;
}

}  // namespace leonhard::app
