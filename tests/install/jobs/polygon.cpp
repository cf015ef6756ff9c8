// SPDX-License-Identifier: MIT
// The constrained Delaunay triangulation of a polygon with a hole: no point added.
#include <leonhard/delaunay/triangulate.hpp>
#include <leonhard/mesh/edges.hpp>
#include <leonhard/mesh/euler.hpp>
#include <leonhard/mesh/exact_area.hpp>
#include <leonhard/mesh/validate.hpp>

#include "check.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  Pslg letter;  // an L with a square hole in its foot
  letter.points = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 5}, {0, 5}, {2.5, 0.5}, {3.5, 0.5}, {3.5, 1.5}, {2.5, 1.5}};
  for (std::size_t i = 0; i < 6; ++i) letter.segments.push_back({i, (i + 1) % 6, 1});
  for (std::size_t i = 0; i < 4; ++i) letter.segments.push_back({6 + i, 6 + (i + 1) % 4, 2});
  letter.holes = {{3, 1}};
  const delaunay::Triangulation result = delaunay::triangulate(letter);
  const TriangleMesh& mesh = result.mesh;
  claim(result.outcome == delaunay::TriangulateOutcome::done, "it is done");
  claim(mesh.vertex_count() == 10 && result.vertex_of_input.size() == 10, "no vertex was added");
  claim(mesh.triangle_count() == 10, "n + 2 h - 2 triangles");
  claim(mesh::exact_area2(mesh) == 2 * (4 * 2 + 2 * 3 - 1), "they cover the polygon without its hole");
  claim(!mesh::validate(mesh) && !mesh::validate_delaunay(mesh), "the mesh is valid and constrained Delaunay");
  const EulerAccount account = mesh::euler_account(mesh, mesh::build_edges(mesh));
  claim(account.balances() && account.holes == 1, "Euler's formula holds, with one hole");
  return claim.failed();
}
