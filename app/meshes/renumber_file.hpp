// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/mesh/io/any_mesh_file.hpp"

namespace leonhard::app {

/// The same mesh with its vertices in another order, its cells sorted by them, and its fields with both.
///
/// order   old numbers of vertices in their new sequence
[[nodiscard]] AnyMeshFile renumbered(const AnyMeshFile& file, const std::vector<std::uint32_t>& order);

}  // namespace leonhard::app
