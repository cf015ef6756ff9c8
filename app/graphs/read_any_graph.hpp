// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/mesh/io/any_mesh_file.hpp"

namespace leonhard::app {

/// Which graph of a mesh is meant: that of its vertices and edges, or the dual graph of its cells.
enum class GraphOf { vertices, cells };

/// A graph, be it from a file of graphs or that of a mesh.
struct AnyGraph {
  graph::CsrGraph graph;
  std::vector<Point3>
      coordinates;            ///< of the graph's vertices (cells: of their centroids); empty if not known
  std::uint32_t dimension{};  ///< of the coordinates, 2 or 3; 0 if not known
  std::optional<AnyMeshFile> file;  ///< where it came from a mesh, its warnings moved to this one's

  std::uint32_t weights_each{};                            ///< as graph::GraphFile
  std::vector<std::int64_t> vertex_weights, edge_weights;  ///< as graph::GraphFile; of meshes none

  std::size_t self_loops{}, parallel_edges{};
  std::uint32_t components{};
  std::vector<std::string> warnings;

  [[nodiscard]] const TriangleMesh* triangles() const {
    return file ? std::get_if<TriangleMesh>(&file->mesh) : nullptr;
  }
  [[nodiscard]] const TetMesh* tets() const { return file ? std::get_if<TetMesh>(&file->mesh) : nullptr; }
  [[nodiscard]] bool has_mesh() const { return file.has_value(); }
};

/// Read a mesh of the plane or of space, or a graph, format by extension. Coordinates of a graph's vertices come from
/// the .xyz file of its name, if there is one.
///
/// which    of the graphs of a mesh; a graph file has but one
/// options  of a mesh
/// throws  InputError as the readers do
[[nodiscard]] AnyGraph read_any_graph(const std::filesystem::path& path, GraphOf which = GraphOf::vertices,
                                      const io::ReadOptions& options = {});

/// Whether the extension is that of a graph and not of a mesh.
[[nodiscard]] bool is_graph_file(const std::filesystem::path& path);

/// What the graph's vertices are: "triangles", "tetrahedra" or "cells" of a mesh's dual graph, else "vertices".
[[nodiscard]] std::string_view vertices_are(const AnyGraph& graph, GraphOf which);

/// The graph's size in a line, and what its vertices are.
[[nodiscard]] std::string graph_text(std::uint64_t vertices, std::uint64_t edges, std::string_view of);

/// Counts of a graph, with which the report of `order` begins.
[[nodiscard]] Json graph_report(const std::string& input, const AnyGraph& graph);

}  // namespace leonhard::app
