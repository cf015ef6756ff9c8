// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/soup_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/soup/soup_checks.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

template <class T>
void keep_rows(std::vector<T>& values, const std::vector<bool>& kept, std::size_t components) {
  if (values.empty()) return;
  std::size_t next = 0;
  for (std::size_t row = 0; row < kept.size(); ++row) {
    if (!kept[row]) continue;
    std::move(values.begin() + static_cast<std::ptrdiff_t>(row * components),
              values.begin() + static_cast<std::ptrdiff_t>((row + 1) * components),
              values.begin() + static_cast<std::ptrdiff_t>(next * components));
    ++next;
  }
  values.resize(next * components);
}

/// Every corner v becomes stands_for[v], and only vertices that stand for themselves and are kept stay.
template <int Dim>
void keep_vertices(MeshSoup<Dim>& soup, const std::vector<bool>& kept,
                   const PerId<VertexId, VertexId>& stands_for) {
  PerId<VertexId, VertexId> new_id(kept.size());
  std::size_t next = 0;
  for (const VertexId v : new_id.ids())
    if (kept[v.index()]) new_id[v] = VertexId::from(next++);
  const auto renumber = [&](VertexId& v) { v = new_id[stands_for[v]]; };
  for (VertexId& v : soup.mesh.corners.links()) renumber(v);
  for (auto& facet : soup.mesh.boundary)
    for (std::size_t i = 0; i < facet.corners.size(); ++i) renumber(facet.corners[i]);
  keep_rows(soup.mesh.points.flat(), kept, 1);
  keep_rows(soup.mesh.vertex_markers.flat(), kept, 1);
  for (PointField& field : soup.point_fields) keep_rows(field.values, kept, field.components);
}

PerId<VertexId, VertexId> every_vertex_itself(std::size_t count) {
  PerId<VertexId, VertexId> itself(count);
  for (const VertexId v : itself.ids()) itself[v] = v;
  return itself;
}

/// The vertex of equal coordinates that comes first.
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

template <int Dim>
void weld_vertices(MeshSoup<Dim>& soup, double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance))
    throw InputError("--weld", "the tolerance is " + mesh::words(tolerance), "give 0 or more");
  const auto stands_for = tolerance == 0 ? first_at_equal_places(soup.mesh.points)
                                         : nearest_within(soup.mesh.points, tolerance);
  std::vector<bool> kept(stands_for.size());
  for (const VertexId v : stands_for.ids()) kept[v.index()] = stands_for[v] == v;
  const auto joined = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  if (joined == 0) return;
  keep_vertices(soup, kept, stands_for);
  soup.warnings.push_back(std::to_string(joined) + " vertices were joined with others " +
                          (tolerance == 0 ? "of equal coordinates"
                                          : "no farther away than " + mesh::words(tolerance)));
}

template <int Dim>
void drop_unused_vertices(MeshSoup<Dim>& soup) {
  std::vector<bool> used(soup.mesh.vertex_count(), false);
  for (const VertexId v : soup.mesh.corners.links()) used[v.index()] = true;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  if (count == 0) return;
  for (std::size_t i = 0; i < soup.mesh.boundary.size(); ++i)
    for (const VertexId v : soup.mesh.boundary[i].corners)
      if (!used[v.index()])
        throw InputError(place_in(soup, soup.facet_lines, i),
                         marked_facet_words(soup.mesh.boundary[i]) + " has vertex " +
                             std::to_string(v.index()) + ", which no cell uses",
                         "remove it, or restore the cells about the vertex");
  keep_vertices(soup, used, every_vertex_itself(used.size()));
  const auto first = static_cast<std::size_t>(std::find(used.begin(), used.end(), false) - used.begin());
  soup.warnings.push_back(std::to_string(count) + (count == 1 ? " vertex" : " vertices") +
                          " that no cell uses " + (count == 1 ? "was" : "were") +
                          " left out, and the others renumbered; the first is number " + std::to_string(first));
}

template void weld_vertices(MeshSoup<2>&, double);
template void weld_vertices(MeshSoup<3>&, double);
template void drop_unused_vertices(MeshSoup<2>&);
template void drop_unused_vertices(MeshSoup<3>&);

}  // namespace leonhard::io
