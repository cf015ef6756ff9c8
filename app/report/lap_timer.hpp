// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "leonhard/app/report/json.hpp"

namespace leonhard::app {

/// Wall-clock seconds of the stages of a subcommand, one after another.
class LapTimer {
 public:
  /// The stage that began with the last lap ends here.
  void lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    seconds_[stage] = std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// {"read": 0.1, ..., "total": 0.4}
  [[nodiscard]] Json seconds() const {
    Json all = seconds_;
    all["total"] = std::chrono::duration<double>(last_ - start_).count();
    return all;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_ = start_;
  Json seconds_ = Json::object();
};

}  // namespace leonhard::app
