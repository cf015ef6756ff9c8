// SPDX-License-Identifier: MIT
#include "leonhard/app/report/solve_report.hpp"

#include <fmt/core.h>
#include <gmp.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <nlohmann/detail/abi_macros.hpp>

#include "leonhard/app/report/mesh_json.hpp"

namespace leonhard::app {

namespace {

Json area_json(const AreaAccount& area) {
  return {
      {"mesh", area.mesh}, {"polygon", area.polygon}, {"equal", area.equal}, {"difference", area.difference}};
}

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

std::vector<std::pair<std::string, std::string>> versions() {
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

Json to_json(const SolveReport& report_of) {
  const SolveRun& run = report_of.run;
  const Case& c = run.the_case;
  Json report = {{"title", c.title},
                 {"case", c.file.string()},
                 {"outcome", to_string(run.flow.verdict)},
                 {"words", run.flow.words}};
  const Forces& forces = run.flow.forces;
  report.update(Json{{"cl", forces.cl}, {"cd", forces.cd}, {"cm", forces.cm}});
  const Iteration last = run.flow.history.empty() ? Iteration{} : run.flow.history.back();
  report.update(Json{{"iterations", last.number}, {"residual_drop_orders", last.residual_drop_orders}});
  report["bodies"] = bodies_json(run);
  report["flow"] = Json{{"mach", c.flow.mach}, {"alpha_deg", c.flow.alpha_deg}, {"gamma", c.flow.gamma}};
  report["reference"] =
      Json{{"length", c.reference.length},
           {"moment_centre", Json::array({c.reference.moment_centre.x, c.reference.moment_centre.y})}};
  report["mesh"] = mesh_json(run);
  if (run.refinement) report["refinement"] = to_json(*run.refinement);
  report["euler"] = to_json(run.euler);
  if (run.area) report["area"] = area_json(*run.area);
  report["ordering"] = ordering_json(run);
  report["partition"] = partition_json(run);
  Json seconds = Json::object();
  for (const StageTime& stage : run.stages) seconds[stage.name] = stage.seconds;
  seconds["total"] = run.total_seconds;
  report["seconds"] = seconds;
  report["threads"] = run.threads;
  report["peak_memory_bytes"] = report_of.peak_memory_bytes;
  report["warnings"] = run.warnings;
  Json keys = Json::object();
  for (const KeyInForce& key : c.keys) keys[key.key] = key.value;
  report["case_in_force"] = keys;
  for (const auto& [name, version] : versions()) report["versions"][name] = version;
  report["files"] = report_of.files;
  return report;
}

}  // namespace leonhard::app
