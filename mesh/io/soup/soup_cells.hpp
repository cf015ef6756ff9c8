// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/io/soup/mesh_soup.hpp"

/// The cells of a soup, whose corners are in range and distinct.
namespace leonhard::io {

/// What is asked of quadrilaterals: strictly convex ones are cells of mixed meshes, simple ones can be split.
enum class QuadrilateralRule { convex, simple };

/// Turns every cell that is turned over, which a warning tells.
/// throws  InputError naming the first cell that is flat, tangled or, as the rule says, not convex
template <int Dim>
void orient_cells(MeshSoup<Dim>& soup, QuadrilateralRule rule);

/// Triangles in place of quadrilaterals, which are positive under QuadrilateralRule::simple; a warning tells how many.
void split_quadrilaterals(MeshSoup<2>& soup);

/// Drops facets listed before with the same marker, which a warning tells.
/// throws  InputError naming both lines where the markers differ
template <int Dim>
void drop_repeated_facets(MeshSoup<Dim>& soup);

}  // namespace leonhard::io
