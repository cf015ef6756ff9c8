// SPDX-License-Identifier: MIT
#include "leonhard/app/report/json.hpp"

#include <fmt/format.h>
#include <gmp.h>
#include <sys/resource.h>
#include <CLI/Version.hpp>
#include <boost/version.hpp>

#include <string_view>

namespace leonhard::app {

Json to_json(const EulerAccount& account) {
  Json formulas = Json::array();
  for (const auto& formula : account.formulas) {
    formulas.push_back(
        {{"name", formula.name}, {"words", formula.words}, {"left", formula.lhs}, {"right", formula.rhs}});
  }
  return {{"balances", account.balances()},
          {"components", account.components},
          {"holes", account.holes},
          {"boundary_loops", account.boundary_loops},
          {"boundary_edges", account.boundary_edges},
          {"pinches", account.pinches},
          {"formulas", formulas}};
}

Json to_json(const MeshQuality& quality) {
  Json worst = Json::array();
  for (const auto& named : quality.worst) {
    worst.push_back({{"triangle", named.triangle.index()},
                     {"centroid", {named.centroid.x, named.centroid.y}},
                     {"min_angle_deg", named.figures.min_angle_deg}});
  }
  return {{"min_angle_deg", quality.min_angle_deg},
          {"max_angle_deg", quality.max_angle_deg},
          {"mean_min_angle_deg", quality.mean_min_angle_deg},
          {"max_aspect_ratio", quality.max_aspect_ratio},
          {"max_size_growth", quality.max_size_growth},
          {"min_area", quality.min_area},
          {"max_area", quality.max_area},
          {"angle_histogram", quality.angle_histogram},
          {"worst", worst}};
}

Json to_json(const AreaAccount& area) {
  return {
      {"mesh", area.mesh}, {"polygon", area.polygon}, {"equal", area.equal}, {"difference", area.difference}};
}

namespace {

Json ordering_json(const SolveRun& run) {
  Json list = Json::array();
  for (const Numbering& numbering : run.numberings) {
    list.push_back({{"method", numbering.name},
                    {"bandwidth", numbering.cost.bandwidth},
                    {"envelope", numbering.cost.envelope},
                    {"rms_wavefront", numbering.cost.rms_wavefront},
                    {"fill", numbering.fill}});
  }
  return list;
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

Json bodies_json(const SolveRun& run) {
  Json bodies = Json::array();
  for (const auto& [marker, forces] : run.flow.forces_by_marker) {
    bodies.push_back({{"name", run.conditions.at(marker).name},
                      {"marker", marker},
                      {"cl", forces.cl},
                      {"cd", forces.cd},
                      {"cm", forces.cm}});
  }
  return bodies;
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace

Json to_json(const delaunay::RefineReport& report) {
  return {{"outcome", to_string(report.outcome)},
          {"inserted", report.inserted},
          {"segment_splits", report.segment_splits},
          {"rounded_splits", report.rounded_splits},
          {"below_angle", report.below_angle},
          {"above_size", report.above_size},
          {"excused_small_input_angle", report.excused_small_input_angle},
          {"excused_min_edge", report.excused_min_edge},
          {"excused_rounding", report.excused_rounding}};
}

Json versions_json() {
  return {{"leonhard", LEONHARD_VERSION},
          {"compiler", compiler()},
          {"petsc", LEONHARD_PETSC_VERSION},
          {"boost",
           fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
          {"gmp", gmp_version},
          {"cli11", CLI11_VERSION},
          {"json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)},
          {"build", LEONHARD_BUILD_TYPE}};
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts kibibytes
}

Json report_json(const SolveRun& run) {
  const Case& c = run.the_case;
  Json report = {{"title", c.title},
                 {"case", c.file.string()},
                 {"outcome", to_string(run.flow.verdict)},
                 {"words", run.flow.words}};
  const Forces& forces = run.flow.forces;
  report.update({{"cl", forces.cl}, {"cd", forces.cd}, {"cm", forces.cm}});
  const Iteration last = run.flow.history.empty() ? Iteration{} : run.flow.history.back();
  report.update({{"iterations", last.number}, {"residual_drop_orders", last.residual_drop_orders}});
  report["bodies"] = bodies_json(run);
  report["flow"] = {{"mach", c.flow.mach}, {"alpha_deg", c.flow.alpha_deg}, {"gamma", c.flow.gamma}};
  report["reference"] = {{"length", c.reference.length},
                         {"moment_centre", {c.reference.moment_centre.x, c.reference.moment_centre.y}}};
  report["mesh"] = mesh_json(run);
  if (run.refinement) report["refinement"] = to_json(*run.refinement);
  report["euler"] = to_json(run.euler);
  if (run.area) report["area"] = to_json(*run.area);
  report["ordering"] = ordering_json(run);
  report["partition"] = partition_json(run);
  Json seconds = Json::object();
  for (const StageTime& stage : run.stages) seconds[stage.name] = stage.seconds;
  seconds["total"] = run.total_seconds;
  report["seconds"] = seconds;
  report["threads"] = run.threads;
  report["peak_memory_bytes"] = peak_memory_bytes();
  report["warnings"] = run.warnings;
  Json keys = Json::object();
  for (const KeyInForce& key : c.keys) keys[key.key] = key.value;
  report["case_in_force"] = keys;
  report["versions"] = versions_json();
  return report;
}

}  // namespace leonhard::app
