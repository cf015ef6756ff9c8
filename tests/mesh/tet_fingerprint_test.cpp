// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "leonhard/mesh/fingerprint.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

TEST_CASE("fingerprint_of_tetrahedra_ignores_numbering_and_the_order_of_corners") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const Fingerprint expected = mesh::fingerprint(entry.mesh);
    TetMesh mesh = entry.mesh;
    std::mt19937 random(5);
    std::vector<std::size_t> new_of_old(mesh.vertex_count());
    for (std::size_t i = 0; i < new_of_old.size(); ++i) new_of_old[i] = i;
    std::shuffle(new_of_old.begin(), new_of_old.end(), random);
    for (const VertexId v : entry.mesh.points.ids())
      mesh.points[VertexId::from(new_of_old[v.index()])] = entry.mesh.points[v];
    for (auto& corners : mesh.corners) {
      for (VertexId& v : corners) v = VertexId::from(new_of_old[v.index()]);
      std::shuffle(corners.begin(), corners.end(), random);
    }
    std::shuffle(mesh.corners.begin(), mesh.corners.end(), random);
    CHECK(mesh::fingerprint(mesh) == expected);
  }
}

TEST_CASE("fingerprint_of_tetrahedra_changes_with_one_unit_in_the_last_place_of_any_coordinate") {
  const auto mesh = tet_shelf::shaken_box(2, 2);
  std::set<std::string> seen{mesh::fingerprint(mesh).hex()};
  for (const VertexId v : mesh.points.ids()) {
    for (double Point3::*coordinate : {&Point3::x, &Point3::y, &Point3::z}) {
      auto moved = mesh;
      moved.points[v].*coordinate = std::nextafter(moved.points[v].*coordinate, 1e9);
      CHECK(seen.insert(mesh::fingerprint(moved).hex()).second);
    }
  }
}

TEST_CASE("fingerprint_of_tetrahedra_changes_when_one_goes_and_takes_minus_zero_as_zero") {
  auto mesh = tet_shelf::box(2, 1, 1);
  const auto before = mesh::fingerprint(mesh);
  auto fewer = mesh;
  fewer.corners.flat().pop_back();
  CHECK(mesh::fingerprint(fewer) != before);
  for (Point3& p : mesh.points) {
    if (p.z == 0) p.z = -0.0;
  }
  CHECK(mesh::fingerprint(mesh) == before);
}

// The numbers come from a second implementation, in Python with integers of any size. They may only change with the
// definition of the fingerprint, which makes all fingerprints ever reported worthless.
TEST_CASE("fingerprint_of_tetrahedra_is_the_one_that_was_published") {
  CHECK(mesh::fingerprint(tet_shelf::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}))
            .hex() == "6186d86ea398790991b67848c66a8da5");
  CHECK(mesh::fingerprint(tet_shelf::box(3, 2, 4)).hex() == "94dc28bdccdca2716680b609020186e8");
}
