// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "leonhard/delaunay/parallel.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// Move values[i] to values[to[i]] for all i, in place, and so in several vectors of one length.
///
/// to       a permutation of 0 to values.size() - 1; used up
/// threads  0: as many as there are cores; the answer does not depend on it
/// Following the cycles of a permutation waits for memory at every step. So values go to the right block first, each block
/// filling up from its beginning (McIlroy, Bostic and McIlroy, "Engineering radix sort", Computing Systems 6, 1993), and
/// then to their places within blocks that fit into a cache. Cost O(n).
template <class... T>
void permute_in_place(std::vector<IdRaw>& to, unsigned threads, std::vector<T>&... values) {
  constexpr std::size_t block_size = std::size_t{1} << 15;
  const std::size_t size = to.size(), blocks = (size + block_size - 1) / block_size;
  const auto block_of = [&](std::size_t i) { return to[i] / block_size; };
  const auto swap_places = [&](std::size_t i, std::size_t j) {
    (std::swap(values[i], values[j]), ...);
    std::swap(to[i], to[j]);
  };

  std::vector<std::size_t> next(blocks);  // all values of the block before it are in the right block
  for (std::size_t b = 0; b < blocks; ++b) next[b] = b * block_size;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t end = std::min((b + 1) * block_size, size);
    for (; next[b] < end; ++next[b]) {
      const std::size_t hole = next[b];
      while (block_of(hole) != b) {
        std::size_t& place = next[block_of(hole)];
        while (block_of(place) == block_of(hole)) ++place;
        swap_places(hole, place);
      }
    }
  }
  parallel_for_blocks(blocks, threads, [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * block_size, size);
    for (std::size_t i = b * block_size; i < end; ++i) {
      while (to[i] != i) swap_places(i, to[i]);
    }
  });
}

}  // namespace leonhard::delaunay
