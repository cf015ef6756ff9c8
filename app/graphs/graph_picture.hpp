// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/mesh/draw/diagram.hpp"
#include "leonhard/mesh/draw/view3.hpp"

namespace leonhard::app {

/// A graph's edges where its vertices lie, coloured by part, touching parts in different colours, and cut edges dark: in
/// the plane above all others; in space, in parallel projection, near edges hide far ones. Vertices show as dots in
/// graphs of up to 2000.
///
/// input   with coordinates (check_drawable)
/// places  where its vertices are on the page (places_on_page)
/// throws  InputError if the partition does not fit
/// Cost O(n + m log m).
[[nodiscard]] draw::Diagram graph_diagram(const AnyGraph& input, const std::vector<Point3>& places,
                                          const graph::Partition& partition, const std::string& title);

/// The coordinates as the page shows them, z growing towards the viewer: those of space as seen from a direction, those
/// of the plane as they are. Empty if there are none.
[[nodiscard]] std::vector<Point3> places_on_page(const AnyGraph& input, const draw::View3& view = {});

/// A colour's number to each part, such that parts that touch differ.
[[nodiscard]] std::vector<std::uint32_t> colours_of_parts(const graph::CsrGraph& graph,
                                                          const graph::Partition& partition);

/// throws InputError, saying where coordinates are looked for, if the graph has none
void check_drawable(const AnyGraph& input, const std::string& source);

}  // namespace leonhard::app
