// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::kernel {

/// The order in which a Hilbert curve through the bounding square visits the points: neighbours in the order
/// are neighbours in the plane.
///
/// points   finite, any number below 2^32, repeated points welcome
/// returns  order[i] = index of the i-th point along the curve. Points in one cell of the 2^31 x 2^31 grid
/// come in
///          lexicographic order, equal points in the order of their indices. The curve starts at the lower
///          left corner of the bounding square and ends at its lower right corner.
/// throws   InputError naming the first point that is not finite
/// Cost O(n); 28 bytes a point while it runs. Same input, same output, on every machine.
[[nodiscard]] std::vector<std::uint32_t> hilbert_order(std::span<const Point2> points);

/// The same in space, along a Hilbert curve through the bounding cube, on a grid of 2^21 cells a side. The curve starts
/// at the corner of the lowest coordinates and ends at the corner from there along x.
[[nodiscard]] std::vector<std::uint32_t> hilbert_order(std::span<const Point3> points);

}  // namespace leonhard::kernel
