// SPDX-License-Identifier: MIT
#include "leonhard/app/report/tet_report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>
#include <optional>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/tet_euler.hpp"
#include "leonhard/mesh/tet_quality.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::app {
namespace {

Json account_json(const TetEulerAccount& account) {
  Json formulas = Json::array();
  for (const auto& formula : account.formulas) {
    formulas.push_back(
        {{"name", formula.name}, {"words", formula.words}, {"left", formula.lhs}, {"right", formula.rhs}});
  }
  return {{"balances", account.balances()},
          {"characteristic", account.characteristic()},
          {"components", account.components},
          {"handles", account.handles},
          {"cavities", account.cavities},
          {"boundary_shells", account.shells},
          {"boundary_faces", account.boundary_faces},
          {"boundary_edges", account.boundary_edges},
          {"pinches", account.vertex_pinches + account.edge_pinches + account.sheet_pinches},
          {"formulas", formulas}};
}

Json quality_json(const TetMeshQuality& quality) {
  Json worst = Json::array();
  for (const auto& named : quality.worst) {
    worst.push_back({{"tetrahedron", named.tet.index()},
                     {"centroid", {named.centroid.x, named.centroid.y, named.centroid.z}},
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

Json boundary_json(const TetMesh& mesh) {
  struct Part {
    std::size_t faces = 0;
    double area = 0;
  };
  std::map<Marker, Part> parts;
  for (const MarkedFace& face : mesh.boundary) {
    const auto corner = [&](std::size_t i) { return mesh.points[face.corners[i]]; };
    ++parts[face.marker].faces;
    parts[face.marker].area += norm(cross(corner(1) - corner(0), corner(2) - corner(0))) / 2;
  }
  Json list = Json::array();
  for (const auto& [marker, part] : parts) {
    const auto name = mesh.marker_names.find(marker);
    list.push_back({{"marker", marker},
                    {"name", name == mesh.marker_names.end() ? std::to_string(marker) : name->second},
                    {"faces", part.faces},
                    {"area", part.area}});
  }
  return list;
}

Json words_or_null(const std::optional<std::string>& words) { return words ? Json(*words) : Json(nullptr); }

}  // namespace

Json tet_mesh_report(const TetMesh& mesh) {
  const auto invalid = mesh::validate(mesh);
  Json report = {{"vertices", mesh.vertex_count()},
                 {"edges", nullptr},
                 {"faces", nullptr},
                 {"tetrahedra", mesh.tet_count()},
                 {"fingerprint", nullptr},
                 {"valid", !invalid},
                 {"invalid", words_or_null(invalid)},
                 {"euler", nullptr},
                 {"delaunay", false},
                 {"not_delaunay", nullptr},
                 {"fills_convex_hull", nullptr}};
  if (invalid) return report;
  const FaceStructure faces = mesh::build_faces(mesh);
  const TetEdges edges = mesh::build_edges(faces, mesh.vertex_count());
  const TetEulerAccount account = mesh::euler_account(mesh, faces, edges);
  report["edges"] = account.edges;
  report["faces"] = account.faces;
  report["fingerprint"] = mesh::fingerprint(mesh).hex();
  report["euler"] = account_json(account);
  const auto not_delaunay = mesh::validate_delaunay(mesh);
  report["delaunay"] = !not_delaunay;
  report["not_delaunay"] = words_or_null(not_delaunay);
  report["fills_convex_hull"] = !mesh::validate_convex(mesh);
  report.update(quality_json(mesh::quality(mesh)));
  const mpq_class volume6 = mesh::exact_volume6(mesh), within6 = mesh::exact_boundary_volume6(mesh);
  report["volume"] = mpq_class(volume6 / 6).get_d();
  report["volume_within_boundary"] = mpq_class(within6 / 6).get_d();
  report["volumes_equal"] = volume6 == within6;  // as rational numbers
  report["boundary"] = boundary_json(mesh);
  return report;
}

std::string tet_mesh_report_text(const Json& r) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto count = [](const Json& value) { return grouped(value.get<std::uint64_t>()); };
  const auto number = [&r](const char* key) { return r[key].get<double>(); };
  line("vertices", count(r["vertices"]));
  if (r["valid"].get<bool>()) line("edges", count(r["edges"]));
  if (r["valid"].get<bool>()) line("faces", count(r["faces"]));
  line("tetrahedra", count(r["tetrahedra"]));
  line("valid", r["valid"].get<bool>() ? "yes" : "NO: " + r["invalid"].get<std::string>());
  if (!r["valid"].get<bool>()) return text;
  const Json& euler = r["euler"];
  line("Euler", euler["balances"].get<bool>() ? "balances" : "DOES NOT BALANCE");
  for (const auto& f : euler["formulas"]) {
    line("", fmt::format("{:<86} {:>10} {} {}", f["words"].get<std::string>(), f["left"].get<std::int64_t>(),
                         f["left"] == f["right"] ? "=" : "≠", f["right"].get<std::int64_t>()));
  }
  line("topology",
       fmt::format("{} component(s), {} handle(s), {} cavities, {} boundary shell(s), {} pinched",
                   euler["components"].get<int>(), euler["handles"].get<int>(), euler["cavities"].get<int>(),
                   euler["boundary_shells"].get<int>(), euler["pinches"].get<int>()));
  line("Delaunay", !r["delaunay"].get<bool>()           ? "no: " + r["not_delaunay"].get<std::string>()
                   : r["fills_convex_hull"].get<bool>() ? "yes, and the whole convex hull is filled"
                                                        : "yes, locally: marked faces inside excepted");
  line("angles",
       fmt::format("{:.3f}° to {:.3f}° between faces, mean smallest {:.1f}°", number("min_dihedral_deg"),
                   number("max_dihedral_deg"), number("mean_min_dihedral_deg")));
  line("aspect ratio", fmt::format("up to {:.4g}", number("max_aspect_ratio")));
  line("edge lengths", fmt::format("{:.6g} to {:.6g}", number("shortest_edge"), number("longest_edge")));
  line("size growth", fmt::format("up to {:.2f} between neighbours", number("max_size_growth")));
  line("volume", fmt::format("{:.15g}; within the boundary {:.15g}: {}", number("volume"),
                             number("volume_within_boundary"),
                             r["volumes_equal"].get<bool>() ? "equal, exactly" : "NOT EQUAL"));
  for (const auto& part : r["boundary"]) {
    line("boundary",
         fmt::format("{} (marker {}): {} faces, area {:.6g}", part["name"].get<std::string>(),
                     part["marker"].get<int>(), count(part["faces"]), part["area"].get<double>()));
  }
  line("fingerprint", r["fingerprint"].get<std::string>());
  return text;
}

bool is_sound_in_space(const Json& report) {
  return report["valid"].get<bool>() && report["euler"]["balances"].get<bool>() &&
         report["volumes_equal"].get<bool>();
}

}  // namespace leonhard::app
