// SPDX-License-Identifier: MIT
// The Delaunay tetrahedra of a lattice, checked by means that do not trust the mesher.
#include <leonhard/delaunay/tetrahedralize.hpp>
#include <leonhard/mesh/exact_volume.hpp>
#include <leonhard/mesh/tet_euler.hpp>
#include <leonhard/mesh/tet_quality.hpp>
#include <leonhard/mesh/validate.hpp>
#include <vector>

#include "check.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  std::vector<Point3> points;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 5; ++k) points.push_back({double(i), double(j), double(k)});
  points.push_back({0, 0, 0});  // again
  const auto [outcome, mesh, vertex_of_input, repairs] = delaunay::tetrahedralize(points);
  claim(outcome == delaunay::TetrahedralizeOutcome::done, "it is done");
  claim(mesh.vertex_count() == 125 && vertex_of_input.back() == vertex_of_input.front() && repairs.size() == 1,
        "a point given twice is one vertex");
  claim(!mesh::validate(mesh) && !mesh::validate_delaunay(mesh) && !mesh::validate_convex(mesh),
        "the mesh is the Delaunay tetrahedralisation of its points");
  claim(mesh::exact_volume6(mesh) == 6 * 64, "its volume is the cube's");
  claim(mesh::euler_account(mesh, mesh::build_faces(mesh), mesh::build_edges(mesh)).balances(), "Euler's formula holds");
  return claim.failed();
}
