// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "leonhard/app/report/page.hpp"
#include "leonhard/app/solve/run.hpp"

namespace leonhard::app {

/// Draw every picture of a run into a folder, as PNG, and return them in the order of the report.
/// throws  OutputError
[[nodiscard]] std::vector<ReportPicture> draw_pictures(const SolveRun& run,
                                                       const std::filesystem::path& folder);

}  // namespace leonhard::app
