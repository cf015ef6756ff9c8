// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace leonhard::graph {

/// Three sets of vertices: no edge joins the first two.
struct VertexSeparator {
  static constexpr std::uint8_t separator = 2;
  std::vector<std::uint8_t> side_of;  ///< one a vertex: 0, 1 or `separator`
  std::uint32_t size{};               ///< vertices of the separator
};

}  // namespace leonhard::graph
