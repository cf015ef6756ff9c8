// SPDX-License-Identifier: MIT
// The mesh about an airfoil of three elements, on which the figures of sections 2.2 and 2.3 stand.
#include "flap_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/delaunay/refine.hpp"

namespace leonhard::notes {
namespace {

/// A closed curve of NACA's four-digit thickness, turned and moved, as a loop of segments with its hole.
void add_element(Pslg& pslg, Point2 nose, double chord, double angle_deg, double thickness) {
  constexpr int half = 24;
  const double angle = angle_deg * std::numbers::pi / 180;
  const std::size_t first = pslg.points.size();
  const auto place = [&](double x, double y) {
    return Point2{nose.x + chord * (x * std::cos(angle) - y * std::sin(angle)),
                  nose.y + chord * (x * std::sin(angle) + y * std::cos(angle))};
  };
  for (int i = 0; i < 2 * half; ++i) {
    const double x = 0.5 * (1 + std::cos(std::numbers::pi * i / half));
    const double t =
        5 * thickness *
        (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
    pslg.points.push_back(place(x, i <= half ? t : -t));
  }
  for (std::size_t i = first; i < pslg.points.size(); ++i)
    pslg.segments.push_back({i, i + 1 < pslg.points.size() ? i + 1 : first, 1});
  pslg.holes.push_back(place(0.4, 0));
}

TriangleMesh multi_component_mesh() {
  Pslg pslg;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    pslg.points.push_back({0.6 + 4 * std::cos(angle), 4 * std::sin(angle)});
    pslg.segments.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>((i + 1) % 40), 2});
  }
  add_element(pslg, {-0.21, -0.13}, 0.22, 30, 0.16);
  add_element(pslg, {0.03, -0.02}, 0.85, 0, 0.14);
  add_element(pslg, {0.86, -0.05}, 0.34, -32, 0.14);
  const auto size = [](Point2 p) { return 0.025 + 0.12 * std::max(0.0, distance(p, {0.45, -0.05}) - 0.6); };
  return delaunay::mesh_pslg(pslg, {.min_angle_deg = 28, .size = size}).mesh;
}

}  // namespace

const TriangleMesh& flap_mesh() {
  static const TriangleMesh mesh = multi_component_mesh();
  return mesh;
}

}  // namespace leonhard::notes
