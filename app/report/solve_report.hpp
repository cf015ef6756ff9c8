// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/app/solve/run.hpp"

namespace leonhard::app {

/// A run, and what is known when it is reported.
struct SolveReport {
  const SolveRun& run;
  std::uint64_t peak_memory_bytes{};
  std::set<std::string> files;  ///< of the output folder, by name
};

/// The whole report: what report.json holds and --json prints. Words are those of every other report of the
/// program.
[[nodiscard]] Json to_json(const SolveReport& report);

/// Libraries and compiler of this build, by name.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> versions();

}  // namespace leonhard::app
