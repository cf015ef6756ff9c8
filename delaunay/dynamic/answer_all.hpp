// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/delaunay/support/parallel.hpp"
#include "leonhard/kernel/hilbert.hpp"

namespace leonhard::delaunay {

/// Ask a query of every point, of the plane or of space, in blocks along a Hilbert curve, each with a search of its own.
///
/// first_search  what a block's search starts as
/// query         query(point, search) -> Answer
template <class Answer, class Point, class Search, class Query>
std::vector<Answer> answer_all(std::span<const Point> points, unsigned threads, const Search& first_search,
                               const Query& query) {
  constexpr std::size_t block_size = 1024;
  const std::vector<std::uint32_t> order = kernel::hilbert_order(points);
  std::vector<Answer> answers(points.size());
  parallel_for_blocks((order.size() + block_size - 1) / block_size, threads, [&](std::size_t block) {
    Search search = first_search;
    const std::size_t end = std::min(order.size(), (block + 1) * block_size);
    for (std::size_t i = block * block_size; i < end; ++i)
      answers[order[i]] = query(points[order[i]], search);
  });
  return answers;
}

}  // namespace leonhard::delaunay
