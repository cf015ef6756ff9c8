// SPDX-License-Identifier: MIT
// What is where in a DynamicTriangulation: counts, the triangles at a vertex, the hull, a vertex's Voronoi cell.
#include <algorithm>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/plane/circumcentre.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

/// In the plane: how many vertices the hull's boundary has.
std::size_t DynamicTriangulation::hull_size() const {
  std::size_t count = 0;
  SideId side = ghost_side_;
  do {
    ++count;
    side = triangles_.turn_about_origin(side);
  } while (side != ghost_side_);
  return count;
}

std::size_t DynamicTriangulation::triangle_count() const {
  return extent() == Extent::plane ? triangles_.triangle_count() - hull_size() : 0;
}

/// Triangles and the ghosts have three sides each, two an edge; the ghost's edges do not count.
std::size_t DynamicTriangulation::edge_count() const {
  if (extent() != Extent::plane) return size() < 2 ? 0 : size() - 1;
  return 3 * triangles_.triangle_count() / 2 - hull_size();
}

std::vector<VertexTriple> DynamicTriangulation::triangles_at(VertexId v) const {
  require_living(v);
  std::vector<VertexTriple> all;
  if (extent() != Extent::plane) return all;
  const SideId first = first_side_within(v);
  SideId side = first;
  do {
    if (!triangles_.is_ghost(triangles_.triangle(side)))
      all.push_back({v, triangles_.destination(side), triangles_.apex(side)});
    side = triangles_.turn_about_origin(side);
  } while (side != first);
  return all;
}

bool DynamicTriangulation::on_hull(VertexId v) const {
  require_living(v);
  if (extent() != Extent::plane) return true;
  return triangles_.is_ghost(triangles_.triangle(triangles_.twin(first_side_within(v))));
}

/// A side from v: of a vertex on the hull the one with the outside on its right, of any other the one that is known.
SideId DynamicTriangulation::first_side_within(VertexId v) const {
  SideId side = sides_[v];
  do {
    if (triangles_.is_ghost(triangles_.triangle(triangles_.twin(side))) &&
        !triangles_.is_ghost(triangles_.triangle(side)))
      return side;
    side = triangles_.turn_about_origin(side);
  } while (side != sides_[v]);
  return side;
}

std::vector<VertexId> DynamicTriangulation::hull() const {
  std::vector<VertexId> loop;
  if (extent() != Extent::plane) {
    for (const auto& [point, vertex] : line_) loop.push_back(vertex);
    return loop;
  }
  // Sides turn counter-clockwise about the ghost, which looks at the hull from behind.
  SideId side = ghost_side_;
  do {
    loop.push_back(triangles_.destination(side));
    side = triangles_.turn_about_origin(side);
  } while (side != ghost_side_);
  std::reverse(loop.begin(), loop.end());
  const auto before = [&](VertexId a, VertexId b) { return points_[a] < points_[b]; };
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), before), loop.end());
  return loop;
}

// ---- the Voronoi cell ----

/// Whether the two real triangles at an edge have one circumcircle.
bool DynamicTriangulation::has_one_circle(SideId side) const {
  const Point2 across = points_[triangles_.apex(triangles_.twin(side))];
  return kernel::incircle(points_[triangles_.origin(side)], points_[triangles_.destination(side)],
                          points_[triangles_.apex(side)], across) == Sign::zero;
}

VoronoiCell DynamicTriangulation::voronoi_cell(VertexId v) const {
  require_living(v);
  VoronoiCell cell;
  if (extent() != Extent::plane) {
    for (const VertexId w : neighbours(v)) cell.across.push_back(w);
    return cell;
  }
  const auto centre = [&](AnyTriangleId t) {
    return rounded_circumcentre({points_[triangles_.corner(t, 0)], points_[triangles_.corner(t, 1)],
                                 points_[triangles_.corner(t, 2)]});
  };
  const auto merge = [](VoronoiCorner<Point2>& known, const VoronoiCorner<Point2>& same) {
    if (same.error < known.error) known = same;
  };
  const auto outwards = [&](VertexId from, VertexId to) {  // of an edge of the hull, counter-clockwise
    const Vec2 along = towards(points_[from], points_[to]);
    return unit({along.y, -along.x});
  };
  // On the way about v a triangle adds a corner, and the edge before it the side that ends there.
  const SideId first = first_side_within(v);
  SideId side = first;
  do {
    const AnyTriangleId before = triangles_.triangle(triangles_.twin(side)), t = triangles_.triangle(side);
    const VertexId w = triangles_.destination(side);
    const bool begins_outside = triangles_.is_ghost(before), ends_outside = triangles_.is_ghost(t);
    const SideId here = side;
    side = triangles_.turn_about_origin(side);
    if (begins_outside && ends_outside) continue;  // the side to the ghost
    if (begins_outside) cell.rays.push_back(outwards(v, w));
    if (ends_outside) {
      cell.rays.push_back(outwards(w, v));
      cell.across.push_back(w);
    } else if (!begins_outside && !cell.corners.empty() && has_one_circle(here)) {
      merge(cell.corners.back(), centre(t));
    } else {
      cell.corners.push_back(centre(t));
      cell.across.push_back(w);
    }
  } while (side != first);
  // All around an inner vertex the first side, too, may have no length.
  if (cell.rays.empty() && has_one_circle(first)) {
    merge(cell.corners.back(), cell.corners.front());
    cell.corners.erase(cell.corners.begin());
    cell.across.erase(cell.across.begin());
  }
  return cell;
}

}  // namespace leonhard::delaunay
