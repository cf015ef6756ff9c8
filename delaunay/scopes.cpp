// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/scopes.hpp"

#include <algorithm>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

Sign turn(std::span<const Point2> sites, const Corners& corners) {
  return kernel::orient2d(sites[corners[0].index()], sites[corners[1].index()], sites[corners[2].index()]);
}

/// One a site: when it came.
PerId<VertexId, std::size_t> ranks(const std::vector<std::uint32_t>& order) {
  PerId<VertexId, std::size_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[VertexId{order[i]}] = i;
  return rank;
}

}  // namespace

std::size_t scope(std::span<const Point2> sites, const Corners& corners) {
  for (const VertexId v : corners)
    if (v.index() >= sites.size())
      throw InputError("corners", "vertex " + std::to_string(v.raw) + " is none of " +
                                      std::to_string(sites.size()) + " sites");
  const Point2 a = sites[corners[0].index()], b = sites[corners[1].index()], c = sites[corners[2].index()];
  const Sign inside = turn(sites, corners);  // incircle has this sign inside
  if (inside == Sign::zero)
    throw InputError("corners",
                     mesh::words(a) + ", " + mesh::words(b) + " and " + mesh::words(c) + " are collinear",
                     "give corners that turn");
  return static_cast<std::size_t>(std::count_if(sites.begin(), sites.end(), [&](Point2 p) {
    return kernel::incircle_perturbed(a, b, c, p) == inside;
  }));
}

std::vector<std::size_t> triangles_of_scope(std::span<const Point2> sites) {
  std::vector<std::size_t> count(sites.size() < 3 ? 0 : sites.size() - 2, 0);
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Corners corners{VertexId::from(i), VertexId::from(j), VertexId::from(k)};
        if (turn(sites, corners) != Sign::zero) ++count[scope(sites, corners)];
      }
  return count;
}

double appearance_probability(std::size_t scope) {
  const auto j = static_cast<double>(scope);
  return 6 / ((j + 1) * (j + 2) * (j + 3));
}

void for_each_delaunay_ever(const DelaunayTree& tree, const std::function<void(const Corners&)>& visit) {
  const TriangleHistory& history = tree.history();
  const PerId<VertexId, std::size_t> rank = ranks(tree.order());
  const auto newest = [&](HistoryNodeId n) {
    std::size_t latest = 0;
    for (const VertexId v : history.corners(n))
      if (v != GhostTriangulation::ghost) latest = std::max(latest, rank[v]);
    return latest;
  };
  for (const HistoryNodeId n : IdRange<HistoryNodeId>(history.node_count()))
    if (history.child_count(n) == 0 || newest(n) != newest(history.child(n, 0))) visit(history.corners(n));
}

}  // namespace leonhard::delaunay
