// SPDX-License-Identifier: MIT
// Point sets of space from bytes, on small integer grids, of nearly tenths or of raw doubles, through both algorithms, with
// another order and another seed: the same outcome, and the same mesh to the last bit. The public validators find nothing
// wrong with it, Euler's account balances, and the volumes agree in rational arithmetic.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/tet_euler.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;

std::vector<Point3> points_from(fuzzing::Input& in) {
  const unsigned kind = in.take<std::uint8_t>() % 4;  // 0 to 2: as fuzzing::Input has them; 3: a small grid
  const unsigned grid = 2 + in.take<std::uint8_t>() % 4;
  const std::size_t count = in.take<std::uint8_t>() % 49;
  const auto grid_coordinate = [&] { return static_cast<double>(in.take<std::uint8_t>() % grid); };
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    Point3 p;
    if (kind < 3) {
      p = in.point3(kind);
    } else {
      p.x = grid_coordinate();
      p.y = grid_coordinate();
      p.z = grid_coordinate();
    }
    points.push_back(p);
  }
  return points;
}

void require(bool holds, const std::string& broken, const std::vector<Point3>& points) {
  if (!holds) fuzzing::report(broken.c_str(), points);
}

void check_mesh(const TetMesh& mesh, const std::vector<Point3>& points) {
  for (const auto& broken : {mesh::validate(mesh), mesh::validate_delaunay(mesh)})
    require(!broken, broken.value_or(""), points);
  require(mesh::euler_account(mesh, mesh::build_faces(mesh), mesh::build_edges(mesh)).balances(),
          "Euler's account does not balance", points);
  require(mesh::exact_volume6(mesh) == mesh::exact_boundary_volume6(mesh), "the volumes differ", points);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input in(data, size);
  delaunay::TetrahedralizeOptions options;
  options.seed = in.take<std::uint8_t>();
  const std::vector<Point3> points = points_from(in);
  const delaunay::Tetrahedralization expected = delaunay::tetrahedralize(points);
  if (expected.outcome == delaunay::TetrahedralizeOutcome::done) check_mesh(expected.mesh, points);
  for (const delaunay::NamedTetAlgorithm& named : delaunay::named_tet_algorithms) {
    options.algorithm = named.algorithm;
    const delaunay::Tetrahedralization result = delaunay::tetrahedralize(points, options);
    require(result.outcome == expected.outcome && result.mesh == expected.mesh,
            std::string(named.name) + " gives other tetrahedra", points);
  }
  std::vector<Point3> reversed(points.rbegin(), points.rend());
  options.sorted = false;
  options.algorithm = delaunay::TetAlgorithm::insertion;
  require(
      mesh::fingerprint(delaunay::tetrahedralize(reversed, options).mesh) == mesh::fingerprint(expected.mesh),
      "the reverse order gives other tetrahedra", points);
  return 0;
}
