// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/io/soup/mesh_soup.hpp"

/// Vertices of a soup that are too many. Its corners are in range.
namespace leonhard::io {

/// Vertices no farther apart than the tolerance become the one that comes first, whose fields and marker stay; with 0 those of
/// equal coordinates. Each joins the nearest of those that stay, in the file's order, so that none moves farther. A warning
/// tells how many.
///
/// throws  InputError if the tolerance is negative or not finite
/// Cost O(vertices log vertices), if few vertices lie within a tolerance.
template <int Dim>
void weld_vertices(MeshSoup<Dim>& soup, double tolerance);

/// Vertices that no cell uses go, and the others are renumbered in their order; a warning tells how many.
///
/// throws  InputError if a listed facet has one of them
template <int Dim>
void drop_unused_vertices(MeshSoup<Dim>& soup);

}  // namespace leonhard::io
