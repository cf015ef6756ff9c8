// SPDX-License-Identifier: MIT
#include "leonhard/mesh/cell_kind.hpp"

#include <cassert>

namespace leonhard {
namespace {

// Those of simplices in the order of Simplex<Dim>::facet_corners.
constexpr std::array triangle_facets{FacetShape(1, 2), FacetShape(2, 0), FacetShape(0, 1)};
constexpr std::array quadrilateral_facets{FacetShape(0, 1), FacetShape(1, 2), FacetShape(2, 3),
                                          FacetShape(3, 0)};
constexpr std::array tetrahedron_facets{FacetShape(1, 2, 3), FacetShape(0, 3, 2), FacetShape(0, 1, 3),
                                        FacetShape(0, 2, 1)};
constexpr std::array pyramid_facets{FacetShape(0, 3, 2, 1), FacetShape(0, 1, 4), FacetShape(1, 2, 4),
                                    FacetShape(2, 3, 4), FacetShape(3, 0, 4)};
constexpr std::array prism_facets{FacetShape(0, 2, 1), FacetShape(3, 4, 5), FacetShape(0, 1, 4, 3),
                                  FacetShape(1, 2, 5, 4), FacetShape(2, 0, 3, 5)};
constexpr std::array hexahedron_facets{FacetShape(0, 3, 2, 1), FacetShape(4, 5, 6, 7),
                                       FacetShape(0, 1, 5, 4), FacetShape(1, 2, 6, 5),
                                       FacetShape(2, 3, 7, 6), FacetShape(3, 0, 4, 7)};

constexpr std::array<CellShape, cell_kind_count> shapes{
    {{CellKind::triangle, 2, 3, triangle_facets, "triangle", "triangles"},
     {CellKind::quadrilateral, 2, 4, quadrilateral_facets, "quadrilateral", "quadrilaterals"},
     {CellKind::tetrahedron, 3, 4, tetrahedron_facets, "tetrahedron", "tetrahedra"},
     {CellKind::pyramid, 3, 5, pyramid_facets, "pyramid", "pyramids"},
     {CellKind::prism, 3, 6, prism_facets, "prism", "prisms"},
     {CellKind::hexahedron, 3, 8, hexahedron_facets, "hexahedron", "hexahedra"}}};

}  // namespace

const CellShape& shape_of(CellKind kind) {
  assert(static_cast<std::size_t>(kind) < shapes.size());
  return shapes[static_cast<std::size_t>(kind)];
}

}  // namespace leonhard
