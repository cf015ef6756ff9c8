// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/pslg_file.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/triangle_files.hpp"
#include "leonhard/mesh/io/soup/read_soup.hpp"
#include "leonhard/mesh/io/soup/soup_checks.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// Whether a .poly file leaves its vertices to a .node file.
bool declares_no_vertices(const std::string& poly, const std::string& source) {
  TextScanner scan(poly, source, {.comment = '#'});
  scan.need_line("the number of vertices");
  return scan.integer("the number of vertices") == 0;
}

/// The segments of marked edges, and the points that they use.
class EdgeGraph {
 public:
  explicit EdgeGraph(const PerId<VertexId, Point2>& points) : points_(points), number_(points.size()) {}

  void add(const MixedFacet<2>& edge, Marker marker) {
    const std::size_t from = number_of(edge[0]), to = number_of(edge[1]);
    if (!known_.insert(std::minmax(from, to)).second) return;
    pslg_.segments.push_back({from, to, marker});
  }
  [[nodiscard]] std::size_t segment_count() const { return pslg_.segments.size(); }
  [[nodiscard]] Pslg finish() && { return std::move(pslg_); }

 private:
  std::size_t number_of(VertexId v) {
    if (!number_[v]) {
      number_[v] = pslg_.points.size();
      pslg_.points.push_back(points_[v]);
    }
    return *number_[v];
  }

  const PerId<VertexId, Point2>& points_;
  PerId<VertexId, std::optional<std::size_t>> number_;
  std::set<std::pair<std::size_t, std::size_t>> known_;
  Pslg pslg_;
};

EdgeGraphFile graph_of(const MixedMesh<2>& mesh, const std::string& source) {
  EdgeGraph graph(mesh.points);
  for (const auto& edge : mesh.boundary) graph.add(edge.corners, edge.marker);
  EdgeGraphFile file;
  file.outline_segments = graph.segment_count();
  for (const auto& edge : mesh.inner_facets) graph.add(edge.corners, edge.marker);
  file.pslg = std::move(graph).finish();
  if (file.pslg.segments.empty())
    throw InputError(source, "the file has no edges", "give a mesh of the plane, or the edges of an outline");
  file.pslg.marker_names = mesh.marker_names;
  file.pslg.source = source;
  return file;
}

}  // namespace

const std::vector<std::string>& pslg_extensions() {
  static const std::vector<std::string> known{".poly", ".msh", ".mesh"};
  return known;
}

EdgeGraphFile read_edge_graph(const std::filesystem::path& path) {
  known_extension(path, {".msh", ".mesh"}, "mesh");
  MeshSoup<2> soup = read_soup<2>(path, {});
  if (soup.mesh.kinds.empty()) {
    check_corners_and_places(soup);
    EdgeGraphFile file = graph_of(soup.mesh, path.string());
    file.warnings = std::move(soup.warnings);
    return file;
  }
  MixedMeshFile<2> mesh = assemble_mixed(std::move(soup));
  EdgeGraphFile file = graph_of(mesh.mesh, path.string());
  file.warnings = std::move(mesh.warnings);
  if (std::ranges::any_of(mesh.mesh.regions, [](double region) { return region != 0; }))
    file.warnings.push_back("the regions of its cells are not carried to the graph of its edges");
  return file;
}

Pslg read_pslg(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  return read_pslg(path, warnings);
}

Pslg read_pslg(const std::filesystem::path& path, std::vector<std::string>& warnings) {
  if (known_extension(path, pslg_extensions(), "geometry") != ".poly") {
    EdgeGraphFile file = read_edge_graph(path);
    warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
    return std::move(file.pslg);
  }
  const std::string poly = read_whole_file(path);
  std::filesystem::path node_path = path;
  node_path.replace_extension(".node");
  std::optional<std::string> node;
  if (declares_no_vertices(poly, path.string()) && std::filesystem::exists(node_path))
    node = read_whole_file(node_path);
  return parse_poly(poly, node, path.string(), &warnings);
}

void write_pslg(const std::filesystem::path& path, const Pslg& pslg) {
  known_extension(path, {".poly"}, "geometry");
  write_file_atomically(path, format_poly(pslg));
}

}  // namespace leonhard::io
