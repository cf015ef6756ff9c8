// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

/// Vertices at equal or near places.
namespace leonhard::io {

[[nodiscard]] PerId<VertexId, VertexId> every_vertex_itself(std::size_t count);

/// Of each vertex the one of equal coordinates that comes first. Cost O(n log n).
template <class Point>
[[nodiscard]] PerId<VertexId, VertexId> first_at_equal_places(const PerId<VertexId, Point>& points);

/// Of each vertex the one that it becomes: with a tolerance of 0 first_at_equal_places, else the nearest of those that come
/// before, stay, and are no farther than the tolerance, so that none moves farther.
/// throws  InputError if the tolerance is negative or not finite
template <class Point>
[[nodiscard]] PerId<VertexId, VertexId> weld_places(const PerId<VertexId, Point>& points, double tolerance);

}  // namespace leonhard::io
