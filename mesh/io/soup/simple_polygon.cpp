// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/simple_polygon.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::io {

namespace {

/// Whether p, known to be on the line ab, lies on the segment ab.
bool within(Point2 p, Point2 a, Point2 b) { return std::min(a, b) <= p && p <= std::max(a, b); }

/// Whether the closed segments ab and cd have a point in common.
bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  const Sign abc = kernel::orient2d(a, b, c), abd = kernel::orient2d(a, b, d);
  const Sign cda = kernel::orient2d(c, d, a), cdb = kernel::orient2d(c, d, b);
  if (abc * abd == Sign::negative && cda * cdb == Sign::negative) return true;
  return (abc == Sign::zero && within(c, a, b)) || (abd == Sign::zero && within(d, a, b)) ||
         (cda == Sign::zero && within(a, c, d)) || (cdb == Sign::zero && within(b, c, d));
}

/// Whether the path abc turns back on itself at b.
bool folds_back(Point2 a, Point2 b, Point2 c) {
  return kernel::orient2d(a, b, c) == Sign::zero && (a < b) == (c < b);
}

/// The edges of a closed polygon, asked by their indices.
class Edges {
 public:
  explicit Edges(std::span<const Point2> points) : points_(points) {}
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] Point2 from(std::size_t i) const { return points_[i]; }
  [[nodiscard]] Point2 to(std::size_t i) const { return points_[next(i)]; }
  [[nodiscard]] double min_x(std::size_t i) const { return std::min(from(i).x, to(i).x); }
  [[nodiscard]] double max_x(std::size_t i) const { return std::max(from(i).x, to(i).x); }
  [[nodiscard]] bool heights_overlap(std::size_t i, std::size_t j) const {
    return std::max(from(i).y, to(i).y) >= std::min(from(j).y, to(j).y) &&
           std::max(from(j).y, to(j).y) >= std::min(from(i).y, to(i).y);
  }
  [[nodiscard]] bool meet(std::size_t i, std::size_t j) const {
    if (next(i) == j) return folds_back(from(i), to(i), to(j));
    if (next(j) == i) return folds_back(from(j), to(j), to(i));
    return segments_meet(from(i), to(i), from(j), to(j));
  }

 private:
  std::span<const Point2> points_;
};

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> edges_that_meet(std::span<const Point2> polygon) {
  const Edges edges(polygon);
  std::vector<std::size_t> by_min_x(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) by_min_x[i] = i;
  std::sort(by_min_x.begin(), by_min_x.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(edges.min_x(i), i) < std::pair(edges.min_x(j), j);
  });
  std::vector<std::size_t>
      open;  // edges that a vertical line swept to the current edge's left end still cuts
  for (const std::size_t i : by_min_x) {
    std::erase_if(open, [&](std::size_t j) { return edges.max_x(j) < edges.min_x(i); });
    for (const std::size_t j : open)
      if (edges.heights_overlap(i, j) && edges.meet(i, j)) return std::minmax({i, j});
    open.push_back(i);
  }
  return std::nullopt;
}

bool is_counter_clockwise(std::span<const Point2> simple_polygon) {
  const auto n = simple_polygon.size();
  const auto smallest = static_cast<std::size_t>(
      std::min_element(simple_polygon.begin(), simple_polygon.end()) - simple_polygon.begin());
  const Point2 before = simple_polygon[(smallest + n - 1) % n], after = simple_polygon[(smallest + 1) % n];
  return kernel::orient2d(before, simple_polygon[smallest], after) == Sign::positive;
}

}  // namespace leonhard::io
