// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/read_any_graph.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/tet_mesh_file.hpp"

namespace leonhard::app {
namespace {

/// What graph::read_graph, io::read_mesh and io::read_tet_mesh know.
const std::vector<std::string>& known_extensions() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> all;
    for (const auto* some : {&io::mesh_extensions(), &io::tet_mesh_extensions(), &graph::graph_extensions()})
      for (const std::string& extension : *some)
        if (std::ranges::count(all, extension) == 0) all.push_back(extension);
    return all;
  }();
  return known;
}

AnyGraph graph_of_file(const std::filesystem::path& path) {
  graph::GraphFile file = graph::read_graph(path);
  AnyGraph result;
  if (auto found = graph::read_coordinates_beside(path, graph::vertex_count(file.graph))) {
    result.coordinates = std::move(found->points);
    result.dimension = found->dimension;
  }
  result.graph = std::move(file.graph);
  result.weights_each = file.weights_each;
  result.vertex_weights = std::move(file.vertex_weights);
  result.edge_weights = std::move(file.edge_weights);
  result.self_loops = file.self_loops;
  result.parallel_edges = file.parallel_edges;
  result.components = file.components;
  result.warnings = std::move(file.warnings);
  return result;
}

graph::CsrGraph vertex_graph(const TriangleMesh& mesh) {
  return graph::vertex_graph(mesh, mesh::build_edges(mesh));
}
graph::CsrGraph vertex_graph(const TetMesh& mesh) { return graph::vertex_graph(mesh); }

Point3 in_space(Point2 p) { return {p.x, p.y, 0}; }
Point3 in_space(const Point3& p) { return p; }

/// Divided before they are added, so that no sum overflows.
template <class Points, std::size_t corners>
Point3 centroid(const Points& points, const std::array<VertexId, corners>& cell) {
  constexpr double share = 1.0 / corners;
  Point3 middle{};
  for (const VertexId v : cell) {
    const Point3 p = in_space(points[v]);
    middle = {middle.x + share * p.x, middle.y + share * p.y, middle.z + share * p.z};
  }
  return middle;
}

template <class Mesh>
AnyGraph graph_of_mesh(Mesh&& mesh, std::vector<std::string>&& warnings, std::uint32_t dimension,
                       GraphOf which) {
  AnyGraph result;
  result.dimension = dimension;
  if (which == GraphOf::vertices) {
    result.graph = vertex_graph(mesh);
    for (const auto& p : mesh.points) result.coordinates.push_back(in_space(p));
  } else {
    result.graph = graph::dual_graph(mesh);
    for (const auto& cell : mesh.corners) result.coordinates.push_back(centroid(mesh.points, cell));
  }
  result.components = graph::components(result.graph).count();
  result.mesh = std::forward<Mesh>(mesh);
  result.warnings = std::move(warnings);
  return result;
}

}  // namespace

bool is_graph_file(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::ranges::count(graph::graph_extensions(), extension) > 0;
}

AnyGraph read_any_graph(const std::filesystem::path& path, GraphOf which) {
  io::known_extension(path, known_extensions(), "mesh or graph");
  if (is_graph_file(path)) return graph_of_file(path);
  if (io::file_dimension(path) == 3) {
    TetMeshFile file = io::read_tet_mesh(path);
    return graph_of_mesh(std::move(file.mesh), std::move(file.warnings), 3, which);
  }
  MeshFile file = io::read_mesh(path);
  return graph_of_mesh(std::move(file.mesh), std::move(file.warnings), 2, which);
}

std::string_view vertices_are(const AnyGraph& graph, GraphOf which) {
  if (which == GraphOf::vertices || !graph.has_mesh()) return "vertices";
  return graph.triangles() != nullptr ? "triangles" : "tetrahedra";
}

std::string graph_text(std::uint64_t vertices, std::uint64_t edges, std::string_view of) {
  return fmt::format("{:<12}{} vertices{}, {} edges\n", "graph", grouped(vertices),
                     of == "vertices" ? std::string() : fmt::format(" (the {})", of), grouped(edges));
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
