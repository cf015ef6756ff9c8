// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/support/large_vector.hpp"

#include <algorithm>

#include "leonhard/delaunay/support/parallel.hpp"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace leonhard::delaunay {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t page = 4096, worth_it = std::size_t{8} << 20;
  if (bytes < worth_it) return;
  const std::size_t offset = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  // Refused where the system has no large pages: then small ones do.
  static_cast<void>(
      madvise(static_cast<char*>(memory) + offset, (bytes - offset) / page * page, MADV_HUGEPAGE));
#endif
}

void touch_pages(void* memory, std::size_t bytes, unsigned threads) {
  constexpr std::size_t page = 4096, block_size = std::size_t{2} << 20;
  parallel_for_blocks((bytes + block_size - 1) / block_size, threads, [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * block_size, bytes);
    for (std::size_t at = block * block_size; at < end; at += page) static_cast<volatile char*>(memory)[at] = 0;
  });
}

}  // namespace leonhard::delaunay
