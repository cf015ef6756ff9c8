// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "leonhard/graph/partition.hpp"

/// Partitions as text: the part of each vertex on a line of its own, numbered from 0, as METIS, KaHIP and `leonhard
/// partition` write them.
namespace leonhard::app {

/// There are as many parts as the largest number asks for; parts without a vertex may be among them.
///
/// vertices  how many there must be
/// source    names the text in errors
/// throws    InputError naming file and line: no whole number, a negative one, more than one a line, a part larger than
///           the number of vertices, more or fewer lines than vertices
[[nodiscard]] graph::Partition parse_parts(std::string_view text, const std::string& source,
                                           std::size_t vertices);
[[nodiscard]] graph::Partition read_parts(const std::filesystem::path& path, std::size_t vertices);

/// The file appears whole or not at all. throws OutputError
void write_parts(const std::filesystem::path& path, const graph::Partition& partition);

}  // namespace leonhard::app
