// SPDX-License-Identifier: MIT
#include "leonhard/mesh/plane_section.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/topology.hpp"

namespace leonhard::mesh {
namespace {

double along(const Point3& p, SpaceAxis axis) { return axis == SpaceAxis::x ? p.x : axis == SpaceAxis::y ? p.y : p.z; }

Point2 without(const Point3& p, SpaceAxis axis) {
  if (axis == SpaceAxis::x) return {p.y, p.z};
  return axis == SpaceAxis::y ? Point2{p.x, p.z} : Point2{p.x, p.y};
}

/// A plane across an axis, and the vertices on its sides: those in it count as above.
class Plane {
 public:
  Plane(const PerId<VertexId, Point3>& points, SpaceAxis axis, double position)
      : points_(points), axis_(axis), position_(position) {}

  [[nodiscard]] bool is_above(VertexId v) const { return along(points_[v], axis_) >= position_; }

  /// Of an edge with its ends on either side, in any order.
  [[nodiscard]] SectionPoint crossing(VertexId a, VertexId b) const {
    if (b < a) std::swap(a, b);
    const double from = along(points_[a], axis_) - position_, to = along(points_[b], axis_) - position_;
    if (from == 0) return {a, a, 0};
    if (to == 0) return {b, b, 0};
    return {a, b, from / (from - to)};
  }
  [[nodiscard]] Point2 place(const SectionPoint& p) const {
    const Point2 low = without(points_[p.low], axis_), high = without(points_[p.high], axis_);
    return p.low == p.high ? low : low + p.share * (high - low);
  }

 private:
  const PerId<VertexId, Point3>& points_;
  SpaceAxis axis_;
  double position_;
};

/// The corners of a simplex on the two sides.
template <std::size_t count>
struct Sides {
  std::array<VertexId, count> above{}, below{};
  std::size_t n_above = 0, n_below = 0;
  bool is_even = true;  ///< above and then below: an even permutation of the corners

  Sides(const Plane& plane, const std::array<VertexId, count>& corners) {
    for (const VertexId v : corners) {
      const bool up = plane.is_above(v);
      if (up && n_below % 2 == 1) is_even = !is_even;
      (up ? above[n_above++] : below[n_below++]) = v;
    }
  }
  [[nodiscard]] bool are_both() const { return n_above > 0 && n_below > 0; }
};

/// The polygon in which the plane cuts a tetrahedron, each corner once. Of a positive tetrahedron and an even permutation it is
/// clockwise, seen from above.
std::vector<SectionPoint> polygon_of(const Plane& plane, const Sides<4>& sides) {
  std::vector<SectionPoint> polygon;
  const auto add = [&](std::size_t i, std::size_t j) {
    const SectionPoint p = plane.crossing(sides.above[i], sides.below[j]);
    if (std::ranges::find(polygon, p) == polygon.end()) polygon.push_back(p);
  };
  if (sides.n_above == 2) {
    add(0, 0), add(0, 1), add(1, 1), add(1, 0);
  } else {
    for (std::size_t i = 0; i < sides.n_above; ++i)
      for (std::size_t j = 0; j < sides.n_below; ++j) add(i, j);
  }
  return polygon;
}

void require_vertex(const PerId<VertexId, Point3>& points, VertexId v, const std::string& owner) {
  if (!points.contains(v))
    throw InputError("mesh", owner + " names vertex " + std::to_string(v.raw) + ", which is not there",
                     "run mesh::validate on it");
}

}  // namespace

PlaneSection plane_section(const TetMesh& mesh, SpaceAxis axis, double position) {
  const Plane plane(mesh.points, axis, position);
  PlaneSection section;
  std::map<std::pair<VertexId, VertexId>, VertexId> number;
  const auto vertex = [&](const SectionPoint& p) {
    const auto [at, is_new] = number.try_emplace({p.low, p.high});
    if (is_new) {
      at->second = section.vertices.push_back(p);
      section.mesh.points.push_back(plane.place(p));
    }
    return at->second;
  };
  for (const TetId t : mesh.corners.ids()) {
    for (const VertexId v : mesh.corners[t]) require_vertex(mesh.points, v, "tetrahedron " + std::to_string(t.raw));
    const Sides<4> sides(plane, mesh.corners[t]);
    if (!sides.are_both()) continue;
    auto polygon = polygon_of(plane, sides);
    // (x, z) is what one sees from below.
    if (sides.is_even != (axis == SpaceAxis::y)) std::ranges::reverse(polygon);
    for (std::size_t i = 2; i < polygon.size(); ++i)
      section.mesh.corners.push_back({vertex(polygon[0]), vertex(polygon[i - 1]), vertex(polygon[i])});
  }
  section.mesh.vertex_markers.resize(section.mesh.vertex_count());
  section.mesh.regions.resize(section.mesh.triangle_count());
  build_neighbours(section.mesh);
  section.mesh.boundary = boundary_facets(section.mesh);
  return section;
}

std::vector<SectionSegment> plane_section(const PerId<VertexId, Point3>& points,
                                          std::span<const std::array<VertexId, 3>> triangles, SpaceAxis axis, double position) {
  const Plane plane(points, axis, position);
  std::vector<SectionSegment> segments;
  for (const auto& triangle : triangles) {
    for (const VertexId v : triangle) require_vertex(points, v, "a triangle");
    const Sides<3> sides(plane, triangle);
    if (!sides.are_both()) continue;
    const SectionPoint one = plane.crossing(sides.above[0], sides.below[0]),
                       other = sides.n_above == 2 ? plane.crossing(sides.above[1], sides.below[0])
                                                  : plane.crossing(sides.above[0], sides.below[1]);
    if (!(one == other)) segments.push_back({one, other});
  }
  return segments;
}

}  // namespace leonhard::mesh
