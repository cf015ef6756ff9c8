// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/tet_circumcentre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Vec3 scaled(const Vec3& v, int exponent) {
  return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

/// Half of b - a.
Vec3 half_way(const Point3& a, const Point3& b) {
  return {0.5 * b.x - 0.5 * a.x, 0.5 * b.y - 0.5 * a.y, 0.5 * b.z - 0.5 * a.z};
}

/// u x v for vectors scaled so that the longer one is about 1; its length compares the areas of a tetrahedron's faces.
Vec3 scaled_cross(const Vec3& u, const Vec3& v, double length) {
  const int exponent = length > 0 ? -std::ilogb(length) : 0;
  return cross(scaled(u, exponent), scaled(v, exponent));
}

/// A point at the end of the doubles' range where the circumcentre of a very flat tetrahedron lies beyond it: over its
/// largest face, away from the tetrahedron.
Point3 far_point(const std::array<Point3, 4>& corners) {
  double length = 0;
  for (const auto& [a, b] : tet_edge_corners)
    length = std::max(length, largest(half_way(corners[a], corners[b])));
  Vec3 normal{};
  for (const auto& [a, b, c] : tet_face_corners) {
    const Vec3 face =
        scaled_cross(half_way(corners[a], corners[b]), half_way(corners[a], corners[c]), length);
    if (norm(face) > norm(normal)) normal = face;
  }
  if (norm(normal) == 0) normal = {1, 0, 0};
  const Vec3 out = 1 / norm(normal) * normal;
  constexpr double end = std::numeric_limits<double>::max();
  return {end * out.x, end * out.y, end * out.z};
}

}  // namespace

Vec3 unit_normal(const Point3& a, const Point3& b, const Point3& c) {
  const Vec3 u = half_way(a, b), v = half_way(a, c);
  const Vec3 normal = scaled_cross(u, v, std::max(largest(u), largest(v)));
  const double length = largest(normal);
  if (!(length > 0)) return {};
  const Vec3 near_one = scaled(normal, -std::ilogb(length));
  return 1 / norm(near_one) * near_one;
}

VoronoiCorner<Point3> rounded_circumcentre(const std::array<Point3, 4>& corners) {
  try {
    const kernel::Sphere sphere = kernel::circumsphere(corners[0], corners[1], corners[2], corners[3]);
    return {sphere.centre, sphere.centre_error};
  } catch (const InputError&) {  // a tetrahedron has a sphere, but its centre is no triple of doubles
    return {far_point(corners), std::numeric_limits<double>::infinity()};
  }
}

}  // namespace leonhard::delaunay
