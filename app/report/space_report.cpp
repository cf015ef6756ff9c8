// SPDX-License-Identifier: MIT
#include "leonhard/app/report/space_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "leonhard/app/report/flow_files.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/solve/separation.hpp"
#include "leonhard/app/solve/stage_clock.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

Json mesh_json(const SpaceRun& run) {
  Json json = {{"vertices", run.mesh.vertex_count()}, {"edges", run.edges}, {"cells", run.mesh.cell_count()}};
  for (const CellKind kind : kinds_of_space)
    if (const std::size_t count = run.mesh.count_of(kind); count > 0) json[shape_of(kind).names] = count;
  json["boundary_facets"] = run.mesh.boundary.size();
  if (run.volume)
    json["volume"] = Json{{"cells", run.volume->cells},
                          {"enclosed", run.volume->enclosed},
                          {"equal", run.volume->equal},
                          {"smallest_control", run.volume->smallest_control},
                          {"largest_control", run.volume->largest_control}};
  if (run.quality)
    json["quality"] = Json{{"min_dihedral_deg", run.quality->min_dihedral_deg},
                           {"max_dihedral_deg", run.quality->max_dihedral_deg},
                           {"max_aspect_ratio", run.quality->max_aspect_ratio},
                           {"max_size_growth", run.quality->max_size_growth}};
  return json;
}

Json euler_json(const MixedEulerAccount& euler) {
  Json formulas = Json::array();
  for (const auto& formula : euler.formulas) formulas.push_back(to_json(formula));
  return {{"balances", euler.balances()}, {"components", euler.components}, {"cavities", euler.cavities},
          {"handles", euler.handles},     {"shells", euler.shells},         {"formulas", formulas}};
}

std::string euler_section(const SpaceRun& run) {
  std::string out = "<h2>Euler's account</h2>\n<table>" + head_row({"formula", "left", "right", ""});
  for (const auto& formula : run.euler.formulas)
    out += row({escaped(formula.words), shown(formula.lhs), shown(formula.rhs),
                mark(formula.holds(), "balances", "does not balance")});
  out += fmt::format("</table>\n<p class=lead>{} component(s), {} handle(s), {} cavities. ", shown(run.euler.components),
                     shown(run.euler.handles), shown(run.euler.cavities));
  if (run.volume)
    out += fmt::format("Volume of the cells {:.15g}: {} what the boundary encloses in exact rational arithmetic.",
                       run.volume->cells, mark(run.volume->equal, "equal to", "differs from"));
  return out + "</p>\n";
}

std::string mesh_section(const SpaceRun& run) {
  std::string out = "<div class=two><div><h2>Mesh</h2>\n<table>\n";
  out += row({"vertices", shown(run.mesh.vertex_count())}) + row({"edges", shown(run.edges)});
  for (const CellKind kind : kinds_of_space)
    if (const std::size_t count = run.mesh.count_of(kind); count > 0) out += row({shape_of(kind).names, shown(count)});
  out += row({"boundary facets", shown(run.mesh.boundary.size())});
  if (run.volume)
    out += row({"smallest control volume", fmt::format("{:.4g}", run.volume->smallest_control)}) +
           row({"largest control volume", fmt::format("{:.4g}", run.volume->largest_control)});
  if (run.quality)
    out += row({"smallest dihedral angle", shown(run.quality->min_dihedral_deg, 2) + "°"}) +
           row({"largest dihedral angle", shown(run.quality->max_dihedral_deg, 2) + "°"}) +
           row({"largest aspect ratio", shown(run.quality->max_aspect_ratio, 2)});
  return out + "</table></div>\n<div><h2>Ordering</h2>\n" + numberings_table(run) + "</div></div>\n";
}

/// What the walls feel at a vertex of the mesh.
void write_surface(const SpaceRun& run, const std::filesystem::path& path) {
  std::vector<MixedFacet<3>> facets;
  CellField markers{"marker", 1, {}};
  for (const auto& facet : run.mesh.boundary) {
    if (!is_wall(run.conditions.at(facet.marker).kind)) continue;
    facets.push_back(facet.corners);
    markers.values.push_back(facet.marker);
  }
  if (facets.empty()) return;
  std::vector<PointField> fields;
  for (PointField& field : flow_fields(run.the_case.flow, run.states()))
    if (field.name == "cp" || field.name == "mach") fields.push_back(std::move(field));
  if (!run.flow.stresses.empty()) {
    PerId<VertexId, const solver::WallStress<3>*> of(run.mesh.vertex_count());
    for (const auto& stress : run.flow.stresses) of[stress.at.vertex] = &stress;
    PointField cf{"cf", 3, {}}, heat{"heat", 1, {}}, y_plus{"y_plus", 1, {}};
    for (const VertexId v : run.mesh.points.ids()) {
      const solver::WallStress<3> still{}, &stress = of[run.solver_vertex[v]] ? *of[run.solver_vertex[v]] : still;
      cf.values.insert(cf.values.end(), stress.friction.begin(), stress.friction.end());
      heat.values.push_back(stress.heat), y_plus.values.push_back(stress.y_plus);
    }
    fields.insert(fields.end(), {cf, heat, y_plus});
  }
  io::write_surface_vtu(path, run.mesh.points, facets, fields, {markers});
}

}  // namespace

Json to_json(const SpaceReport& report_of) {
  const SpaceRun& run = report_of.run;
  Json report = flow_json(run);
  if (const auto heights = wall_heights(run.flow))
    report["walls"] = Json{{"y_plus_min", heights->least}, {"y_plus_max", heights->most}};
  report["mesh"] = mesh_json(run);
  report["euler"] = euler_json(run.euler);
  report["ordering"] = ordering_json(run);
  report.update(circumstances_json(run, report_of.peak_memory_bytes, report_of.files));
  return report;
}

std::string report_html(const SpaceReport& report, const std::vector<ReportPicture>& pictures) {
  const SpaceRun& run = report.run;
  const std::string cards =
      card(shown(run.mesh.vertex_count()), "vertices") + card(shown(run.mesh.cell_count()), "cells");
  return whole_page(run,
                    head_section(run, cards) + warnings_section(run) + pictures_section(pictures) + forces_section(run) +
                        euler_section(run) + mesh_section(run) + time_section(run, report.peak_memory_bytes),
                    report.files);
}

Json write_report(SpaceRun& run, const std::filesystem::path& folder) {
  std::vector<ReportPicture> pictures;
  {
    StageClock clock(run, "write");
    io::write_vtu(folder / "field.vtu", run.mesh, flow_fields(run.the_case.flow, run.states()));
    write_surface(run, folder / "surface.vtu");
    write_history<3>(run.flow.history, folder / "history.csv");
    pictures = draw_pictures(run, folder);
  }
  const SpaceReport report{run, peak_memory_bytes(), files_in(folder)};
  Json json = to_json(report);
  io::write_file_atomically(folder / "report.json", json.text() + "\n");
  io::write_file_atomically(folder / "report.html", report_html(report, pictures));
  return json;
}

}  // namespace leonhard::app
