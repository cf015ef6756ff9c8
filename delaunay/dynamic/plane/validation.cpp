// SPDX-License-Identifier: MIT
#include <algorithm>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/topology/conflict.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

std::string vertex_words(std::span<const Point2> points, VertexId v) {
  std::string text = "vertex " + std::to_string(v.raw);
  if (v.index() < points.size()) text += " at " + mesh::words(points[v.index()]);
  return text;
}

std::string triangle_words(AnyTriangleId t) { return "triangle " + std::to_string(t.raw); }

}  // namespace

std::optional<std::string> DynamicTriangulation::validate() const {
  if (auto problem = broken_id()) return problem;
  if (auto problem = broken_line()) return problem;
  if (extent() != Extent::plane) return std::nullopt;
  if (auto problem = broken_topology()) return problem;
  if (auto problem = broken_ring()) return problem;
  return broken_geometry();
}

/// The removed ids are those without coordinates, each once.
std::optional<std::string> DynamicTriangulation::broken_id() const {
  if (sides_.size() != points_.size()) return "there is not one side a vertex id";
  std::vector<VertexId> removed = free_, without_place;
  std::sort(removed.begin(), removed.end());
  for (const VertexId v : points_.ids())
    if (!is_finite(points_[v])) without_place.push_back(v);
  if (removed != without_place) return "the removed ids are not those of vertices without coordinates";
  return std::nullopt;
}

std::optional<std::string> DynamicTriangulation::broken_line() const {
  if (line_.size() != (extent() == Extent::plane ? 0 : size()))
    return std::to_string(line_.size()) + " of " + std::to_string(size()) + " vertices are on the line";
  for (const auto& [place, v] : line_) {
    if (!contains(v) || points_[v] != place)
      return vertex_words(points_.flat(), v) + " is on the line at " + mesh::words(place);
    if (!line_.collinear_with(place)) return vertex_words(points_.flat(), v) + " is off the line";
  }
  return std::nullopt;
}

std::optional<std::string> DynamicTriangulation::broken_topology() const {
  if (auto problem = triangles_.validate()) return problem;
  if (triangles_.triangle_count() != 2 * size() - 2)
    return std::to_string(triangles_.triangle_count()) + " triangles, ghosts included, for " +
           std::to_string(size()) + " vertices: not 2 n - 2";
  for (std::size_t i = 0; i < triangles_.triangle_count(); ++i)
    for (unsigned k = 0; k < 3; ++k) {
      const VertexId v = triangles_.corner(AnyTriangleId::from(i), k);
      if (v != GhostTriangulation::ghost && !contains(v))
        return triangle_words(AnyTriangleId::from(i)) + " has a removed vertex, " + std::to_string(v.raw);
    }
  return std::nullopt;
}

/// Every vertex, the ghost too, has a side of its own, and the rings about them have every corner of every
/// triangle.
std::optional<std::string> DynamicTriangulation::broken_ring() const {
  std::size_t corners = 0;
  const auto add_ring = [&](VertexId v, SideId first) {
    if (GhostTriangulation::slot(first) >= 3 * triangles_.triangle_count() || triangles_.origin(first) != v)
      return false;
    SideId side = first;
    do {
      ++corners;
      side = triangles_.turn_about_origin(side);
    } while (side != first);
    return true;
  };
  for (const VertexId v : vertices())
    if (!add_ring(v, sides_[v]))
      return vertex_words(points_.flat(), v) + " has another vertex's side, " +
             GhostTriangulation::name(sides_[v]);
  if (!add_ring(GhostTriangulation::ghost, ghost_side_)) return "the ghost has another vertex's side";
  if (corners != 3 * triangles_.triangle_count()) return "a vertex has two rings of triangles";
  if (!contains(last_))
    return "the vertex that searches start from, " + std::to_string(last_.raw) + ", is removed";
  return std::nullopt;
}

std::optional<std::string> DynamicTriangulation::broken_geometry() const {
  const auto at = [&](AnyTriangleId t, unsigned i) { return points_[triangles_.corner(t, i)]; };
  for (std::size_t i = 0; i < triangles_.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    if (!triangles_.is_ghost(t) && kernel::orient2d(at(t, 0), at(t, 1), at(t, 2)) != Sign::positive)
      return triangle_words(t) + " is not counter-clockwise";
  }
  for (std::size_t i = 0; i < triangles_.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    for (unsigned k = 0; k < 3; ++k) {
      const VertexId behind = triangles_.apex(triangles_.twin(triangles_.side(t, k)));
      if (behind == GhostTriangulation::ghost) continue;
      if (in_conflict(triangles_, points_.flat(), t, points_[behind]))
        return vertex_words(points_.flat(), behind) + " is in the circle of " + triangle_words(t) +
               " next to it";
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::delaunay
