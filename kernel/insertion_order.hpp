// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::kernel {

/// The biased randomised insertion order of incremental Delaunay construction: rounds of points drawn at random, each
/// about twice as large as the one before, the points of a round along a Hilbert curve. Neighbours are mostly inserted
/// one after another, yet the expected work is that of a random order.
///
/// points   finite, any number below 2^32, repeated points welcome
/// seed     another seed draws other rounds
/// returns  order[i] = index of the i-th point to insert
/// throws   InputError naming the first point that is not finite
/// Cost O(n). Same input and seed, same output, on every machine.
/// Method: Amenta, Choi and Rote, "Incremental constructions con BRIO", Symposium on Computational Geometry (2003).
[[nodiscard]] std::vector<std::uint32_t> brio_order(std::span<const Point2> points, std::uint64_t seed);
[[nodiscard]] std::vector<std::uint32_t> brio_order(std::span<const Point3> points, std::uint64_t seed);

}  // namespace leonhard::kernel
