// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/read_any_graph.hpp"

#include <algorithm>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"

namespace leonhard::app {
namespace {

AnyGraph graph_of_file(const std::filesystem::path& path) {
  graph::GraphFile file = graph::read_graph(path);
  AnyGraph result;
  if (auto found = graph::read_coordinates_beside(path, graph::vertex_count(file.graph)))
    result.coordinates = std::move(found->points);
  result.graph = std::move(file.graph);
  result.self_loops = file.self_loops;
  result.parallel_edges = file.parallel_edges;
  result.components = file.components;
  result.warnings = std::move(file.warnings);
  return result;
}

Point3 centroid(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
  return {p.x / 3 + q.x / 3 + r.x / 3, p.y / 3 + q.y / 3 + r.y / 3, 0};
}

AnyGraph graph_of_mesh(const std::filesystem::path& path, GraphOf which) {
  MeshFile file = io::read_mesh(path);
  AnyGraph result;
  if (which == GraphOf::vertices) {
    result.graph = graph::vertex_graph(file.mesh, mesh::build_edges(file.mesh));
    for (const Point2 p : file.mesh.points) result.coordinates.push_back({p.x, p.y, 0});
  } else {
    result.graph = graph::dual_graph(file.mesh);
    for (const TriangleId t : file.mesh.corners.ids()) result.coordinates.push_back(centroid(file.mesh, t));
  }
  result.components = graph::components(result.graph).count();
  result.mesh = std::move(file.mesh);
  result.warnings = std::move(file.warnings);
  return result;
}

}  // namespace

AnyGraph read_any_graph(const std::filesystem::path& path, GraphOf which) {
  std::vector<std::string> known = io::mesh_extensions();
  known.insert(known.end(), graph::graph_extensions().begin(), graph::graph_extensions().end());
  const std::string extension = io::known_extension(path, known, "mesh or graph");
  if (std::ranges::count(graph::graph_extensions(), extension) == 0) return graph_of_mesh(path, which);
  if (which == GraphOf::cells)
    throw InputError(path.string(), "is a graph: it has no cells", "leave out --cells, or give a mesh");
  return graph_of_file(path);
}

Json graph_report(const std::string& input, const AnyGraph& graph) {
  return {{"input", input},
          {"vertices", graph::vertex_count(graph.graph)},
          {"edges", graph::edge_count(graph.graph)},
          {"components", graph.components},
          {"self_loops", graph.self_loops},
          {"parallel_edges", graph.parallel_edges}};
}

}  // namespace leonhard::app
