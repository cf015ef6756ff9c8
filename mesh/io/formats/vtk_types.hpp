// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "leonhard/mesh/cell_kind.hpp"

/// VTK's numbers for cells, which SU2 uses too. Not meant for callers of the room.
namespace leonhard::io {

inline constexpr std::int64_t vtk_vertex = 1, vtk_poly_vertex = 2, vtk_line = 3, vtk_poly_line = 4,
                              vtk_triangle = 5, vtk_triangle_strip = 6, vtk_polygon = 7, vtk_pixel = 8,
                              vtk_quadrilateral = 9, vtk_tetrahedron = 10, vtk_voxel = 11;

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

/// What a type of VTK is, of whatever order: its corners come first among its vertices.
struct VtkKind {
  int dimension;
  std::size_t corner_count;
  std::optional<CellKind> kind{};  ///< none: a line
};

/// Types of one shape: linear, quadratic in its variants, of Lagrange, of Bezier (vtkCellType.h).
[[nodiscard]] constexpr std::optional<VtkKind> vtk_kind_of(std::int64_t type) {
  switch (type) {
    case 3:
    case 21:
    case 35:
    case 68:
    case 75:
      return VtkKind{1, 2, {}};
    case 5:
    case 22:
    case 34:
    case 69:
    case 76:
      return VtkKind{2, 3, CellKind::triangle};
    case 8:
    case 9:
    case 23:
    case 28:
    case 30:
    case 70:
    case 77:
      return VtkKind{2, 4, CellKind::quadrilateral};
    case 10:
    case 24:
    case 71:
    case 78:
      return VtkKind{3, 4, CellKind::tetrahedron};
    case 11:
    case 12:
    case 25:
    case 29:
    case 33:
    case 72:
    case 79:
      return VtkKind{3, 8, CellKind::hexahedron};
    case 13:
    case 26:
    case 31:
    case 32:
    case 73:
    case 80:
      return VtkKind{3, 6, CellKind::prism};
    case 14:
    case 27:
    case 37:
    case 74:
    case 81:
      return VtkKind{3, 5, CellKind::pyramid};
    default:
      return std::nullopt;
  }
}

}  // namespace leonhard::io
