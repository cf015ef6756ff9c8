// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tetrahedralize.hpp"

#include <limits>
#include <utility>

#include "leonhard/delaunay/order/tet_sort.hpp"
#include "leonhard/delaunay/space/tet_insertion.hpp"
#include "leonhard/delaunay/space/tet_point_mesh.hpp"
#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {
namespace {

/// Tetrahedra to a point of a set that fills space: 96 pi^2 / 35 + 24 / 35 = 27.07 corners at each (Miles 1970).
constexpr double tetrahedra_a_point = 6.77;

void check_size(std::size_t points, std::size_t memory_limit) {
  if (points > std::numeric_limits<std::uint32_t>::max() - 1)
    throw InputError("points", std::to_string(points) + " of them are more than 2^32 - 2",
                     "leave points out");
  const auto most = static_cast<double>(GhostTetrahedralization::ghost.index());
  if (static_cast<double>(points) * tetrahedra_a_point > most)
    throw InputError(
        "points",
        std::to_string(points) + " of them make about " +
            std::to_string(static_cast<std::uint64_t>(static_cast<double>(points) * tetrahedra_a_point)) +
            " tetrahedra, which ids of " + std::to_string(8 * sizeof(IdRaw)) + " bits cannot number",
        "build with -DLEONHARD_64BIT_IDS=ON or leave points out");
  if (memory_limit != 0 && expected_bytes(points) > memory_limit)
    throw InputError("points",
                     std::to_string(points) + " of them need about " +
                         std::to_string(expected_bytes(points)) + " bytes of memory, the limit is " +
                         std::to_string(memory_limit),
                     "raise the limit or leave points out");
}

/// Distinct points along a Hilbert curve.
struct SortedNodes {
  std::vector<TetNode> nodes;
  SortedOrigin origin;
};

SortedNodes sort_and_merge(const std::vector<Point3>& points) {
  const std::vector<std::uint32_t> order = kernel::hilbert_order(points);
  SortedNodes sorted;
  auto& [nodes, origin] = sorted;
  nodes.reserve(points.size());
  prefer_large_pages(nodes.data(), points.size() * sizeof(TetNode));
  origin.first_input.reserve(points.size());
  origin.sorted_index.resize(points.size());
  for (const std::uint32_t i : order) {
    if (nodes.empty() || nodes.back().point != points[i]) {
      nodes.push_back({points[i], {}});
      origin.first_input.push_back(i);
    }
    origin.sorted_index[i] = static_cast<std::uint32_t>(nodes.size() - 1);
  }
  return sorted;
}

InsertedNodes made_of(std::vector<TetNode> nodes, const TetrahedralizeOptions& options) {
  const TetAlgorithmOptions how{options.seed, options.threads, options.progress};
  if (options.algorithm == TetAlgorithm::insertion) return insert_nodes(std::move(nodes), how);
  std::vector<Point3> points(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) points[i] = nodes[i].point;
  release(nodes);
  PointTetrahedralization made = tetrahedralize_distinct(points, options.algorithm, how);
  return {made.outcome, std::move(made.cells), {}};
}

}  // namespace

std::size_t expected_bytes(std::size_t points) { return 300 * points; }

Tetrahedralization tetrahedralize(std::vector<Point3> points, const TetrahedralizeOptions& options) {
  using Outcome = TetrahedralizeOutcome;
  check_size(points.size(), options.memory_limit_bytes);
  options.progress("sort", 0);
  SortedNodes sorted = sort_and_merge(points);
  Tetrahedralization result;
  const std::size_t vertices = sorted.nodes.size(), duplicates = points.size() - vertices;
  if (duplicates > 0)
    result.repairs.push_back(std::to_string(duplicates) +
                             (duplicates == 1
                                  ? " point lies at the place of an earlier one and was merged into it"
                                  : " points lie at the places of earlier ones and were merged into them"));
  InsertedNodes made = made_of(std::move(sorted.nodes), options);
  result.outcome = made.outcome;
  if (made.outcome == Outcome::done && options.progress.stop_requested()) result.outcome = Outcome::stopped;
  if (result.outcome != Outcome::done) {
    result.vertex_of_input.resize(points.size());
    return result;
  }
  if (options.sorted)
    sort_and_drop_ghosts(made.cells, vertices, options.threads);
  else
    drop_ghosts(made.cells);
  TetPointMesh mesh =
      to_mesh(std::move(made.cells), std::move(sorted.origin), std::move(points), options.threads);
  result.mesh = std::move(mesh.mesh);
  result.vertex_of_input = std::move(mesh.vertex_of_input);
  options.progress("tetrahedralize", 1);
  return result;
}

}  // namespace leonhard::delaunay
