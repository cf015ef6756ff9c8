// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/app/report/page.hpp"

namespace leonhard::app {

/// The pictures of a report: drawn into one folder, collected in order.
class Album {
 public:
  explicit Album(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Where the next picture is to be drawn.
  [[nodiscard]] std::filesystem::path path(const std::string& name) {
    last_ = name;
    return folder_ / name;
  }
  /// Take the picture that was drawn at the last path.
  void add(std::string title, std::string caption);

  /// The residual against its first value, lift and drag: history.png.
  void add_history(const std::vector<Iteration>& history);

  [[nodiscard]] std::vector<ReportPicture> take() { return std::move(pictures_); }

 private:
  std::filesystem::path folder_;
  std::string last_;
  std::vector<ReportPicture> pictures_;
};

}  // namespace leonhard::app
