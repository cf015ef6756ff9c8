// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Orders in which the incremental algorithms take points: order[i] is the index of the i-th point.
namespace leonhard::delaunay {

/// Points in rounds.
struct Rounds {
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> begins;  ///< round r is order[begins[r]] to order[begins[r + 1] - 1]

  [[nodiscard]] std::size_t count() const { return begins.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> round(std::size_t r) const {
    return std::span(order).subspan(begins[r], begins[r + 1] - begins[r]);
  }
};

/// Rounds of eightfold size, drawn at random; within a round indices rise, so that points along a curve stay along it.
/// Expected work is that of a random order (Amenta, Choi and Rote, SoCG 2003).
///
/// seed  another one draws other rounds
/// Cost O(n).
[[nodiscard]] Rounds rounds_of(std::size_t n, std::uint64_t seed = 0);
[[nodiscard]] inline std::vector<std::uint32_t> order_in_rounds(std::size_t n) { return rounds_of(n).order; }

/// A random permutation: every order is equally likely. Cost O(n).
[[nodiscard]] std::vector<std::uint32_t> random_order(std::size_t n, std::uint64_t seed);

/// Bring three points that span a triangle to the front, counter-clockwise, the others left in their order.
///
/// points   distinct, at least three
/// returns  false if they are all collinear
[[nodiscard]] bool bring_triangle_to_front(std::span<const Point2> points, std::vector<std::uint32_t>& order);

}  // namespace leonhard::delaunay
