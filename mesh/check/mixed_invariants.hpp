// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "leonhard/mesh/structures/mixed_sides.hpp"

/// The invariants of MixedMesh one by one, each in words for the first place where it is broken. `validate` and
/// `make_mixed_mesh` ask the same ones. A function may rely on those declared before it.
namespace leonhard::mesh {

/// One entry per vertex or cell in each array that has to have one.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_sizes(const MixedMesh<Dim>& mesh);

/// Every kind is one of this dimension, every row of corners as long as its kind asks.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_kind(const MixedMesh<Dim>& mesh);

/// Every corner of a cell or of a marked facet is a vertex.
template <int Dim>
[[nodiscard]] std::optional<std::string> corner_out_of_range(const MixedMesh<Dim>& mesh);

/// Every coordinate is finite.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_point(const MixedMesh<Dim>& mesh);

/// No cell and no marked facet names a vertex twice.
template <int Dim>
[[nodiscard]] std::optional<std::string> repeated_corner(const MixedMesh<Dim>& mesh);

/// Every vertex has a cell.
template <int Dim>
[[nodiscard]] std::optional<std::string> unused_vertex(const MixedMesh<Dim>& mesh);

/// Every cell is positive (orientation_of).
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_orientation(const MixedMesh<Dim>& mesh);

/// No facet has more than two cells or two on the same side (a cell given twice included).
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_facet(const MixedMesh<Dim>& mesh,
                                                      const MixedSides<Dim>& sides);

/// No face of four vertices with one cell lies on a face with one cell that has three of its vertices, or all four in
/// another order.
[[nodiscard]] std::optional<std::string> unconforming_face(const MixedMesh<3>& mesh,
                                                           const MixedSides<3>& sides);

/// mesh.boundary has each facet of one cell once, directed outwards.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_boundary(const MixedMesh<Dim>& mesh,
                                                         const MixedSides<Dim>& sides);

/// mesh.inner_facets has facets between two cells only.
template <int Dim>
[[nodiscard]] std::optional<std::string> broken_inner_facet(const MixedMesh<Dim>& mesh,
                                                            const MixedSides<Dim>& sides);

/// throws  InputError with the problem in words, if there is one
void refuse(const std::optional<std::string>& problem, const std::string& source, const std::string& remedy);

}  // namespace leonhard::mesh
