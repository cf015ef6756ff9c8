// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "leonhard/mesh/cell_kind.hpp"

/// VTK's numbers for cells, which SU2 uses too. Not meant for callers of the room.
namespace leonhard::io {

inline constexpr std::int64_t vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5, vtk_quadrilateral = 9,
                              vtk_tetrahedron = 10;

/// In the order of CellKind.
inline constexpr std::array<std::int64_t, cell_kind_count> vtk_types{5, 9, 10, 14, 13, 12};

[[nodiscard]] constexpr std::int64_t vtk_type_of(CellKind kind) {
  return vtk_types[static_cast<std::size_t>(kind)];
}

/// The corners of a prism in VTK's order, which directs the base outwards, and the way back. (The VTK User's Guide, vtkWedge.)
inline constexpr std::array<std::size_t, 6> vtk_prism_order{0, 2, 1, 3, 5, 4};

/// None if the number is no kind of cell that a mesh may have.
[[nodiscard]] constexpr std::optional<CellKind> kind_of_vtk_type(std::int64_t type) {
  for (std::size_t kind = 0; kind < cell_kind_count; ++kind)
    if (vtk_types[kind] == type) return static_cast<CellKind>(kind);
  return std::nullopt;
}

}  // namespace leonhard::io
