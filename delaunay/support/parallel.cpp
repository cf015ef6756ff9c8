// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/support/parallel.hpp"

#if defined(LEONHARD_HAS_TBB)
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#endif

namespace leonhard::delaunay {

#if defined(LEONHARD_HAS_TBB)
unsigned thread_count(unsigned threads) {
  const auto cores = static_cast<unsigned>(tbb::info::default_concurrency());
  return threads == 0 ? cores : std::min(threads, cores);
}

void parallel_for_blocks(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& body) {
  if (count > 1 && threads != 1) {
    tbb::task_arena arena(static_cast<int>(thread_count(threads)));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body); });
  } else {
    for (std::size_t block = 0; block < count; ++block) body(block);
  }
}

void parallel_invoke(unsigned threads, const std::function<void()>& f, const std::function<void()>& g) {
  if (threads != 1) {
    tbb::task_arena arena(static_cast<int>(thread_count(threads)));
    arena.execute([&] { tbb::parallel_invoke(f, g); });
  } else {
    f();
    g();
  }
}
#else
unsigned thread_count(unsigned /*threads*/) { return 1; }

void parallel_for_blocks(std::size_t count, unsigned /*threads*/,
                         const std::function<void(std::size_t)>& body) {
  for (std::size_t block = 0; block < count; ++block) body(block);
}

void parallel_invoke(unsigned /*threads*/, const std::function<void()>& f, const std::function<void()>& g) {
  f();
  g();
}
#endif

}  // namespace leonhard::delaunay
