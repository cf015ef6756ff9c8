// SPDX-License-Identifier: MIT
// The figures of section 2.3 on partitioning: the mesh about the airfoil in 16 parts, and its Fiedler vector.
#include <algorithm>
#include <cmath>
#include <string>

#include "figures.hpp"
#include "flap_mesh.hpp"
#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"

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

}  // namespace

std::vector<Figure> partition_figures() {
  return {{"2.3.2", "Coordinate bisection, 16 partitions", nullptr, 1, coordinate_bisection},
          {"2.3.3", "Cuthill-McKee partitioning, 16 partitions", nullptr, 1, cuthill_mckee_partitioning},
          {"2.3.4", "Spectral partitioning, 16 partitions", nullptr, 1, spectral_partitioning},
          {"2.3.6", "Contours of the Fiedler vector, dashed below the median", nullptr, 1, fiedler_contours}};
}

}  // namespace leonhard::notes
