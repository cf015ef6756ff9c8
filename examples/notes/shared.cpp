// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>

#include "figures.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::notes {

std::vector<Point2> random_sites(std::size_t count, std::uint64_t seed, double apart) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point2> sites;
  while (sites.size() < count) {
    const double x = unit(random), y = unit(random);
    const bool clear = std::all_of(sites.begin(), sites.end(), [&](Point2 p) {
      return distance(p, {x, y}) > apart;
    });
    if (clear) sites.push_back({x, y});
  }
  return sites;
}

draw::Diagram diagram_of(const TriangleMesh& mesh, const std::string& title, const draw::Stroke& stroke) {
  draw::Diagram diagram;
  diagram.title = title;
  diagram.add_mesh(mesh, stroke);
  for (const Point2 p : mesh.points) diagram.dots.push_back({p});
  return diagram;
}

VertexId vertex_at(const TriangleMesh& mesh, Point2 p) {
  return VertexId::from(
      static_cast<std::size_t>(std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin()));
}

std::array<Point2, 3> corners(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

TriangleId triangle_at(const TriangleMesh& mesh, Point2 p) {
  for (const TriangleId t : mesh.corners.ids()) {
    const auto [a, b, c] = corners(mesh, t);
    if (kernel::orient2d(a, b, p) != Sign::negative && kernel::orient2d(b, c, p) != Sign::negative &&
        kernel::orient2d(c, a, p) != Sign::negative)
      return t;
  }
  return TriangleId{0};
}

VertexId apex(const TriangleMesh& mesh, TriangleId t, VertexId a, VertexId b) {
  const auto& all = mesh.corners[t];
  return *std::find_if(all.begin(), all.end(), [&](VertexId v) { return v != a && v != b; });
}

Point2 centroid(std::span<const Point2> points) {
  Vec2 sum;
  for (const Point2 p : points) sum = sum + (p - points[0]);
  return points[0] + 1 / static_cast<double>(points.size()) * sum;
}

}  // namespace leonhard::notes
