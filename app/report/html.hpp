// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/app/report/page.hpp"
#include "leonhard/app/report/solve_report.hpp"

namespace leonhard::app {

/// One page that needs no network and no other file: figures, tables and pictures of a run.
[[nodiscard]] std::string report_html(const SolveReport& report, const std::vector<ReportPicture>& pictures);

}  // namespace leonhard::app
