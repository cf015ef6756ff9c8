// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Orders in which the incremental algorithms take points: order[i] is the index of the i-th point.
namespace leonhard::delaunay {

/// Rounds of eightfold size, drawn at random without a seed; within a round indices rise, so that points
/// along a curve stay along it. Expected work is that of a random order (Amenta, Choi and Rote, SoCG 2003).
/// Cost O(n).
[[nodiscard]] std::vector<std::uint32_t> order_in_rounds(std::size_t n);

/// A random permutation: every order is equally likely. Cost O(n).
[[nodiscard]] std::vector<std::uint32_t> random_order(std::size_t n, std::uint64_t seed);

/// Bring three points that span a triangle to the front, counter-clockwise, the others left in their order.
///
/// points   distinct, at least three
/// returns  false if they are all collinear
[[nodiscard]] bool bring_triangle_to_front(std::span<const Point2> points, std::vector<std::uint32_t>& order);

}  // namespace leonhard::delaunay
