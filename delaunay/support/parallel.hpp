// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

/// The few ways in which this room uses threads: oneTBB where LEONHARD_THREADS is on, plain loops otherwise.
///
/// threads  0: as many as there are cores; never more than these. With 1 everything runs in the calling
///          thread, in order.
///
/// Which thread runs what is left open, so bodies write to places of their own only. If a body throws, one of
/// the exceptions reaches the caller after the bodies that had begun have ended. Calls may be nested: each
/// has its own limit.
namespace leonhard::delaunay {

/// How many threads a call with this argument uses at most: 1 or more.
[[nodiscard]] unsigned thread_count(unsigned threads);

/// Run body(0), ..., body(count - 1). A block should be worth some microseconds; what a block is must not
/// depend on the number of threads where results are to be the same for any.
void parallel_for_blocks(std::size_t count, unsigned threads,
                         const std::function<void(std::size_t block)>& body);

/// Run body(i) for all i in [begin, end), in blocks of some ten thousand.
template <class Body>
void parallel_for_indices(std::size_t begin, std::size_t end, unsigned threads, const Body& body) {
  constexpr std::size_t block_size = std::size_t{1} << 15;
  parallel_for_blocks((end - begin + block_size - 1) / block_size, threads, [&](std::size_t block) {
    const std::size_t first = begin + block * block_size, last = std::min(first + block_size, end);
    for (std::size_t i = first; i < last; ++i) body(i);
  });
}

/// Run two bodies at once. Within them, calls should share `threads` among themselves.
void parallel_invoke(unsigned threads, const std::function<void()>& f, const std::function<void()>& g);

}  // namespace leonhard::delaunay
