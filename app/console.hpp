// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "leonhard/kernel/progress.hpp"

namespace leonhard::app {

/// Progress and warnings on stderr; results never come here.
///
/// On a terminal a line may be rewritten in place; where stderr is a file or a pipe, and with --quiet,
/// progress is silent and only warnings and errors speak.
class Console {
 public:
  explicit Console(bool quiet);

  /// A finished stage, kept on the screen: "mesh        18,204 vertices, 36,012 triangles   0.31 s".
  void stage(std::string_view name, std::string_view what, double seconds);
  /// A line that the next one overwrites.
  void transient(const std::string& line);
  /// Always shown, whatever the verbosity.
  void warning(const std::string& text);
  [[nodiscard]] bool talks() const { return talks_; }

 private:
  void clear_transient();
  bool talks_;
  bool transient_shown_ = false;
};

/// "18,204": thousands apart, as every table and message of the program shows counts.
[[nodiscard]] std::string grouped(unsigned long long count);

/// Ctrl-C and SIGTERM as a stop_token for the whole program: the first asks the work to end and write what it
/// has, the second ends the process at once. The handlers only touch an atomic flag; a watching thread makes
/// the request.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::array<int, 2> pipe_{};  ///< from the handlers to the watcher
  std::jthread watcher_;
};

}  // namespace leonhard::app
