// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/app/graphs/read_any_graph.hpp"
#include "leonhard/graph/partition.hpp"

namespace leonhard::app {

/// A file that a partition is to become: .txt, one part a line; .vtu, the mesh with all its fields and its parts
/// as the array `part` of cells or of points; .png, .svg or .pdf, a picture.
struct PartitionOutput {
  std::filesystem::path path;
  std::vector<double> view;  ///< of pictures: as plane_view or space_view take it
  std::string cut;           ///< of pictures of tetrahedra: as parse_cut takes it
};

/// What can be said before the input is read.
///
/// throws  InputError on another extension, a .vtu of a graph file, or a view or a cut of what is no picture
void check_partition_output(const PartitionOutput& output, const std::filesystem::path& input);

/// What can be said before the work.
///
/// source  names the input in errors, here and below
/// throws  InputError on a picture of a graph without coordinates, and on a view or a cut that do not fit
void check_partition_output(const PartitionOutput& output, const AnyGraph& input, GraphOf which,
                            const std::string& source);

/// Write the file. Parts of vertices in space, and of bare graphs, are drawn as graphs (graph_picture.hpp).
///
/// which   what the partition is of, where the input is a mesh. The input's mesh is cut for pictures
/// throws  OutputError
void write_partition(const PartitionOutput& output, AnyGraph& input, GraphOf which,
                     const graph::Partition& partition, const std::string& title);

}  // namespace leonhard::app
