// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/structures/boundary_sides.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

std::array<Point3, 4> corner_points(const TetMesh& mesh, TetId t) {
  const auto& [a, b, c, d] = mesh.corners[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]};
}

/// The number of faces of t behind which o lies strictly, if no face has it strictly in front; else none.
std::optional<int> faces_before(const TetMesh& mesh, TetId t, const Point3& o) {
  const std::array<Point3, 4> p = corner_points(mesh, t);
  int strictly = 0;
  for (const auto& [i, j, k] : tet_face_corners) {
    const Sign side = kernel::orient3d(p[i], p[j], p[k], o);
    if (side == Sign::positive) return std::nullopt;
    if (side == Sign::negative) ++strictly;
  }
  return strictly;
}

Point3 rounded_centroid(const std::array<Point3, 4>& p) {
  const auto mean = [&](double Point3::*x) {
    return 0.25 * p[0].*x + 0.25 * p[1].*x + 0.25 * p[2].*x + 0.25 * p[3].*x;
  };
  return {mean(&Point3::x), mean(&Point3::y), mean(&Point3::z)};
}

/// A place strictly inside one tetrahedron, which is among the largest if that one holds its rounded centroid.
struct PlaceWithin {
  Point3 o;
  TetId tet;
};
std::optional<PlaceWithin> inner_place(const TetMesh& mesh) {
  const auto volume6 = [&](TetId t) {
    const auto [a, b, c, d] = corner_points(mesh, t);
    return dot(cross(b - a, c - a), d - a);
  };
  std::optional<PlaceWithin> place;
  double largest = 0;
  for (const TetId t : mesh.corners.ids()) {
    const double volume = volume6(t);
    if (place && !(volume > largest)) continue;
    const Point3 o = rounded_centroid(corner_points(mesh, t));
    if (faces_before(mesh, t, o) != 4) continue;
    place = {o, t};
    largest = volume;
  }
  return place;
}

bool boxed(const std::array<Point3, 4>& p, const Point3& o) {
  const auto within = [&](double Point3::*x) {
    const auto [low, high] = std::minmax({p[0].*x, p[1].*x, p[2].*x, p[3].*x});
    return low <= o.*x && o.*x <= high;
  };
  return within(&Point3::x) && within(&Point3::y) && within(&Point3::z);
}

/// Another tetrahedron that holds the place, in words.
std::optional<std::string> covered_twice(const TetMesh& mesh, const PlaceWithin& place) {
  for (const TetId t : mesh.corners.ids()) {
    if (t == place.tet || !boxed(corner_points(mesh, t), place.o)) continue;
    if (faces_before(mesh, t, place.o))
      return words(mesh, t) + " and " + words(mesh, place.tet) + " overlap at " + words(place.o);
  }
  return std::nullopt;
}

std::optional<std::string> face_not_seen_from(const TetMesh& mesh, const PlaceWithin& place) {
  for (const MarkedFace& face : mesh.boundary) {
    const auto& [a, b, c] = face.corners;
    if (kernel::orient3d(mesh.points[a], mesh.points[b], mesh.points[c], place.o) != Sign::negative) {
      return "the boundary is not convex: " + words(place.o) + ", inside " + words(mesh, place.tet) +
             ", does not lie behind boundary " + words(mesh, face.corners);
    }
  }
  return std::nullopt;
}

/// An edge of the boundary that is reflex, in words. The boundary is the surface of a star-shaped set, so each edge has
/// two faces.
std::optional<std::string> reflex_edge(const TetMesh& mesh) {
  const auto sides = boundary_sides(mesh);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const auto& [a, b, c] = mesh.boundary[sides[i].face].corners;
    const VertexId beyond = sides[i + 1].apex;
    if (kernel::orient3d(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[beyond]) ==
        Sign::positive) {
      return "the boundary is not convex: at " + words(mesh, sides[i].low, sides[i].high) + " the face to " +
             words(mesh, beyond) + " rises above " + words(mesh, {a, b, c});
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> validate_convex(const TetMesh& mesh) {
  if (mesh.corners.empty()) return std::nullopt;
  const auto place = inner_place(mesh);
  if (!place) return "no place found that lies strictly inside a tetrahedron: all are too thin";
  if (auto problem = covered_twice(mesh, *place)) return problem;
  if (auto problem = face_not_seen_from(mesh, *place)) return problem;
  return reflex_edge(mesh);
}

}  // namespace leonhard::mesh
