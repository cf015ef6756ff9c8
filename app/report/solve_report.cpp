// SPDX-License-Identifier: MIT
#include "leonhard/app/report/solve_report.hpp"

#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/app/solve/separation.hpp"

namespace leonhard::app {

namespace {

Json area_json(const AreaAccount& area) {
  return {
      {"mesh", area.mesh}, {"polygon", area.polygon}, {"equal", area.equal}, {"difference", area.difference}};
}

Json partition_json(const SolveRun& run) {
  const graph::PartitionCost& cost = run.partition_cost;
  return {{"method", to_string(run.the_case.partitioning)},
          {"parts", run.triangle_parts.parts},
          {"cut", cost.cut},
          {"imbalance", cost.imbalance},
          {"smallest", cost.smallest},
          {"largest", cost.largest},
          {"max_components", cost.max_components},
          {"max_neighbours", cost.max_neighbours}};
}

Json mesh_json(const SolveRun& run) {
  Json mesh = {{"vertices", run.mesh.vertex_count()},
               {"edges", run.edges.ends.size()},
               {"triangles", run.mesh.triangle_count()},
               {"fingerprint", run.fingerprint.hex()}};
  mesh.update(to_json(run.quality));
  return mesh;
}

/// Where the flow separates, and how high the first cells are in units of the wall's.
Json walls_json(const SolveRun& run, const WallHeights& heights) {
  Json zeros = Json::array();
  for (const FrictionZero& zero : friction_zeros(run.flow))
    zeros.push_back({{"body", run.conditions.at(zero.marker).name},
                     {"kind", to_string(zero.kind)},
                     {"x", zero.at.x},
                     {"y", zero.at.y},
                     {"s", zero.arc_length}});
  return {{"y_plus_min", heights.least}, {"y_plus_max", heights.most}, {"friction_zeros", zeros}};
}

}  // namespace

Json to_json(const SolveReport& report_of) {
  const SolveRun& run = report_of.run;
  Json report = flow_json(run);
  if (const auto heights = wall_heights(run.flow)) report["walls"] = walls_json(run, *heights);
  report["mesh"] = mesh_json(run);
  if (run.refinement) report["refinement"] = to_json(*run.refinement);
  report["euler"] = to_json(run.euler);
  if (run.area) report["area"] = area_json(*run.area);
  report["ordering"] = ordering_json(run);
  report["partition"] = partition_json(run);
  report.update(circumstances_json(run, report_of.peak_memory_bytes, report_of.files));
  return report;
}

}  // namespace leonhard::app
