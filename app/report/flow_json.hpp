// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/app/solve/run.hpp"

/// What the reports of flows in the plane and in space have in common; words are those of every other report of the program.
namespace leonhard::app {

/// A run, and what is known when it is reported.
template <class Run>
struct ReportOf {
  const Run& run;
  std::uint64_t peak_memory_bytes{};
  std::set<std::string> files;  ///< of the output folder, by name
};

/// Case, outcome, coefficients, those of each body, flow and reference.
template <int dim>
[[nodiscard]] Json flow_json(const FlowRun<dim>& run);

/// Each numbering of the vertices and what it costs.
[[nodiscard]] Json ordering_json(const RunCommon& run);

/// Times, memory, warnings, the case in force, versions and files.
[[nodiscard]] Json circumstances_json(const RunCommon& run, std::uint64_t peak_memory_bytes,
                                      const std::set<std::string>& files);

/// Libraries and compiler of this build, by name.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> versions();

}  // namespace leonhard::app
