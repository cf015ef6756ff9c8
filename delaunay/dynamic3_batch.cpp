// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/parallel.hpp"
#include "leonhard/kernel/hilbert.hpp"

namespace leonhard::delaunay {
namespace {

/// Ask a query of every point, in blocks along a Hilbert curve, each with a search of its own.
///
/// first_search  what a block's search starts as
/// query         query(point, search) -> Answer
template <class Answer, class Search, class Query>
std::vector<Answer> answer_all(std::span<const Point3> points, unsigned threads, const Search& first_search,
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

}  // namespace

std::vector<SpaceLocation> DynamicTetrahedralization::locate(std::span<const Point3> points,
                                                             unsigned threads) const {
  return answer_all<SpaceLocation>(points, threads, Search({}),
                                   [&](const Point3& p, Search& search) { return locate(p, search); });
}

std::vector<MaybeId<VertexId>> DynamicTetrahedralization::nearest_vertices(std::span<const Point3> points,
                                                                           unsigned threads) const {
  return answer_all<MaybeId<VertexId>>(points, threads, Search({}), [&](const Point3& p, Search& search) {
    return nearest_vertex(p, search);
  });
}

}  // namespace leonhard::delaunay
