// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::app {

/// Which graph of a mesh is meant.
enum class GraphOf { vertices, cells };

/// A graph, be it from a file of graphs or that of a mesh.
struct AnyGraph {
  graph::CsrGraph graph;
  std::vector<Point3>
      coordinates;  ///< of the graph's vertices (cells: of their centroids); empty if not known
  std::optional<TriangleMesh> mesh;  ///< where it came from a mesh
  std::size_t self_loops{}, parallel_edges{};
  std::uint32_t components{};
  std::vector<std::string> warnings;
};

/// Read a mesh or a graph, format by extension. Coordinates of a graph's vertices come from the .xyz file of its name,
/// if there is one.
///
/// throws  InputError as the readers do, and for the cells of a graph
[[nodiscard]] AnyGraph read_any_graph(const std::filesystem::path& path, GraphOf which = GraphOf::vertices);

/// Counts of a graph, with which the reports of `order` and `partition` begin.
[[nodiscard]] Json graph_report(const std::string& input, const AnyGraph& graph);

}  // namespace leonhard::app
