// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <variant>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

/// Which of the two diagonals of a strictly convex quadrilateral an edge swapping algorithm is to keep
/// (Barth's notes 3.3b and 3.3d).
///
/// A criterion is a value with
///   improves(in, points, s)  would swapping the edge of side s make the triangulation better? The edge lies
///                            between two real triangles that form a strictly convex quadrilateral
///   implies_convex           improves() is false anyway where the quadrilateral is not strictly convex
///   looks_around             whether that depends on the triangles next to the two as well: then a swap
///                            makes the edges of these suspect again too
/// Each has an objective, a number or a sorted list of numbers, that every swap for which improves() is true
/// makes strictly better as it stands, whatever the rounding on the way. There are finitely many
/// triangulations of a point set, so swapping ends. It ends in a triangulation that no single swap improves;
/// only for the Delaunay criterion is that known to be the best of all (and for minimal roughness, which it
/// then is too, Rippa 1990).
namespace leonhard::delaunay::criterion {

/// Ends in the Delaunay triangulation, with ties decided as everywhere: kernel::incircle_perturbed. Exact.
/// Objective: the surface over the points, lifted to the (perturbed) paraboloid, gets lower.
struct Delaunay {
  static constexpr bool implies_convex = true;
  static constexpr bool looks_around = false;
  [[nodiscard]] bool improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const;
};

/// The smaller of the six angles of the two triangles is to be as large as can be. Exact. Objective: the list
/// of the triangles' smallest angles, ascending, gets larger.
///
/// Decided by incircle: if the fourth corner lies inside the circumcircle, each of the six new angles is
/// larger than one of the old ones, by Thales; if it lies outside, the other way round (Lawson 1977; Sibson,
/// Computer Journal 21, 1978). So this ends in a Delaunay triangulation, but leaves ties as they are.
struct MaxMinAngle {
  static constexpr bool implies_convex = true;
  static constexpr bool looks_around = false;
  [[nodiscard]] bool improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const;
};

/// The largest of the six angles is to be as small as can be. Exact: rational cotangents where doubles with
/// an error bound cannot tell. Objective: the list of the triangles' largest angles, descending, gets
/// smaller.
struct MinMaxAngle {
  static constexpr bool implies_convex = false;
  static constexpr bool looks_around = false;
  [[nodiscard]] bool improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const;
};

/// The shorter diagonal. Exact: squared lengths, rational where doubles with an error bound cannot tell.
/// Objective: the sum of the edges' lengths gets smaller.
struct MinEdgeLength {
  static constexpr bool implies_convex = false;
  static constexpr bool looks_around = false;
  [[nodiscard]] bool improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const;
};

/// Least roughness of the piecewise linear function with given values at the vertices: (3.2) of the notes.
/// Objective: the exact sum over the triangles of their roughness, each a double, gets smaller. The roughness
/// of one triangle is rounded, so where both diagonals are equally good, rounding chooses; the same
/// everywhere, as only +, -, * and / enter. A swap that would need a number beyond the largest double is not
/// made.
struct MinRoughness {
  std::span<const double> values;  ///< one a point; must outlive the criterion
  static constexpr bool implies_convex = false;
  static constexpr bool looks_around = false;
  [[nodiscard]] bool improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const;
};

/// Data-dependent: the surface of the piecewise linear function is to bend as little as can be over its
/// edges. The cost of an edge is the distance between the ends of the two unit normals on its sides, 2 sin of
/// half the angle between them: it grows with the angle, which Dyn, Levin and Rippa take (IMA Journal of
/// Numerical Analysis 10, 1990), and needs no function but the square root, so that all machines round alike.
/// Objective: the exact sum of all edges' costs, each a double, gets smaller. A swap that would need a number
/// beyond the largest double is not made.
struct AngleBetweenNormals {
  std::span<const double> values;  ///< one a point; must outlive the criterion
  static constexpr bool implies_convex = false;
  static constexpr bool looks_around = true;
  [[nodiscard]] bool improves(const GhostTriangulation& in, std::span<const Point2> points, SideId s) const;
};

}  // namespace leonhard::delaunay::criterion

namespace leonhard::delaunay {

using SwapCriterion =
    std::variant<criterion::Delaunay, criterion::MaxMinAngle, criterion::MinMaxAngle,
                 criterion::MinEdgeLength, criterion::MinRoughness, criterion::AngleBetweenNormals>;

}  // namespace leonhard::delaunay
