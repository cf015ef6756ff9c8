// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/kernel/point.hpp"

/// Graphs in files. Every reader returns a graph that passes `validate` or throws InputError naming file and line.
namespace leonhard::graph {

/// What a graph file holds.
struct GraphFile {
  CsrGraph graph{};

  std::uint32_t weights_each{};                ///< weights of a vertex: 0 where the file gives none
  std::vector<std::int64_t> vertex_weights{};  ///< weights_each a vertex, vertex after vertex
  std::vector<std::int64_t> edge_weights{};    ///< one a directed edge in the graph's order, or empty

  std::size_t self_loops{};        ///< entries from a vertex to itself (a matrix's diagonal), dropped
  std::size_t parallel_edges{};    ///< repetitions of an edge, dropped; the first one's weight counts
  std::uint32_t components{};      ///< connected components
  std::uint32_t first_number = 1;  ///< the file's number of vertex 0

  std::vector<std::string> warnings{};  ///< what was left out, in words
};

/// Read a graph, format by extension: .graph (METIS), .mtx (Matrix Market), .edges or .csv (a list of edges).
///
/// throws  InputError naming file and line: file missing, empty, binary or cut short, unknown extension, numbers that
///         are none or out of range, an edge that only one of its ends lists or with two weights, wrong counts
/// Cost O(bytes + edges log degree).
[[nodiscard]] GraphFile read_graph(const std::filesystem::path& path);

/// ".graph", ".mtx", ".edges", ".csv": what read_graph knows.
[[nodiscard]] const std::vector<std::string>& graph_extensions();

/// METIS's format: "vertices edges [flags [weights each]]", then one line a vertex with its weights and neighbours,
/// numbered from 1, an edge's weight after each neighbour where the flags say so. An empty line is a vertex without
/// neighbours; lines that begin with % are comments. Vertex sizes (flag 100) are left out, which a warning tells.
///
/// source  names the text in errors, here and below
[[nodiscard]] GraphFile parse_metis_graph(std::string_view text, const std::string& source);

/// A square Matrix Market matrix in coordinates or as an array, of any field; its values are left out, zeros of an array being
/// no entries. A `general` matrix must be symmetric in structure; the other symmetries need one entry of each pair only. The
/// banner may begin with one % or two.
[[nodiscard]] GraphFile parse_matrix_market(std::string_view text, const std::string& source);

/// One edge a line, two vertices and an optional weight on every line, separated by semicolons, commas, tabs or blanks; # and
/// % start comments; a first line that begins with a letter is a header. If it names two columns source and target (from and
/// to, ...), in any order, these are read, and weight if there is one; the others are left out.
///
/// Vertices are numbered from 0, or from 1 where none is 0; there are as many as the largest number asks for. Where they have
/// names they are numbered in the order in which these come. Weights that are no whole numbers are scaled and rounded. The
/// warnings tell each of these.
[[nodiscard]] GraphFile parse_edge_list(std::string_view text, const std::string& source);

/// METIS's format, with whichever weights are given.
///
/// vertex_weights  the same number for each vertex, not negative; or empty
/// edge_weights    one a directed edge in the graph's order, positive, the same in both directions; or empty
/// throws          InputError for weights that do not fit the graph or the format
[[nodiscard]] std::string format_metis_graph(const CsrGraph& graph,
                                             std::span<const std::int64_t> vertex_weights = {},
                                             std::span<const std::int64_t> edge_weights = {});

/// Write a .graph file; it appears whole or not at all.
///
/// throws  InputError for another extension, OutputError if the file cannot be written
void write_graph(const std::filesystem::path& path, const CsrGraph& graph);

/// Where a graph's vertices lie.
struct VertexCoordinates {
  std::uint32_t dimension{};   ///< 2 or 3
  std::vector<Point3> points;  ///< one a vertex; z is 0 in the plane
};

/// Coordinates as the graph collections give them: one line a vertex of two or three columns; or Scotch's form, the
/// dimension and the number of vertices in two lines, then a vertex's number and its coordinates on each line.
///
/// vertices  how many the graph has
/// throws    InputError naming file and line, also if there are more or fewer vertices
[[nodiscard]] VertexCoordinates parse_coordinates(std::string_view text, const std::string& source,
                                                  std::size_t vertices);

/// The coordinates in the file of the graph's name with extension .xyz; none if there is no such file.
[[nodiscard]] std::optional<VertexCoordinates> read_coordinates_beside(
    const std::filesystem::path& graph_file, std::size_t vertices);

}  // namespace leonhard::graph
