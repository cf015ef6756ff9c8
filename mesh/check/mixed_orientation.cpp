// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/mixed_orientation.hpp"

#include <algorithm>
#include <array>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

/// A corner and those that have an edge to it, so that they are positive in a cell that is.
template <int Dim>
using CornerSimplex = std::array<std::uint8_t, Dim + 1>;

constexpr std::array<CornerSimplex<2>, 1> triangle_corner{{{0, 1, 2}}};
constexpr std::array<CornerSimplex<2>, 4> quadrilateral_corners{{{0, 1, 3}, {1, 2, 0}, {2, 3, 1}, {3, 0, 2}}};
constexpr std::array<CornerSimplex<3>, 1> tetrahedron_corner{{{0, 1, 2, 3}}};
constexpr std::array<CornerSimplex<3>, 4> pyramid_corners{
    {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}}};
constexpr std::array<CornerSimplex<3>, 6> prism_corners{
    {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}}};
constexpr std::array<CornerSimplex<3>, 8> hexahedron_corners{{{0, 1, 3, 4},
                                                              {1, 2, 0, 5},
                                                              {2, 3, 1, 6},
                                                              {3, 0, 2, 7},
                                                              {4, 7, 5, 0},
                                                              {5, 4, 6, 1},
                                                              {6, 5, 7, 2},
                                                              {7, 6, 4, 3}}};

template <int Dim>
std::span<const CornerSimplex<Dim>> corner_simplices(CellKind kind) {
  if constexpr (Dim == 2) {
    if (kind == CellKind::triangle) return triangle_corner;
    return quadrilateral_corners;
  } else {
    if (kind == CellKind::tetrahedron) return tetrahedron_corner;
    if (kind == CellKind::pyramid) return pyramid_corners;
    if (kind == CellKind::prism) return prism_corners;
    return hexahedron_corners;
  }
}

Sign simplex_sign(const std::array<Point2, 3>& p) { return kernel::orient2d(p[0], p[1], p[2]); }
Sign simplex_sign(const std::array<Point3, 4>& p) { return kernel::orient3d(p[0], p[1], p[2], p[3]); }

}  // namespace

template <int Dim>
Orientation orientation_of(const MixedMesh<Dim>& mesh, CellId cell) {
  const auto simplices = corner_simplices<Dim>(mesh.kinds[cell]);
  const auto corners = mesh.corners_of(cell);
  std::array<Sign, most_cell_corners> signs{};
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    std::array<typename Simplex<Dim>::Point, Dim + 1> p;
    for (std::size_t c = 0; c <= Dim; ++c) p[c] = mesh.points[corners[simplices[i][c]]];
    signs[i] = simplex_sign(p);
  }
  const auto end = signs.begin() + static_cast<std::ptrdiff_t>(simplices.size());
  const auto negative = std::count(signs.begin(), end, Sign::negative);
  const auto positive = std::count(signs.begin(), end, Sign::positive);
  const Sign usual = negative > positive ? Sign::negative : Sign::positive;
  const auto odd = std::find_if(signs.begin(), end, [&](Sign sign) { return sign != usual; });
  if (odd == end) return {usual};
  return {Sign::zero, simplices[static_cast<std::size_t>(odd - signs.begin())][0], *odd};
}

template <int Dim>
std::string orientation_words(const MixedMesh<Dim>& mesh, CellId cell, const Orientation& turn) {
  const bool plane = Dim == 2;
  const std::string size = plane ? "area" : "volume";
  if (turn.sign == Sign::negative)
    return words(mesh, cell) +
           (plane ? " is clockwise: its area is negative" : " is turned over: its volume is negative");
  if (mesh.kinds[cell] == simplex_kind<Dim>) return words(mesh, cell) + " has " + size + " zero";
  const VertexId corner = mesh.corners_of(cell)[*turn.odd];
  return words(mesh, cell) + (plane ? " is not convex: the triangle" : " is tangled: the tetrahedron") +
         " of " + words(mesh, corner) + " and its neighbours has " +
         (turn.odd_sign == Sign::zero ? size + " zero"
                                      : std::string(to_string(turn.odd_sign)) + " " + size + ", unlike most");
}

template Orientation orientation_of(const MixedMesh<2>&, CellId);
template Orientation orientation_of(const MixedMesh<3>&, CellId);
template std::string orientation_words(const MixedMesh<2>&, CellId, const Orientation&);
template std::string orientation_words(const MixedMesh<3>&, CellId, const Orientation&);

}  // namespace leonhard::mesh
