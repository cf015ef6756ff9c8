// SPDX-License-Identifier: MIT
// The figures of section 2.3 on partitioning: the mesh about the airfoil in 16 parts, and its Fiedler vector.
#include <algorithm>
#include <cmath>
#include <string>

#include "figures.hpp"
#include "flap_mesh.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/edges.hpp"

namespace leonhard::notes {
namespace {

std::vector<Point2> centroids(const TriangleMesh& mesh) {
  std::vector<Point2> points;
  for (const TriangleId t : mesh.corners.ids()) points.push_back(centroid(corners(mesh, t)));
  return points;
}

void draw_parts(const std::filesystem::path& file, const std::string& title, const graph::Partition& parts) {
  draw::draw_partition(file, flap_mesh(), parts.part_of, parts.parts, {.view = close_up, .title = title});
}
void coordinate_bisection(const std::filesystem::path& file, const std::string& title) {
  draw_parts(file, title, graph::recursive_coordinate_bisection(centroids(flap_mesh()), 16));
}
void cuthill_mckee_partitioning(const std::filesystem::path& file, const std::string& title) {
  draw_parts(file, title,
             graph::recursive_cuthill_mckee_bisection(
                 graph::dual_graph(flap_mesh()), 16, graph::CuthillMcKeeCut::level_set, {.imbalance = 0.03}));
}
void spectral_partitioning(const std::filesystem::path& file, const std::string& title) {
  draw_parts(file, title, graph::recursive_spectral_bisection(graph::dual_graph(flap_mesh()), 16));
}

/// Values of triangles as values of vertices: the mean over a vertex's triangles.
std::vector<double> at_vertices(const TriangleMesh& mesh, const std::vector<double>& of_triangles) {
  std::vector<double> sum(mesh.vertex_count(), 0), count(mesh.vertex_count(), 0);
  for (const TriangleId t : mesh.corners.ids())
    for (const VertexId v : mesh.corners[t]) {
      sum[v.index()] += of_triangles[t.index()];
      ++count[v.index()];
    }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= count[v];
  return sum;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Level sets of the dual graph's Fiedler vector less its median, where spectral bisection cuts.
void fiedler_contours(const std::filesystem::path& file, const std::string& title) {
  std::vector<double> values = graph::fiedler(graph::dual_graph(flap_mesh())).vector;
  const double middle = median(values);
  double largest = 0;
  for (double& value : values) {
    value -= middle;
    largest = std::max(largest, std::abs(value));
  }
  draw::draw_field(file, flap_mesh(), at_vertices(flap_mesh(), values),
                   {.title = title,
                    .value_label = "entry less the median",
                    .colour_map = draw::ColourMap::diverging,
                    .value_range = draw::Range{-largest, largest},
                    .bands = 30,
                    .dashed_below = 0});
}

/// A graph whose vertices are coloured by the side of the median on which their entry of the Fiedler vector lies: the
/// edges between colours are cut, and the separator runs through their midpoints from triangle to triangle.
std::vector<draw::Diagram> two_colouring() {
  const TriangleMesh mesh = delaunay::triangulate(random_sites(44, 11, 0.09)).mesh;
  const EdgeStructure edges = mesh::build_edges(mesh);
  const std::vector<double> vector = graph::fiedler(graph::vertex_graph(mesh, edges)).vector;
  const double middle = median(vector);
  const auto above = [&](VertexId v) { return vector[v.index()] >= middle; };
  draw::Diagram diagram;
  std::size_t cut = 0;
  for (const EdgeId e : edges.ends.ids()) {
    const auto [a, b] = edges.ends[e];
    const bool is_cut = above(a) != above(b);
    cut += is_cut ? 1 : 0;
    diagram.add_segment(mesh.points[a], mesh.points[b], is_cut ? dashed : thin);
  }
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& corner = mesh.corners[t];
    std::vector<Point2> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = corner[i], b = corner[(i + 1) % 3];
      const Point2 both[]{mesh.points[a], mesh.points[b]};
      if (above(a) != above(b)) ends.push_back(centroid(both));
    }
    if (ends.size() == 2) diagram.add_segment(ends[0], ends[1], {.colour = second, .width = 3.5});
  }
  for (const VertexId v : mesh.points.ids())
    diagram.add_named_dot(mesh.points[v], above(v) ? "+1" : "-1", {0.75, 0.75}, above(v) ? accent : second);
  const auto first = static_cast<std::size_t>(std::count_if(vector.begin(), vector.end(), [&](double x) {
    return x >= middle;
  }));
  diagram.title = std::to_string(first) + " and " + std::to_string(vector.size() - first) + " vertices, " +
                  std::to_string(cut) + " edges cut (dashed); the separator in blue";
  return {diagram};
}

}  // namespace

std::vector<Figure> partition_figures() {
  return {{"2.3.2", "Coordinate bisection, 16 partitions", nullptr, 1, coordinate_bisection},
          {"2.3.3", "Cuthill-McKee partitioning, 16 partitions", nullptr, 1, cuthill_mckee_partitioning},
          {"2.3.4", "Spectral partitioning, 16 partitions", nullptr, 1, spectral_partitioning},
          {"2.3.5", "A graph in two colours, its separator and its cut edges", two_colouring},
          {"2.3.6", "Contours of the Fiedler vector, dashed below the median", nullptr, 1, fiedler_contours}};
}

}  // namespace leonhard::notes
