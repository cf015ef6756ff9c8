// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::mesh {

/// A box with sides along the axes, edges and corners included; at first empty.
struct Box3 {
  Point3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Point3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

  void include(const Box3& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
  }
  void include(const Point3& p) { include(Box3{p, p}); }
  [[nodiscard]] bool meets(const Box3& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
};

/// A binary tree over boxes in an order in which near boxes are near: each node the box of its two children.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box3>& boxes)
      : leaves_(std::bit_ceil(std::max<std::size_t>(boxes.size(), 1))), nodes_(2 * leaves_) {
    std::copy(boxes.begin(), boxes.end(), nodes_.begin() + static_cast<std::ptrdiff_t>(leaves_));
    for (std::size_t i = leaves_ - 1; i > 0; --i) {
      nodes_[i] = nodes_[2 * i];
      nodes_[i].include(nodes_[2 * i + 1]);
    }
  }

  /// Calls visit(i, j), i < j, for the pairs of boxes that meet until it returns true.
  /// Cost O(boxes log boxes + pairs) where boxes are small and the order is good.
  template <class Visit>
  void for_each_meeting_pair_until(Visit visit) const {
    for (std::size_t parent = 1; parent < leaves_; ++parent) {
      if (visit_pairs(2 * parent, 2 * parent + 1, visit)) return;
    }
  }
  /// Calls visit(i) for the boxes that meet another one.
  template <class Visit>
  void for_each_meeting(const Box3& box, Visit visit) const {
    visit_meeting(1, box, visit);
  }

 private:
  /// Pairs of one box under each of two nodes of the same level.
  template <class Visit>
  bool visit_pairs(std::size_t a, std::size_t b, Visit& visit) const {
    if (!nodes_[a].meets(nodes_[b])) return false;
    if (a >= leaves_) return visit(a - leaves_, b - leaves_);
    return visit_pairs(2 * a, 2 * b, visit) || visit_pairs(2 * a, 2 * b + 1, visit) ||
           visit_pairs(2 * a + 1, 2 * b, visit) || visit_pairs(2 * a + 1, 2 * b + 1, visit);
  }

  template <class Visit>
  void visit_meeting(std::size_t node, const Box3& box, Visit& visit) const {
    if (!nodes_[node].meets(box)) return;
    if (node >= leaves_) return visit(node - leaves_);
    visit_meeting(2 * node, box, visit);
    visit_meeting(2 * node + 1, box, visit);
  }

  std::size_t leaves_;
  std::vector<Box3>
      nodes_;  ///< node i has children 2 i and 2 i + 1, the root is 1; leaves without box are empty
};

}  // namespace leonhard::mesh
