// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <string>

#include "leonhard/kernel/sign.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// The seven properties of Delaunay triangulations (Barth's notes 3.2) as checks of any triangulation.
///
/// A check gives none where the property holds, else words for the first element that fails. Each decides by
/// exact arithmetic. A mesh is one in which mesh::validate finds nothing wrong: a precondition, of which that no id is out of
/// range is checked (InputError). Edges in mesh.constraints and
/// on the boundary are never blamed by the checks of pairs of triangles; the checks that hold every vertex
/// against every element (circumcircles, edge circles, nearest neighbours) and those that compare two
/// triangulations are theorems about triangulations of the whole convex hull without constraints.
namespace leonhard::delaunay {

// ---- (1) uniqueness ----

/// The first interior edge whose two triangles have cocircular corners: were there none, the point set would
/// have one Delaunay triangulation even without tie-breaking. Cost O(triangles).
[[nodiscard]] std::optional<std::string> first_tie(const TriangleMesh& mesh);

/// Is this the one triangulation that kernel::incircle_perturbed picks where ties leave a choice? It fails
/// for other Delaunay triangulations of the same points too. Cost O(triangles).
[[nodiscard]] std::optional<std::string> validate_uniqueness(const TriangleMesh& mesh);

// ---- (2) the circumcircle criterion ----

/// No vertex lies inside the circumcircle of any triangle. mesh::validate_delaunay asks neighbours only,
/// which implies it (Delaunay's lemma). Cost O(triangles vertices).
[[nodiscard]] std::optional<std::string> validate_circumcircles(const TriangleMesh& mesh);

// ---- (3) the edge circle property ----

/// Through the ends of each edge there is a circle without a vertex inside. Cost O(edges vertices).
///
/// Of all circles through both ends, a vertex on the left rules out those that bulge to the left beyond the
/// one through it, and so for the right: there is a circle left if and only if the first vertex on the right
/// is not inside the circle of the first one on the left.
[[nodiscard]] std::optional<std::string> validate_edge_circles(const TriangleMesh& mesh);

/// The property of constrained triangulations: through the ends of each interior edge, constraints excepted,
/// there is a circle with no vertex inside that can be seen from the edge. Boundary and constraints block the
/// view; a vertex is seen if it is from a piece of the edge of positive length. Cost O(edges vertices), and
/// for the vertices nearest to an edge a pass over boundary and constraints.
/// Source: Lee and Lin, "Generalized Delaunay triangulation for planar graphs", Discrete & Computational
/// Geometry 1 (1986).
[[nodiscard]] std::optional<std::string> validate_constrained_edge_circles(const TriangleMesh& mesh);

// ---- (4) equiangularity ----

/// In every two triangles that form a strictly convex quadrilateral the smallest of the six angles is not
/// smaller than with the other diagonal. Angles are compared by their cotangents, which are rational. Cost
/// O(triangles), tens of microseconds an edge.
[[nodiscard]] std::optional<std::string> validate_equiangularity(const TriangleMesh& mesh);

/// The smallest angle of all is not smaller than in another triangulation of the same points.
///
/// throws  InputError if the points are not the same in the same order
/// Cost O(triangles), microseconds each.
[[nodiscard]] std::optional<std::string> validate_min_angle(const TriangleMesh& mesh,
                                                            const TriangleMesh& other);

// ---- (5) the minimum containment circle ----

/// The largest containment circle (of a triangle: the smallest circle that encloses it) is not larger than in
/// another triangulation of the same points.
///
/// throws  InputError if the points are not the same in the same order
/// Cost O(triangles), microseconds each.
/// Source: Rajan, "Optimality of the Delaunay triangulation in R^d", Symposium on Computational Geometry
/// (1991).
[[nodiscard]] std::optional<std::string> validate_containment_circles(const TriangleMesh& mesh,
                                                                      const TriangleMesh& other);

// ---- (6) the nearest neighbour ----

/// From every vertex there are edges to all vertices that are nearest to it. Cost O(vertices) times how many
/// lie within a strip as wide as an edge.
[[nodiscard]] std::optional<std::string> validate_nearest_neighbours(const TriangleMesh& mesh);

// ---- (7) minimal roughness ----

/// The Sobolev seminorm (3.2) of the notes, the integral of the squared gradient, of the piecewise linear
/// function with given values at the vertices: an exact number, with a denominator of some hundred bits a
/// triangle.
///
/// values  one a vertex, finite
/// throws  InputError if there is not one value a vertex
[[nodiscard]] mpq_class roughness(const TriangleMesh& mesh, std::span<const double> values);

/// In every two triangles that form a strictly convex quadrilateral the roughness is not greater than with
/// the other diagonal. Holds for every Delaunay triangulation whatever the values. Cost O(triangles),
/// microseconds each.
///
/// throws  InputError if there is not one value a vertex
/// Source: Rippa, "Minimal roughness property of the Delaunay triangulation", Computer Aided Geometric Design
/// 7 (1990).
[[nodiscard]] std::optional<std::string> validate_roughness(const TriangleMesh& mesh,
                                                            std::span<const double> values);

/// The roughness as a whole is not greater than in another triangulation of the same points.
///
/// throws  InputError if the points are not the same in the same order, or there is not one value a vertex
[[nodiscard]] std::optional<std::string> validate_roughness(const TriangleMesh& mesh,
                                                            const TriangleMesh& other,
                                                            std::span<const double> values);

}  // namespace leonhard::delaunay
