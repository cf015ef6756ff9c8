// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/app/report/solve_report.hpp"

namespace leonhard::app {

/// A picture of the report: its PNG bytes go into the page.
struct ReportPicture {
  std::string title;
  std::string caption;
  std::string file;  ///< name beside the page, for the link to the full size
  std::string png;
};

/// One page that needs no network and no other file: figures, tables and pictures of a run.
///
[[nodiscard]] std::string report_html(const SolveReport& report, const std::vector<ReportPicture>& pictures);

}  // namespace leonhard::app
