// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::notes {

/// A mesh with Steiner points about a slat, a main element and a flap, finer near them.
[[nodiscard]] const TriangleMesh& flap_mesh();

/// The neighbourhood of the three elements.
inline const draw::View close_up{draw::Box{{-0.45, -0.65}, {1.55, 0.6}}};

}  // namespace leonhard::notes
