// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace leonhard::solver {

/// Runs a body once for each part, on a fixed number of threads. Which thread runs which part is left open, so bodies
/// write to their own part only.
class PartRunner {
 public:
  /// threads  >= 1; one thread where Leonhard was built without threads
  explicit PartRunner(int threads);
  ~PartRunner();
  PartRunner(PartRunner&&) noexcept;
  PartRunner& operator=(PartRunner&&) noexcept;

  void operator()(std::size_t parts, const std::function<void(std::size_t part)>& body) const;

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace leonhard::solver
