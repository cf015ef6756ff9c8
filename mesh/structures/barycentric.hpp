// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/mesh_location.hpp"

namespace leonhard::mesh {

/// The barycentric coordinates of p among the vertices that span its place: p lies strictly inside their segment, triangle
/// or tetrahedron, or at the vertex. None if there is no vertex. Each within 2^-40 of the exact one: determinants of
/// doubles where their error bound allows it, else of rational numbers.
///
/// span  vertices as in MeshLocation
[[nodiscard]] VertexWeights<3> barycentric_weights(const PerId<VertexId, Point2>& points,
                                                   const std::array<MaybeId<VertexId>, 3>& span,
                                                   const Point2& p);
[[nodiscard]] VertexWeights<4> barycentric_weights(const PerId<VertexId, Point3>& points,
                                                   const std::array<MaybeId<VertexId>, 4>& span,
                                                   const Point3& p);

}  // namespace leonhard::mesh
