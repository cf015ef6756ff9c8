// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "leonhard/kernel/point.hpp"

namespace leonhard::mesh {

/// Whether two triangles in space have a point in common beyond their common corners, common edge or, if they have all
/// three corners in common, the whole: whether they are not two parts of one triangulated surface. Triangles count with
/// their edges and corners, so a corner on the other's edge is contact.
///
/// p, q     corners, finite, not collinear; corners are common if their coordinates are equal
/// Exact, by orient3d and orient2d of the corners' coordinates.
/// Method: a segment meets a triangle if its line passes the three edges on the same side, or along them.
[[nodiscard]] bool in_contact(const std::array<Point3, 3>& p, const std::array<Point3, 3>& q);

}  // namespace leonhard::mesh
