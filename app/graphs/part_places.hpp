// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/point.hpp"

/// Where the parts of a partition stand in a picture of their communication graph.
namespace leonhard::app {

/// The middle of each part's vertices. Up to 100 parts some of which would be too near to each other to be told apart, as
/// in meshes that are graded, stand in a circle instead, in the sequence in which they lie about their median.
///
/// places  of the graph's vertices on the page, at least one; z is not read
/// Cost O(vertices + parts).
[[nodiscard]] std::vector<Point2> places_of_parts(const std::vector<Point3>& places,
                                                  const graph::Partition& partition);

/// In a circle, clockwise from the top.
[[nodiscard]] std::vector<Point2> parts_in_a_circle(std::size_t parts);

}  // namespace leonhard::app
