// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/app/report/communication_report.hpp"
#include "leonhard/graph/partition.hpp"

namespace leonhard::app {

/// The parts, and beside them the communication graph at the parts' centres, its edges coloured by cycles, up to 24 of
/// them with the lengths of their two messages (Barth's notes, figure 2.3.0). Up to 100 parts whose centres are crowded
/// stand in a circle instead, and so do, alone, parts whose coordinates are not known. Format and errors as in
/// mesh/draw/mesh_picture.hpp.
///
/// which  what the partition is of, where the input is a mesh
void draw_communication(const std::filesystem::path& path, const AnyGraph& input, GraphOf which,
                        const graph::Partition& partition, const Communication& communication,
                        const std::string& title);

}  // namespace leonhard::app
