// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

/// Vertices by cells of a grid as wide as the tolerance.
template <class Point>
class PlaceGrid {
 public:
  explicit PlaceGrid(double width) : width_(width) {}

  void add(VertexId v, const Point& p) { by_cell_[key(cell_of(p))].push_back(v); }

  /// Calls visit(vertex) for those in the cells about a place.
  template <class Visit>
  void for_each_near(const Point& p, Visit visit) const {
    const std::array<double, 3> middle = cell_of(p);
    std::array<double, 3> cell{};
    const double dz = sizeof(Point) == sizeof(Point3) ? 1 : 0;
    for (cell[0] = middle[0] - 1; cell[0] <= middle[0] + 1; ++cell[0])
      for (cell[1] = middle[1] - 1; cell[1] <= middle[1] + 1; ++cell[1])
        for (cell[2] = middle[2] - dz; cell[2] <= middle[2] + dz; ++cell[2])
          if (const auto found = by_cell_.find(key(cell)); found != by_cell_.end())
            for (const VertexId v : found->second) visit(v);
  }

 private:
  /// Beyond 2^50 cells neighbours are no longer told apart; then the tolerance is less than rounding.
  [[nodiscard]] double cell_number(double x) const {
    constexpr double most = 0x1p50;
    return std::clamp(std::floor(x / width_), -most, most);
  }
  [[nodiscard]] std::array<double, 3> cell_of(Point2 p) const {
    return {cell_number(p.x), cell_number(p.y), 0};
  }
  [[nodiscard]] std::array<double, 3> cell_of(const Point3& p) const {
    return {cell_number(p.x), cell_number(p.y), cell_number(p.z)};
  }
  [[nodiscard]] static std::uint64_t key(const std::array<double, 3>& cell) {
    std::uint64_t hash = 0;
    for (const double c : cell)
      hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(c))) * 0x9E3779B97F4A7C15ULL;
    return hash;
  }

  double width_;
  std::unordered_map<std::uint64_t, std::vector<VertexId>> by_cell_;
};

/// The nearest vertex within the tolerance that has come before and stays.
template <class Point>
PerId<VertexId, VertexId> nearest_within(const PerId<VertexId, Point>& points, double tolerance) {
  PerId<VertexId, VertexId> nearest = every_vertex_itself(points.size());
  PlaceGrid<Point> grid(tolerance);
  for (const VertexId v : points.ids()) {
    double best = tolerance;
    bool found = false;
    grid.for_each_near(points[v], [&](VertexId other) {
      const double apart = distance(points[v], points[other]);
      if (apart > best || (found && apart == best)) return;
      best = apart;
      nearest[v] = other;
      found = true;
    });
    if (!found) grid.add(v, points[v]);
  }
  return nearest;
}

}  // namespace

PerId<VertexId, VertexId> every_vertex_itself(std::size_t count) {
  PerId<VertexId, VertexId> itself(count);
  for (const VertexId v : itself.ids()) itself[v] = v;
  return itself;
}

template <class Point>
PerId<VertexId, VertexId> first_at_equal_places(const PerId<VertexId, Point>& points) {
  std::vector<VertexId> order;
  order.reserve(points.size());
  for (const VertexId v : points.ids()) order.push_back(v);
  std::sort(order.begin(), order.end(),
            [&](VertexId a, VertexId b) { return std::pair(points[a], a) < std::pair(points[b], b); });
  PerId<VertexId, VertexId> first = every_vertex_itself(points.size());
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points[order[i]] == points[order[i - 1]]) first[order[i]] = first[order[i - 1]];
  return first;
}

template <class Point>
PerId<VertexId, VertexId> weld_places(const PerId<VertexId, Point>& points, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance))
    throw InputError("--weld", "the tolerance is " + mesh::words(tolerance), "give 0 or more");
  return tolerance == 0 ? first_at_equal_places(points) : nearest_within(points, tolerance);
}

template PerId<VertexId, VertexId> first_at_equal_places(const PerId<VertexId, Point2>&);
template PerId<VertexId, VertexId> first_at_equal_places(const PerId<VertexId, Point3>&);
template PerId<VertexId, VertexId> weld_places(const PerId<VertexId, Point2>&, double);
template PerId<VertexId, VertexId> weld_places(const PerId<VertexId, Point3>&, double);

}  // namespace leonhard::io
