// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace leonhard {

/// How long work reports and is asked to stop. Both may be left empty. Called from the thread that called the
/// library; a stop request is obeyed within 0.1 s on up to about a million points, within some tenths of a second more
/// for each ten millions.
struct Progress {
  std::function<void(std::string_view stage, double fraction)> report{};  ///< fraction in [0, 1]
  std::stop_token stop{};

  void operator()(std::string_view stage, double fraction) const {
    if (report) report(stage, fraction);
  }
  [[nodiscard]] bool stop_requested() const { return stop.stop_requested(); }
};

}  // namespace leonhard
