// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/app/report/flow_json.hpp"

namespace leonhard::app {

using SolveReport = ReportOf<SolveRun>;

/// The whole report of a flow in the plane: what report.json holds and --json prints.
[[nodiscard]] Json to_json(const SolveReport& report);

}  // namespace leonhard::app
