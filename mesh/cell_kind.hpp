// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace leonhard {

/// What a cell of a MixedMesh is: of the plane a triangle or quadrilateral, of space one of the other four.
///
/// Corners come in the order of VTK (The VTK User's Guide, "VTK file formats"), Gmsh and CGNS; a base comes first, seen
/// counter-clockwise from within the cell, so that its normal points into it:
///
///   triangle       0 1 2 counter-clockwise
///   quadrilateral  0 1 2 3 counter-clockwise
///   tetrahedron    0 1 2 the base, 3 the apex: orient3d(0, 1, 2, 3) > 0
///   pyramid        0 1 2 3 the base, 4 the apex
///   prism          0 1 2 the base, 3 4 5 above them
///   hexahedron     0 1 2 3 the base, 4 5 6 7 above them
///
/// VTK's own text directs a prism's (wedge's) base outwards; programs that write prisms do both, so readers take either.
enum class CellKind : std::uint8_t { triangle, quadrilateral, tetrahedron, pyramid, prism, hexahedron };

inline constexpr std::size_t cell_kind_count = 6;

/// The most corners of a cell, and of one of its facets.
inline constexpr std::size_t most_cell_corners = 8, most_facet_corners = 4;

/// The corners of a facet, as numbers among its cell's, directed outwards: the cell lies to the left of an edge and
/// behind a face (which turns counter-clockwise as seen from outside).
class FacetShape {
 public:
  template <class... Corner>
  constexpr explicit(sizeof...(Corner) == 1) FacetShape(Corner... corner)
      : count_(sizeof...(Corner)), corners_{static_cast<std::uint8_t>(corner)...} {}

  [[nodiscard]] constexpr std::size_t size() const { return count_; }
  [[nodiscard]] constexpr std::size_t operator[](std::size_t i) const { return corners_[i]; }
  [[nodiscard]] constexpr auto begin() const { return corners_.begin(); }
  [[nodiscard]] constexpr auto end() const { return corners_.begin() + count_; }

 private:
  std::uint8_t count_;
  std::array<std::uint8_t, most_facet_corners> corners_{};
};

/// How a kind of cell is made.
struct CellShape {
  CellKind kind;
  int dimension;  ///< 2 or 3
  std::size_t corner_count;
  std::span<const FacetShape> facets;
  const char *name, *names;  ///< in words, one and many
};

[[nodiscard]] const CellShape& shape_of(CellKind kind);

/// The simplex of a dimension.
template <int Dim>
inline constexpr CellKind simplex_kind = Dim == 2 ? CellKind::triangle : CellKind::tetrahedron;

}  // namespace leonhard
