// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "leonhard/kernel/progress.hpp"

namespace leonhard::graph::detail {

/// Counts the small steps of long work: every few thousand of them it reports and asks whether to stop. A stop once
/// seen stays. Not for callers outside this room.
class StepCounter {
 public:
  /// steps  expected in all
  StepCounter(const Progress& progress, std::string_view stage, std::size_t steps)
      : progress_(progress), stage_(stage), expected_(std::max<std::size_t>(steps, 1)) {
    look();
  }

  /// One more step; returns whether to go on.
  [[nodiscard]] bool step() {
    constexpr std::size_t between_looks = 2048;
    if (++done_ % between_looks == 0) look();
    return !stopped_;
  }
  /// Asks at once.
  [[nodiscard]] bool goes_on() {
    stopped_ = stopped_ || progress_.stop_requested();
    return !stopped_;
  }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  void look() {
    progress_(stage_, static_cast<double>(std::min(done_, expected_)) / static_cast<double>(expected_));
    stopped_ = stopped_ || progress_.stop_requested();
  }

  const Progress& progress_;
  std::string_view stage_;
  std::size_t expected_;
  std::size_t done_ = 0;
  bool stopped_ = false;
};

}  // namespace leonhard::graph::detail
