// SPDX-License-Identifier: MIT
#include "leonhard/solver/support/parallel.hpp"

#if defined(LEONHARD_HAS_TBB)
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#endif

namespace leonhard::solver {

#if defined(LEONHARD_HAS_TBB)
struct PartRunner::Arena {
  explicit Arena(int threads) : tasks(threads) {}
  tbb::task_arena tasks;
};

PartRunner::PartRunner(int threads) {
  // More than the processors would only make oneTBB complain.
  const int used = std::min(threads, tbb::info::default_concurrency());
  if (used > 1) arena_ = std::make_unique<Arena>(used);
}

void PartRunner::operator()(std::size_t parts, const std::function<void(std::size_t)>& body) const {
  if (arena_ && parts > 1)
    arena_->tasks.execute([&] { tbb::parallel_for(std::size_t{0}, parts, body); });
  else
    for (std::size_t part = 0; part < parts; ++part) body(part);
}
#else
struct PartRunner::Arena {};

PartRunner::PartRunner(int /*threads*/) {}

void PartRunner::operator()(std::size_t parts, const std::function<void(std::size_t)>& body) const {
  for (std::size_t part = 0; part < parts; ++part) body(part);
}
#endif

PartRunner::~PartRunner() = default;
PartRunner::PartRunner(PartRunner&&) noexcept = default;
PartRunner& PartRunner::operator=(PartRunner&&) noexcept = default;

}  // namespace leonhard::solver
