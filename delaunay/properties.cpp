// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "leonhard/delaunay/plane/exact_triangle.hpp"
#include "leonhard/delaunay/topology/interior_edges.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

using mesh::words;

exact::Triangle triangle(const TriangleMesh& mesh, VertexId a, VertexId b, VertexId c) {
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}
exact::Triangle triangle(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  return triangle(mesh, a, b, c);
}

/// Does the other diagonal, right to left, give two triangles as well?
bool is_strictly_convex(const TriangleMesh& mesh, const TrianglePair& pair) {
  const Point2 left = mesh.points[pair.left], right = mesh.points[pair.right];
  return kernel::orient2d(right, left, mesh.points[pair.from]) == Sign::positive &&
         kernel::orient2d(left, right, mesh.points[pair.to]) == Sign::positive;
}

void require_same_points(const TriangleMesh& mesh, const TriangleMesh& other) {
  mesh::require_corners_in_range(mesh);
  mesh::require_corners_in_range(other);
  if (mesh.points == other.points) return;
  throw InputError("other", "its points are not those of the mesh in the same order",
                   "compare triangulations of one list of points");
}

void require_values(const TriangleMesh& mesh, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw InputError("values", "value " + std::to_string(i) + " is " + words(values[i]),
                       "give finite numbers");
  if (values.size() == mesh.vertex_count()) return;
  throw InputError("values",
                   "there are " + std::to_string(values.size()) + " for " +
                       std::to_string(mesh.vertex_count()) + " vertices",
                   "give one a vertex");
}

/// The triangle with the greatest figure, the first one of equals, and the figure.
struct Greatest {
  TriangleId triangle;
  mpq_class figure;
};
template <class Figure>
Greatest greatest(const TriangleMesh& mesh, const Figure& figure) {
  Greatest best{TriangleId{0}, figure(triangle(mesh, TriangleId{0}))};
  for (const TriangleId t : mesh.corners.ids()) {
    mpq_class candidate = figure(triangle(mesh, t));
    if (candidate > best.figure) best = {t, std::move(candidate)};
  }
  return best;
}

double degrees_of_cotangent(const mpq_class& cotangent) {
  return std::atan2(1.0, cotangent.get_d()) * 180 / std::numbers::pi;
}

mpq_class pair_roughness(const TriangleMesh& mesh, std::span<const double> values,
                         const std::array<std::array<VertexId, 3>, 2>& triangles) {
  mpq_class sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum +=
        exact::roughness(triangle(mesh, a, b, c), {values[a.index()], values[b.index()], values[c.index()]});
  return sum;
}

/// Sum of the terms [begin, end), by halves so that long denominators meet late.
mpq_class sum(std::span<const mpq_class> terms) {
  if (terms.empty()) return 0;
  if (terms.size() == 1) return terms[0];
  const std::size_t half = terms.size() / 2;
  return sum(terms.first(half)) + sum(terms.subspan(half));
}

}  // namespace

std::optional<std::string> first_tie(const TriangleMesh& mesh) {
  const auto& points = mesh.points;
  return first_of_interior_edges(mesh, [&](const TrianglePair& pair) -> std::optional<std::string> {
    if (kernel::incircle(points[pair.from], points[pair.to], points[pair.left], points[pair.right]) !=
        Sign::zero)
      return std::nullopt;
    return words(mesh, pair.right) + " lies on the circumcircle of " + words(mesh, pair.left_triangle);
  });
}

std::optional<std::string> validate_uniqueness(const TriangleMesh& mesh) {
  const auto& points = mesh.points;
  return first_of_interior_edges(mesh, [&](const TrianglePair& pair) -> std::optional<std::string> {
    const Point2 from = points[pair.from], to = points[pair.to], left = points[pair.left],
                 right = points[pair.right];
    if (kernel::incircle_perturbed(from, to, left, right) != Sign::positive) return std::nullopt;
    const bool is_tie = kernel::incircle(from, to, left, right) == Sign::zero;
    return words(mesh, pair.from, pair.to) +
           " is not the diagonal that belongs to the one triangulation: " + words(mesh, pair.right) +
           " lies " +
           (is_tie ? "on the circumcircle, and after perturbation inside that," : "inside the circumcircle") +
           " of " + words(mesh, pair.left_triangle);
  });
}

std::optional<std::string> validate_circumcircles(const TriangleMesh& mesh) {
  mesh::require_corners_in_range(mesh);
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = triangle(mesh, t);
    for (const VertexId v : mesh.points.ids())
      if (kernel::incircle(a, b, c, mesh.points[v]) == Sign::positive)
        return words(mesh, v) + " lies inside the circumcircle of " + words(mesh, t);
  }
  return std::nullopt;
}

std::optional<std::string> validate_equiangularity(const TriangleMesh& mesh) {
  return first_of_interior_edges(mesh, [&](const TrianglePair& pair) -> std::optional<std::string> {
    if (!is_strictly_convex(mesh, pair)) return std::nullopt;
    const auto& [from, to, left, right, t, u] = pair;
    const auto least_angle = [&](const exact::Triangle& one, const exact::Triangle& two) {
      return std::max(exact::cotangent_of_min_angle(one), exact::cotangent_of_min_angle(two));
    };
    const mpq_class here = least_angle(triangle(mesh, t), triangle(mesh, u)),
                    swapped = least_angle(triangle(mesh, right, left, from), triangle(mesh, left, right, to));
    if (here <= swapped) return std::nullopt;
    return words(mesh, from, to) + " has an angle of " + words(degrees_of_cotangent(here)) +
           " degrees beside it, the other diagonal of its two triangles, " + words(mesh, left, right) +
           ", would have none below " + words(degrees_of_cotangent(swapped));
  });
}

std::optional<std::string> validate_min_angle(const TriangleMesh& mesh, const TriangleMesh& other) {
  require_same_points(mesh, other);
  if (mesh.corners.empty() || other.corners.empty()) return std::nullopt;
  const Greatest here = greatest(mesh, exact::cotangent_of_min_angle);
  const Greatest there = greatest(other, exact::cotangent_of_min_angle);
  if (here.figure <= there.figure) return std::nullopt;
  return words(mesh, here.triangle) + " has an angle of " + words(degrees_of_cotangent(here.figure)) +
         " degrees, the other triangulation none below " + words(degrees_of_cotangent(there.figure));
}

std::optional<std::string> validate_containment_circles(const TriangleMesh& mesh, const TriangleMesh& other) {
  require_same_points(mesh, other);
  if (mesh.corners.empty() || other.corners.empty()) return std::nullopt;
  const Greatest here = greatest(mesh, exact::squared_containment_radius);
  const Greatest there = greatest(other, exact::squared_containment_radius);
  if (here.figure <= there.figure) return std::nullopt;
  return words(mesh, here.triangle) + " needs a circle of radius " + words(std::sqrt(here.figure.get_d())) +
         " to contain it, no triangle of the other triangulation one beyond " +
         words(std::sqrt(there.figure.get_d()));
}

mpq_class roughness(const TriangleMesh& mesh, std::span<const double> values) {
  mesh::require_corners_in_range(mesh);
  require_values(mesh, values);
  std::vector<mpq_class> terms;
  terms.reserve(mesh.triangle_count());
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    terms.push_back(
        exact::roughness(triangle(mesh, t), {values[a.index()], values[b.index()], values[c.index()]}));
  }
  return sum(terms);
}

std::optional<std::string> validate_roughness(const TriangleMesh& mesh, std::span<const double> values) {
  require_values(mesh, values);
  return first_of_interior_edges(mesh, [&](const TrianglePair& pair) -> std::optional<std::string> {
    if (!is_strictly_convex(mesh, pair)) return std::nullopt;
    const auto& [from, to, left, right, t, u] = pair;
    const mpq_class here = pair_roughness(mesh, values, {{{from, to, left}, {to, from, right}}}),
                    swapped = pair_roughness(mesh, values, {{{right, left, from}, {left, right, to}}});
    if (here <= swapped) return std::nullopt;
    return "the two triangles at " + words(mesh, from, to) + " have roughness " + words(here.get_d()) +
           ", with their other diagonal, " + words(mesh, left, right) + ", " + words(swapped.get_d());
  });
}

std::optional<std::string> validate_roughness(const TriangleMesh& mesh, const TriangleMesh& other,
                                              std::span<const double> values) {
  require_same_points(mesh, other);
  const mpq_class here = roughness(mesh, values), there = roughness(other, values);
  if (here <= there) return std::nullopt;
  std::string problem =
      "the roughness is " + words(here.get_d()) + ", that of the other triangulation " + words(there.get_d());
  if (const auto pair = validate_roughness(mesh, values)) problem += "; " + *pair;
  return problem;
}

}  // namespace leonhard::delaunay
