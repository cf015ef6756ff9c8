// SPDX-License-Identifier: MIT
#include "leonhard/app/report/flow_json.hpp"

#include <fmt/core.h>
#include <gmp.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <nlohmann/detail/abi_macros.hpp>
#include <vector>

#include "leonhard/solver/axes.hpp"

namespace leonhard::app {
namespace {

template <int dim>
Json forces_json(const Forces& forces, bool viscous) {
  Json json = {{"cl", forces.cl}, {"cd", forces.cd}, {"cm", forces.cm}};
  if (dim == 3) json.update(Json{{"cy", forces.cy}, {"roll", forces.roll}, {"yaw", forces.yaw}});
  if (viscous)
    json.update(Json{{"cl_pressure", forces.cl - forces.cl_friction},
                     {"cl_friction", forces.cl_friction},
                     {"cd_pressure", forces.cd - forces.cd_friction},
                     {"cd_friction", forces.cd_friction}});
  return json;
}

template <int dim>
Json conditions_json(const FlowCase& flow) {
  Json json = {{"mach", flow.mach}, {"alpha_deg", flow.alpha_deg}};
  if (dim == 3) json["beta_deg"] = flow.beta_deg;
  json["gamma"] = flow.gamma;
  if (flow.reynolds) json.update(Json{{"reynolds", *flow.reynolds}, {"prandtl", flow.prandtl}});
  return json;
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace

template <int dim>
Json flow_json(const FlowRun<dim>& run) {
  const Case& c = run.the_case;
  const bool viscous = c.flow.reynolds.has_value();
  Json report = {{"title", c.title},
                 {"case", c.file.string()},
                 {"outcome", to_string(run.flow.verdict)},
                 {"words", run.flow.words}};
  report.update(forces_json<dim>(run.flow.forces, viscous));
  const Iteration last = run.flow.history.empty() ? Iteration{} : run.flow.history.back();
  report.update(Json{{"iterations", last.number}, {"residual_drop_orders", last.residual_drop_orders},
                     {"residual_at_rounding", run.flow.at_rounding}});
  Json bodies = Json::array();
  for (const auto& [marker, forces] : run.flow.forces_by_marker) {
    Json body = {{"name", run.conditions.at(marker).name}, {"marker", marker}};
    body.update(forces_json<dim>(forces, viscous));
    bodies.push_back(std::move(body));
  }
  report["bodies"] = std::move(bodies);
  Json boundaries = Json::array();
  for (const auto& [marker, flow] : run.flow.mass_flow)
    boundaries.push_back({{"name", run.conditions.at(marker).name},
                          {"kind", to_string(run.conditions.at(marker).kind)},
                          {"mass_flow_out", flow / c.flow.mach}});
  report["boundaries"] = std::move(boundaries);
  if (!run.flow.worst.empty()) {
    Json worst = Json::array();
    for (const auto& part : run.flow.worst) {
      const auto at = solver::axes(part.at);
      worst.push_back({{"at", Json(std::vector<double>(at.begin(), at.end()))}, {"share", part.share}});
    }
    report["worst_vertices"] = std::move(worst);
  }
  report["flow"] = conditions_json<dim>(c.flow);
  Json reference = {{"length", c.reference.length}};
  if (dim == 3) reference["area"] = c.reference.area;
  const auto& centre = c.reference.moment_centre;
  reference["moment_centre"] = Json(std::vector<double>(centre.begin(), centre.begin() + dim));
  report["reference"] = std::move(reference);
  return report;
}

template Json flow_json(const FlowRun<2>&);
template Json flow_json(const FlowRun<3>&);

Json ordering_json(const RunCommon& run) {
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

Json circumstances_json(const RunCommon& run, std::uint64_t peak_memory_bytes, const std::set<std::string>& files) {
  Json report = Json::object();
  Json seconds = Json::object();
  for (const StageTime& stage : run.stages) seconds[stage.name] = stage.seconds;
  seconds["total"] = run.total_seconds;
  report["seconds"] = seconds;
  report["threads"] = run.threads;
  report["peak_memory_bytes"] = peak_memory_bytes;
  report["warnings"] = run.warnings;
  Json keys = Json::object();
  for (const KeyInForce& key : run.the_case.keys) keys[key.key] = key.value;
  report["case_in_force"] = keys;
  for (const auto& [name, version] : versions()) report["versions"][name] = version;
  report["files"] = files;
  return report;
}

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

}  // namespace leonhard::app
