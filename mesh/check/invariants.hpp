// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/structures/half_facets.hpp"

/// The invariants of SimplexMesh one by one, each in words for the first place where it is broken. `validate` and
/// `make_triangle_mesh`, `make_tet_mesh` ask the same ones. A function may rely on those declared before it.
namespace leonhard::mesh {

/// One entry per vertex or cell in each array that has to have one.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_sizes(const SimplexMesh<Dim>& mesh);

/// Every coordinate is finite.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_point(const SimplexMesh<Dim>& mesh);

/// Every corner is a vertex, no cell names one twice.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_corner(const SimplexMesh<Dim>& mesh);

/// Every vertex has a cell.
template <int Dim>
[[nodiscard]] std::optional<std::string> unused_vertex(const SimplexMesh<Dim>& mesh);

/// Every cell is positive, by exact orient2d or orient3d.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_orientation(const SimplexMesh<Dim>& mesh);

/// mesh.neighbours says what the table of half-facets says.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_neighbour(const SimplexMesh<Dim>& mesh,
                                                          const HalfFacetTable<Dim>& table);

/// The facets of mesh.neighbours without a cell behind, each directed outwards.
template <int Dim>
class BoundaryFacets {
 public:
  struct Facet {
    SortedFacet<Dim> sorted;
    typename Simplex<Dim>::CellId cell;
    std::uint8_t side;  ///< opposite corners[cell][side]
  };
  explicit BoundaryFacets(const SimplexMesh<Dim>& mesh);

  /// Sorted by their vertices in ascending order.
  [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }
  /// Index in facets() of the facet with these vertices, ascending. Cost O(log boundary).
  [[nodiscard]] std::optional<std::size_t> find(const std::array<VertexId, Dim>& ascending) const;

 private:
  std::vector<Facet> facets_;
};

/// mesh.boundary has each boundary facet once, directed outwards.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_boundary(const SimplexMesh<Dim>& mesh,
                                                         const BoundaryFacets<Dim>& facets);

/// mesh.constraints or mesh.interfaces has facets between two cells only.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_inner_facet(const SimplexMesh<Dim>& mesh,
                                                            const HalfFacetTable<Dim>& table);

/// throws  InputError with the problem in words, if there is one
void refuse(const std::optional<std::string>& problem, const std::string& source, const std::string& remedy);

/// The table of a mesh about which nothing is known.
/// throws  InputError on a broken corner or a broken facet
template <int Dim>
[[nodiscard]] HalfFacetTable<Dim> checked_half_facets(const SimplexMesh<Dim>& mesh,
                                                      const std::string& source = {});

}  // namespace leonhard::mesh
