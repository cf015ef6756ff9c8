// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "leonhard/app/report/json.hpp"
#include "leonhard/app/solve/run.hpp"

namespace leonhard::app {

/// field.vtu, surface.csv, history.csv, mesh.su2 and all pictures of a run, then report.json and report.html, into a
/// folder. Times the writing as the stage "write".
///
/// returns  the report, as in report.json
/// throws   OutputError
Json write_report(SolveRun& run, const std::filesystem::path& folder);

}  // namespace leonhard::app
