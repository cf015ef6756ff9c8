// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "leonhard/app/solve/run.hpp"

namespace leonhard::app {

/// JSON objects that keep the order in which keys were added.
using Json = nlohmann::ordered_json;

/// Euler's account with both sides of each formula.
[[nodiscard]] Json to_json(const EulerAccount& account);
[[nodiscard]] Json to_json(const MeshQuality& quality);
[[nodiscard]] Json to_json(const AreaAccount& area);
[[nodiscard]] Json to_json(const delaunay::RefineReport& report);

/// The whole report: what report.json holds and --json prints. Words are those of every other report of the
/// program.
[[nodiscard]] Json report_json(const SolveRun& run);

/// Libraries and compiler of this build, by name.
[[nodiscard]] Json versions_json();

/// Largest resident set of this process so far, bytes.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace leonhard::app
