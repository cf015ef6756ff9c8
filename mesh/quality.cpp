// SPDX-License-Identifier: MIT
#include "leonhard/mesh/quality.hpp"
#include "leonhard/mesh/ids_in_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace leonhard::mesh {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// Angles of one triangle in degrees, at each corner.
struct Angles {
  std::array<double, 3> at;
};

/// A triangle's sides as vectors, side[i] from corner i + 1 to corner i + 2, divided by scale * unit so that the
/// largest component is 1. Two factors, because a side may be longer than the largest double.
struct ScaledSides {
  std::array<Vec2, 3> side;
  double scale, unit;
};

ScaledSides scaled_sides(const std::array<Point2, 3>& p) {
  // A quarter of each coordinate first: the difference of two finite numbers may overflow.
  const auto quarter = [](Point2 q) { return Point2{0.25 * q.x, 0.25 * q.y}; };
  const bool large = std::any_of(p.begin(), p.end(), [](Point2 q) {
    return std::max(std::abs(q.x), std::abs(q.y)) > 0.25 * std::numeric_limits<double>::max();
  });
  ScaledSides s{};
  s.scale = 0;
  s.unit = large ? 4 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 from = p[(i + 1) % 3], to = p[(i + 2) % 3];
    s.side[i] = large ? quarter(to) - quarter(from) : to - from;
    s.scale = std::max({s.scale, std::abs(s.side[i].x), std::abs(s.side[i].y)});
  }
  if (s.scale > 0) {
    for (Vec2& v : s.side) v = {v.x / s.scale, v.y / s.scale};
  }
  return s;
}

Angles angles_of(const ScaledSides& s) {
  Angles angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 u = -s.side[(i + 1) % 3], v = s.side[(i + 2) % 3];  // u, v: from corner i to i + 2 and i + 1
    angles.at[i] = degrees * std::atan2(std::max(0.0, cross(v, u)), dot(u, v));
  }
  return angles;
}

TriangleQuality figures_of(const ScaledSides& s, const Angles& angles) {
  const double a = norm(s.side[0]), b = norm(s.side[1]), c = norm(s.side[2]);
  const double half_cross = 0.5 * std::max(0.0, cross(s.side[0], s.side[1]));  // the scaled area
  const double circumradius = a * b * c / (4 * half_cross);
  const double inradius = 2 * half_cross / (a + b + c);
  TriangleQuality q;
  q.min_angle_deg = *std::min_element(angles.at.begin(), angles.at.end());
  q.max_angle_deg = *std::max_element(angles.at.begin(), angles.at.end());
  q.area = half_cross * s.scale * s.unit * s.scale * s.unit;
  q.aspect_ratio = circumradius / (2 * inradius);
  q.radius_edge_ratio = circumradius / std::min({a, b, c});
  return q;
}

std::array<Point2, 3> corner_points(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

Point2 centroid(const std::array<Point2, 3>& p) {
  return {p[0].x / 3 + p[1].x / 3 + p[2].x / 3, p[0].y / 3 + p[1].y / 3 + p[2].y / 3};
}

/// The `count` triangles of smallest angle, the smallest first, ties by id.
std::vector<MeshQuality::Named> worst_triangles(const TriangleMesh& mesh,
                                                const PerId<TriangleId, TriangleQuality>& figures,
                                                std::size_t count) {
  std::vector<TriangleId> ids(figures.ids().begin(), figures.ids().end());
  const auto middle = ids.begin() + static_cast<std::ptrdiff_t>(std::min(count, ids.size()));
  std::partial_sort(ids.begin(), middle, ids.end(), [&](TriangleId s, TriangleId t) {
    const double a = figures[s].min_angle_deg, b = figures[t].min_angle_deg;
    return a != b ? a < b : s < t;
  });
  std::vector<MeshQuality::Named> worst;
  for (auto at = ids.begin(); at != middle; ++at) {
    worst.push_back({*at, centroid(corner_points(mesh, *at)), figures[*at]});
  }
  return worst;
}

/// Largest growth of size across an edge, each pair seen once.
void find_growth(const TriangleMesh& mesh, const PerId<TriangleId, TriangleQuality>& figures,
                 MeshQuality& q) {
  q.max_size_growth = 1;
  for (const TriangleId t : mesh.neighbours.ids()) {
    for (const MaybeId<TriangleId> neighbour : mesh.neighbours[t]) {
      if (!neighbour || *neighbour < t) continue;
      const bool t_is_smaller = figures[t].area <= figures[*neighbour].area;
      const TriangleId small = t_is_smaller ? t : *neighbour, large = t_is_smaller ? *neighbour : t;
      const double growth = std::sqrt(figures[large].area / figures[small].area);
      if (growth > q.max_size_growth) {
        q.max_size_growth = growth;
        q.fastest_growth = {small, large};
      }
    }
  }
}

}  // namespace

TriangleQuality triangle_quality(Point2 a, Point2 b, Point2 c) {
  const ScaledSides sides = scaled_sides({a, b, c});
  return figures_of(sides, angles_of(sides));
}

MeshQuality quality(const TriangleMesh& mesh, std::size_t worst_count) {
  require_ids_in_range(mesh);
  MeshQuality q;
  if (mesh.corners.empty()) return q;
  q.min_angle_deg = 180;
  q.min_area = std::numeric_limits<double>::infinity();

  PerId<TriangleId, TriangleQuality> figures(mesh.triangle_count());
  for (const TriangleId t : mesh.corners.ids()) {
    const ScaledSides sides = scaled_sides(corner_points(mesh, t));
    const Angles angles = angles_of(sides);
    for (const double angle : angles.at) {
      ++q.angle_histogram[std::min<std::size_t>(static_cast<std::size_t>(angle / 10),
                                                q.angle_histogram.size() - 1)];
    }
    const TriangleQuality& f = figures[t] = figures_of(sides, angles);
    q.min_angle_deg = std::min(q.min_angle_deg, f.min_angle_deg);
    q.max_angle_deg = std::max(q.max_angle_deg, f.max_angle_deg);
    q.mean_min_angle_deg += f.min_angle_deg;
    q.min_area = std::min(q.min_area, f.area);
    q.max_area = std::max(q.max_area, f.area);
    q.total_area += f.area;
    q.max_aspect_ratio = std::max(q.max_aspect_ratio, f.aspect_ratio);
    q.max_radius_edge_ratio = std::max(q.max_radius_edge_ratio, f.radius_edge_ratio);
  }
  const auto count = static_cast<double>(mesh.triangle_count());
  q.mean_min_angle_deg /= count;
  q.mean_area = q.total_area / count;
  find_growth(mesh, figures, q);
  q.worst = worst_triangles(mesh, figures, worst_count);
  return q;
}

}  // namespace leonhard::mesh
