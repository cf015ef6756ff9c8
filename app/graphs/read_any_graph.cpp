// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/read_any_graph.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "leonhard/app/console.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/extension.hpp"

namespace leonhard::app {
namespace {

/// What graph::read_graph and io::read_any_mesh know.
const std::vector<std::string>& known_extensions() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> all;
    for (const auto* some : {&io::any_mesh_extensions(), &graph::graph_extensions()})
      for (const std::string& extension : *some)
        if (std::ranges::count(all, extension) == 0) all.push_back(extension);
    return all;
  }();
  return known;
}

/// Of several weights a vertex the first one; zeros, which no partition takes, become as good as nothing.
void simplify_weights(graph::GraphFile& file, const std::string& source) {
  std::vector<std::int64_t>& weights = file.vertex_weights;
  if (file.weights_each > 1) {
    file.warnings.push_back(
        fmt::format("{}: {} weights a vertex; the first one is used", source, file.weights_each));
    const std::size_t count = weights.size() / file.weights_each;
    for (std::size_t v = 0; v < count; ++v) weights[v] = weights[v * file.weights_each];
    weights.resize(count);
    file.weights_each = 1;
  }
  constexpr std::int64_t factor = 1000;
  for (std::vector<std::int64_t>* some : {&weights, &file.edge_weights}) {
    const auto zeros = std::ranges::count(*some, 0);
    if (zeros == 0) continue;
    for (std::int64_t& weight : *some) weight = weight == 0 ? 1 : factor * weight;
    file.warnings.push_back(fmt::format("{}: {} weights of 0 count as a thousandth of 1", source, zeros));
  }
}

AnyGraph graph_of_file(const std::filesystem::path& path) {
  graph::GraphFile file = graph::read_graph(path);
  simplify_weights(file, path.string());
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
template <class Mesh>
graph::CsrGraph vertex_graph(const Mesh& mesh) {
  return graph::vertex_graph(mesh);
}

Point3 in_space(Point2 p) { return {p.x, p.y, 0}; }
Point3 in_space(const Point3& p) { return p; }

/// Divided before they are added, so that no sum overflows.
template <class Points, class Corners>
Point3 centroid(const Points& points, const Corners& cell) {
  const double share = 1.0 / static_cast<double>(cell.size());
  Point3 middle{};
  for (const VertexId v : cell) {
    const Point3 p = in_space(points[v]);
    middle = {middle.x + share * p.x, middle.y + share * p.y, middle.z + share * p.z};
  }
  return middle;
}

template <int Dim>
std::vector<Point3> centroids(const SimplexMesh<Dim>& mesh) {
  std::vector<Point3> places;
  for (const auto& cell : mesh.corners) places.push_back(centroid(mesh.points, cell));
  return places;
}
template <int Dim>
std::vector<Point3> centroids(const MixedMesh<Dim>& mesh) {
  std::vector<Point3> places;
  for (const CellId cell : mesh.kinds.ids()) places.push_back(centroid(mesh.points, mesh.corners_of(cell)));
  return places;
}

template <class Mesh>
void add_graph_of(AnyGraph& result, const Mesh& mesh, GraphOf which) {
  if (which == GraphOf::vertices) {
    result.graph = vertex_graph(mesh);
    for (const auto& p : mesh.points) result.coordinates.push_back(in_space(p));
  } else {
    result.graph = graph::dual_graph(mesh);
    result.coordinates = centroids(mesh);
  }
}

AnyGraph graph_of_mesh(AnyMeshFile&& file, GraphOf which) {
  AnyGraph result;
  result.dimension = static_cast<std::uint32_t>(file.dimension());
  std::visit([&](const auto& mesh) { add_graph_of(result, mesh, which); }, file.mesh);
  result.components = graph::components(result.graph).count();
  result.warnings = std::move(file.warnings);
  file.warnings.clear();
  result.file = std::move(file);
  return result;
}

}  // namespace

bool is_graph_file(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::ranges::count(graph::graph_extensions(), extension) > 0;
}

AnyGraph read_any_graph(const std::filesystem::path& path, GraphOf which, const io::ReadOptions& options) {
  io::known_extension(path, known_extensions(), "mesh or graph");
  if (is_graph_file(path)) return graph_of_file(path);
  return graph_of_mesh(io::read_any_mesh(path, options), which);
}

std::string_view vertices_are(const AnyGraph& graph, GraphOf which) {
  if (which == GraphOf::vertices || !graph.has_mesh()) return "vertices";
  return graph.triangles() != nullptr ? "triangles" : graph.tets() != nullptr ? "tetrahedra" : "cells";
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
