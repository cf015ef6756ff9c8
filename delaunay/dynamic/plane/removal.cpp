// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

void DynamicTriangulation::remove(VertexId v) {
  require_living(v);
  if (extent() != Extent::plane) {
    line_.erase(points_[v]);
    kill(v);
    return;
  }
  star_.start(triangles_, sides_[v]);
  if (star_surrounds_a_line()) {
    collapse_to_line();
    kill(v);
    return;
  }
  star_.fill(triangles_, points_.flat());
  kill(v);
  const std::span<const AnyTriangleId> all = star_.triangles();
  for (const AnyTriangleId t : all.first(all.size() - 2)) set_sides_of(t);
  last_ = triangles_.corner(all.front(), 1);  // corner 0 may be the ghost
  // The last triangle takes an erased one's number, so the higher number goes first.
  const auto [lower, higher] = std::minmax(all[all.size() - 2], all[all.size() - 1]);
  erase_triangle(higher);
  erase_triangle(lower);
}

void DynamicTriangulation::kill(VertexId v) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  points_[v] = {nan, nan};
  free_.push_back(v);
}

/// Whether all other vertices are collinear. They are neighbours of the star's centre then, and the only
/// ones.
bool DynamicTriangulation::star_surrounds_a_line() const {
  const std::vector<Star::Link>& link = star_.link();
  const std::size_t neighbours = link.size() - (star_.has_ghost() ? 1 : 0);
  if (neighbours != size() - 1) return false;
  const auto at = [&](std::size_t i) { return points_[link[i].from]; };
  for (std::size_t i = 2; i < neighbours; ++i)
    if (kernel::orient2d(at(0), at(1), at(i)) != Sign::zero) return false;
  return true;
}

void DynamicTriangulation::collapse_to_line() {
  for (const auto& [outer, vertex] : star_.link())
    if (vertex != GhostTriangulation::ghost) line_.insert(points_[vertex], vertex);
  triangles_ = {};
}

void DynamicTriangulation::erase_triangle(AnyTriangleId t) {
  triangles_.erase(t);
  if (t.index() < triangles_.triangle_count()) set_sides_of(t);
}

}  // namespace leonhard::delaunay
