// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::mesh {

template <class Point>
inline constexpr std::array<double Point::*, 2> axes_of{&Point::x, &Point::y};
template <>
inline constexpr std::array<double Point3::*, 3> axes_of<Point3>{&Point3::x, &Point3::y, &Point3::z};

/// A box with sides along the axes, edges and corners included; at first empty.
template <class Point>
struct Box {
  Point low = filled_with(std::numeric_limits<double>::infinity());
  Point high = filled_with(-std::numeric_limits<double>::infinity());

  void include(const Box& other) {
    for (const auto x : axes_of<Point>) {
      low.*x = std::min(low.*x, other.low.*x);
      high.*x = std::max(high.*x, other.high.*x);
    }
  }
  void include(const Point& p) { include(Box{p, p}); }
  [[nodiscard]] bool meets(const Box& other) const {
    bool meets = true;
    for (const auto x : axes_of<Point>) meets = meets && low.*x <= other.high.*x && other.low.*x <= high.*x;
    return meets;
  }
  [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }

 private:
  static constexpr Point filled_with(double value) {
    Point p;
    for (const auto x : axes_of<Point>) p.*x = value;
    return p;
  }
};

using Box2 = Box<Point2>;
using Box3 = Box<Point3>;

/// A binary tree over boxes in an order in which near boxes are near: each node the box of its two children.
template <class Point>
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box<Point>>& boxes)
      : leaves_(std::bit_ceil(std::max<std::size_t>(boxes.size(), 1))), nodes_(2 * leaves_) {
    std::copy(boxes.begin(), boxes.end(), nodes_.begin() + static_cast<std::ptrdiff_t>(leaves_));
    for (std::size_t i = leaves_ - 1; i > 0; --i) {
      nodes_[i] = nodes_[2 * i];
      nodes_[i].include(nodes_[2 * i + 1]);
    }
  }

  /// The box of all; empty if there is none.
  [[nodiscard]] const Box<Point>& box() const { return nodes_[1]; }

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
  void for_each_meeting(const Box<Point>& box, Visit visit) const {
    visit_meeting(1, box, visit);
  }
  /// Calls visit(i) for boxes as near as distance(box) says, the nearer of two children first, but for those that may be
  /// left out: may_skip(distance(box)). A box never has a smaller distance than one that holds it.
  template <class Distance, class MaySkip, class Visit>
  void for_each_near(Distance distance, MaySkip may_skip, Visit visit) const {
    if (!nodes_[1].is_empty() && !may_skip(distance(nodes_[1]))) visit_near(1, distance, may_skip, visit);
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
  void visit_meeting(std::size_t node, const Box<Point>& box, Visit& visit) const {
    if (!nodes_[node].meets(box)) return;
    if (node >= leaves_) {
      visit(node - leaves_);
      return;
    }
    visit_meeting(2 * node, box, visit);
    visit_meeting(2 * node + 1, box, visit);
  }

  template <class Distance, class MaySkip, class Visit>
  void visit_near(std::size_t node, Distance& distance, MaySkip& may_skip, Visit& visit) const {
    if (node >= leaves_) {
      visit(node - leaves_);
      return;
    }
    std::array<std::pair<double, std::size_t>, 2> children;
    std::size_t count = 0;
    for (const std::size_t child : {2 * node, 2 * node + 1}) {
      if (!nodes_[child].is_empty()) children[count++] = {distance(nodes_[child]), child};
    }
    if (count == 2 && children[1].first < children[0].first) std::swap(children[0], children[1]);
    for (std::size_t i = 0; i < count; ++i) {
      if (!may_skip(children[i].first)) visit_near(children[i].second, distance, may_skip, visit);
    }
  }

  std::size_t leaves_;
  /// Node i has children 2 i and 2 i + 1, the root is 1; leaves without box are empty.
  std::vector<Box<Point>> nodes_;
};

}  // namespace leonhard::mesh
