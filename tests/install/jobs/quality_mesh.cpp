// SPDX-License-Identifier: MIT
// A mesh of a square with a hole whose triangles are no thinner and no larger than asked.
#include <leonhard/delaunay/refine.hpp>
#include <leonhard/mesh/edges.hpp>
#include <leonhard/mesh/euler.hpp>
#include <leonhard/mesh/quality.hpp>

#include "check.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}};
  square.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}, {4, 5, 2}, {5, 6, 2}, {6, 7, 2}, {7, 4, 2}};
  square.holes = {{0.5, 0.5}};
  const auto refined = delaunay::mesh_pslg(square, {.min_angle_deg = 30, .size = [](Point2 p) { return 0.03 + 0.1 * p.x; }});
  claim(refined.report.outcome == delaunay::RefineOutcome::achieved, "every bound is met");
  const MeshQuality quality = mesh::quality(refined.mesh);
  claim(quality.min_angle_deg >= 30, "no angle is below 30 degrees");
  claim(quality.total_area > 0.7499 && quality.total_area < 0.7501, "the domain is covered");
  for (const MarkedEdge& edge : refined.mesh.boundary) claim(edge.marker == 1 || edge.marker == 2, "markers are kept");
  claim(mesh::euler_account(refined.mesh, mesh::build_edges(refined.mesh)).holes == 1, "it has its hole");
  return claim.failed();
}
