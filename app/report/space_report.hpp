// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "leonhard/app/report/flow_json.hpp"
#include "leonhard/app/report/page.hpp"
#include "leonhard/app/solve/space_run.hpp"

namespace leonhard::app {

using SpaceReport = ReportOf<SpaceRun>;

/// The whole report of a flow in space: what report.json holds and --json prints.
[[nodiscard]] Json to_json(const SpaceReport& report);

/// One page that needs no network and no other file.
[[nodiscard]] std::string report_html(const SpaceReport& report, const std::vector<ReportPicture>& pictures);

/// Draw every picture of a run into a folder, as PNG, and return them in the order of the report: Cp on the walls, Mach on the
/// section through their middle across y, Cp along the walls there, convergence, boundaries.
/// throws  OutputError
[[nodiscard]] std::vector<ReportPicture> draw_pictures(const SpaceRun& run, const std::filesystem::path& folder);

/// field.vtu, surface.vtu, history.csv and all pictures of a run, then report.json and report.html, into a folder. Times the
/// writing as the stage "write".
///
/// returns  the report, as in report.json
/// throws   OutputError
Json write_report(SpaceRun& run, const std::filesystem::path& folder);

}  // namespace leonhard::app
