// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "leonhard/delaunay/delaunay_tree.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

/// The statistics behind randomised incremental construction: Guibas, Knuth and Sharir, Algorithmica 7 (1992)
/// (Barth's notes 3.3c). The scope of a triangle of sites is the number of sites inside its circumcircle.
namespace leonhard::delaunay {

using Corners = std::array<VertexId, 3>;

/// The scope of a triangle, ties broken by kernel::incircle_perturbed. Cost O(n).
///
/// corners  not collinear, in any orientation
/// throws   InputError if they are collinear or none of the sites, or a coordinate is not finite
[[nodiscard]] std::size_t scope(std::span<const Point2> sites, const Corners& corners);

/// How many of all triangles of the sites have scope 0, 1, ..., n - 3; degenerate ones left out. Cost O(n^4):
/// for some tens of sites.
[[nodiscard]] std::vector<std::size_t> triangles_of_scope(std::span<const Point2> sites);

/// The probability that a triangle of scope j is Delaunay at some time of an insertion in random order.
///
/// It is if its three corners come before the j sites in its circle: of the (j + 3)! orders of these, 3! j!
/// have that.
/// returns  3! j! / (j + 3)! = 6 / ((j + 1) (j + 2) (j + 3))
[[nodiscard]] double appearance_probability(std::size_t scope);

/// Calls back for every triangle, ghost triangles among them, that was Delaunay after some insertion: all of
/// the history but those that one insertion made and its next swap replaced.
void for_each_delaunay_ever(const DelaunayTree& tree, const std::function<void(const Corners&)>& visit);

}  // namespace leonhard::delaunay
