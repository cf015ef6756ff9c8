// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"

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
/// report     as report_json makes it
/// case_text  the case file as read
[[nodiscard]] std::string report_html(const Json& report, const std::vector<ReportPicture>& pictures,
                                      const std::string& case_text);

}  // namespace leonhard::app
