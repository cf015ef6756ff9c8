// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "leonhard/app/solve/run.hpp"

namespace leonhard::app {

/// Times one stage of a run, from construction to destruction, and adds it to the run's total.
class StageClock {
 public:
  StageClock(RunCommon& run, std::string name) : run_(run), name_(std::move(name)) {}
  ~StageClock() {
    run_.stages.push_back({std::move(name_), seconds()});
    run_.total_seconds += run_.stages.back().seconds;
  }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  RunCommon& run_;
  std::string name_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace leonhard::app
