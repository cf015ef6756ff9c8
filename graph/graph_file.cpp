// SPDX-License-Identifier: MIT
#include "leonhard/graph/graph_file.hpp"

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::graph {

const std::vector<std::string>& graph_extensions() {
  static const std::vector<std::string> known{".graph", ".mtx", ".edges", ".csv"};
  return known;
}

GraphFile read_graph(const std::filesystem::path& path) {
  const std::string extension = io::known_extension(path, graph_extensions(), "graph");
  const std::string text = io::read_whole_file(path);
  if (extension == ".graph") return parse_metis_graph(text, path.string());
  if (extension == ".mtx") return parse_matrix_market(text, path.string());
  return parse_edge_list(text, path.string());
}

void write_graph(const std::filesystem::path& path, const CsrGraph& graph) {
  static const std::vector<std::string> known{".graph"};
  io::known_extension(path, known, "graph");
  io::write_file_atomically(path, format_metis_graph(graph));
}

std::optional<VertexCoordinates> read_coordinates_beside(const std::filesystem::path& graph_file,
                                                         std::size_t vertices) {
  std::filesystem::path path = graph_file;
  path.replace_extension(".xyz");
  if (!std::filesystem::exists(path)) return std::nullopt;
  return parse_coordinates(io::read_whole_file(path), path.string(), vertices);
}

}  // namespace leonhard::graph
