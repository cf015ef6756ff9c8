// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/fast.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

#include "leonhard/delaunay/plane/hull_merge.hpp"
#include "leonhard/delaunay/support/parallel.hpp"

namespace leonhard::delaunay {
namespace {

/// The tree of cuts over points, down to blocks of some thousands that are one thread's work at a time.
class CutTree {
 public:
  explicit CutTree(std::span<const std::uint16_t> cut_depth) : cut_depth_(cut_depth) {
    if (!cut_depth.empty()) add(0, static_cast<std::uint32_t>(cut_depth.size()));
  }

  struct Node {
    std::uint32_t first, last, cut;  ///< the cut lies before point `cut`; 0 in a block
    std::size_t lower, upper;        ///< nodes
    [[nodiscard]] bool is_block() const { return cut == 0; }
  };
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Nodes by height: those of one height do not depend on each other, and on lower ones only.
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& levels() const { return levels_; }

 private:
  static constexpr std::uint32_t block_size = 1U << 13;

  struct Added {
    std::size_t node, height;
  };
  Added add(std::uint32_t first, std::uint32_t last) {
    Node node{first, last, 0, 0, 0};
    std::size_t height = 0;
    if (last - first > block_size) {
      node.cut = highest_cut(first, last);
      const Added lower = add(first, node.cut), upper = add(node.cut, last);
      node.lower = lower.node;
      node.upper = upper.node;
      height = 1 + std::max(lower.height, upper.height);
    }
    if (levels_.size() <= height) levels_.resize(height + 1);
    levels_[height].push_back(nodes_.size());
    nodes_.push_back(node);
    return {nodes_.size() - 1, height};
  }

  /// Of several equally high ones that nearest to the middle.
  [[nodiscard]] std::uint32_t highest_cut(std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t middle = first + (last - first) / 2;
    const auto off_middle = [&](std::uint32_t i) { return i < middle ? middle - i : i - middle; };
    std::uint32_t best = first + 1;
    for (std::uint32_t i = best + 1; i < last; ++i)
      if (cut_depth_[i] < cut_depth_[best] ||
          (cut_depth_[i] == cut_depth_[best] && off_middle(i) < off_middle(best)))
        best = i;
    return best;
  }

  std::span<const std::uint16_t> cut_depth_;
  std::vector<Node> nodes_;
  std::vector<std::vector<std::size_t>> levels_;
};

bool has_real_triangle(const GhostTriangulation& in) {
  for (std::size_t t = 0; t < in.triangle_count(); ++t)
    if (!in.is_ghost(AnyTriangleId::from(t))) return true;
  return false;
}

class Divider {
 public:
  Divider(const CutOrder& order, GhostTriangulation& in)
      : order_(order), points_(order.sorted.points), in_(in) {}

  /// Merges as soon as all deeper cuts are behind: the recursion over the tree of cuts without the recursion.
  [[nodiscard]] Part conquer(std::uint32_t first, std::uint32_t last) const {
    struct Pending {
      Part part;
      std::uint32_t cut;  // behind it
    };
    std::vector<Pending> pending;
    for (std::uint32_t i = first; i < last; ++i) {
      Part part = Part::single(i);
      while (!pending.empty() && (i + 1 == last || depth(pending.back().cut) >= depth(i + 1))) {
        part = join(pending.back().part, part);
        pending.pop_back();
      }
      pending.push_back({part, i + 1});
    }
    return pending.back().part;
  }
  [[nodiscard]] Part join(const Part& lower, const Part& upper) const {
    return merge(points_, in_, lower, upper, depth(upper.first) % 2 == 0 ? Cut::by_x : Cut::by_y);
  }

 private:
  [[nodiscard]] unsigned depth(std::uint32_t cut) const { return order_.cut_depth[cut]; }

  const CutOrder& order_;
  std::span<const Point2> points_;
  GhostTriangulation& in_;
};

}  // namespace

PointTriangulation triangulate_fast(const CutOrder& order, const AlgorithmOptions& options) {
  const std::size_t n = order.sorted.points.size();
  if (n < 3) return {TriangulateOutcome::too_few_points, {}};
  PointTriangulation result{TriangulateOutcome::done, GhostTriangulation(2 * n - 2)};
  const Divider divider(order, result.triangulation);
  const CutTree tree(order.cut_depth);
  std::vector<Part> parts(tree.nodes().size());
  std::atomic<bool> stopped{false};
  std::atomic<std::size_t> points_done{0};
  const auto caller = std::this_thread::get_id();
  const auto make = [&](std::size_t i) {
    const CutTree::Node& node = tree.nodes()[i];
    if (stopped || options.progress.stop_requested()) {
      stopped = true;
    } else if (node.is_block()) {
      parts[i] = divider.conquer(node.first, node.last);
      points_done += node.last - node.first;
      if (std::this_thread::get_id() == caller)
        options.progress("triangulate", static_cast<double>(points_done) / static_cast<double>(n));
    } else {
      parts[i] = divider.join(parts[node.lower], parts[node.upper]);
    }
  };
  for (const std::vector<std::size_t>& level : tree.levels()) {
    parallel_for_blocks(level.size(), options.threads, [&](std::size_t k) { make(level[k]); });
    if (stopped) return {TriangulateOutcome::stopped, {}};
  }
  if (!has_real_triangle(result.triangulation)) return {TriangulateOutcome::all_collinear, {}};
  return result;
}

PointTriangulation triangulate_fast(std::span<const Point2> points, const AlgorithmOptions& options) {
  const std::optional<CutOrder> order = sort_by_cuts(points, options.threads, options.progress);
  if (!order) return {TriangulateOutcome::stopped, {}};
  PointTriangulation result = triangulate_fast(*order, options);
  result.triangulation.renumber_vertices(order->sorted.first_input);
  return result;
}

}  // namespace leonhard::delaunay
