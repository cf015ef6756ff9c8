// SPDX-License-Identifier: MIT
#include "leonhard/app/report/html.hpp"

#include <fmt/core.h>

#include "leonhard/app/solve/separation.hpp"

namespace leonhard::app {
namespace {

/// Where the flow separates and attaches, and the heights of the first cells.
std::string walls_section(const SolveRun& run) {
  const auto heights = wall_heights(run.flow);
  if (!heights) return {};
  std::string out = "<h2>Walls</h2>\n<table>" + head_row({"body", "friction is 0", "x", "y", "along the wall"});
  for (const FrictionZero& zero : friction_zeros(run.flow))
    out += row({escaped(run.conditions.at(zero.marker).name), std::string(to_string(zero.kind)), shown(zero.at.x, 5),
                shown(zero.at.y, 5), shown(zero.arc_length, 5)});
  return out + fmt::format("</table>\n<p class=lead>First cells: y<sup>+</sup> from {:.3g} to {:.3g}.</p>\n",
                           heights->least, heights->most);
}

std::string euler_section(const SolveRun& run) {
  const EulerAccount& euler = run.euler;
  std::string out = "<h2>Euler's account</h2>\n<table>" + head_row({"formula", "left", "right", ""});
  for (const auto& formula : euler.formulas) {
    out += row({escaped(formula.words), shown(formula.lhs), shown(formula.rhs),
                mark(formula.holds(), "balances", "does not balance")});
  }
  out += "</table>\n<p class=lead>";
  out +=
      fmt::format("{} component(s), {} hole(s), {} boundary loop(s) with {} edges. ", shown(euler.components),
                  shown(euler.holes), shown(euler.boundary_loops), shown(euler.boundary_edges));
  if (run.area) {
    out += fmt::format("Area of the mesh {:.15g}: {} the polygon's in exact rational arithmetic.",
                       run.area->mesh, mark(run.area->equal, "equal to", "differs from"));
  }
  return out + "</p>\n";
}

std::string mesh_section(const SolveRun& run) {
  const MeshQuality& quality = run.quality;
  std::string out = "<div class=two><div><h2>Mesh</h2>\n<table>\n";
  out += row({"vertices", shown(run.mesh.vertex_count())}) + row({"edges", shown(run.edges.ends.size())}) +
         row({"triangles", shown(run.mesh.triangle_count())});
  out += row({"smallest angle", shown(quality.min_angle_deg, 2) + "°"}) +
         row({"largest angle", shown(quality.max_angle_deg, 2) + "°"}) +
         row({"largest aspect ratio", shown(quality.max_aspect_ratio, 2)}) +
         row({"largest size growth", shown(quality.max_size_growth, 2)});
  if (run.refinement) {
    out += row({"refinement", escaped(to_string(run.refinement->outcome))}) +
           row({"points inserted", shown(run.refinement->inserted)}) +
           row({"segment splits", shown(run.refinement->segment_splits)});
  }
  out += row({"fingerprint", "<code>" + run.fingerprint.hex() + "</code>"});
  return out + "</table></div>\n";
}

std::string graph_section(const SolveRun& run) {
  std::string out = "<div><h2>Ordering and partition</h2>\n" + numberings_table(run);
  const graph::PartitionCost& cost = run.partition_cost;
  out += "<table>\n" + row({"partition", escaped(to_string(run.the_case.partitioning))}) +
         row({"parts", shown(run.triangle_parts.parts)}) + row({"edges cut", shown(cost.cut)}) +
         row({"imbalance", shown(cost.imbalance, 4)}) +
         row({"triangles in a part", shown(cost.smallest) + " to " + shown(cost.largest)}) +
         row({"most pieces of a part", shown(cost.max_components)}) +
         row({"most neighbours of a part", shown(cost.max_neighbours)});
  return out + "</table></div></div>\n";
}

}  // namespace

std::string report_html(const SolveReport& report, const std::vector<ReportPicture>& pictures) {
  const SolveRun& run = report.run;
  const std::string cards =
      card(shown(run.mesh.vertex_count()), "vertices") + card(shown(run.mesh.triangle_count()), "triangles");
  return whole_page(run,
                    head_section(run, cards) + warnings_section(run) + pictures_section(pictures) + forces_section(run) +
                        walls_section(run) + euler_section(run) + mesh_section(run) + graph_section(run) +
                        time_section(run, report.peak_memory_bytes),
                    report.files);
}

}  // namespace leonhard::app
