// SPDX-License-Identifier: MIT
#include "leonhard/mesh/fingerprint.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "leonhard/mesh/permute.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;

TEST_CASE_TEMPLATE("fingerprint_ignores_numbering_of_vertices_cells_and_corners", Mesh, TriangleMesh,
                   TetMesh) {
  unsigned seed = 1;
  for (const auto& entry : shelves::all<Mesh>()) {
    const Mesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const Fingerprint expected = mesh::fingerprint(mesh);
    auto renumbered = mesh::renumber_vertices(mesh, shelves::random_permutation(mesh.vertex_count(), ++seed));
    CHECK(mesh::fingerprint(renumbered) == expected);
    std::mt19937 random(seed);
    std::shuffle(renumbered.corners.begin(), renumbered.corners.end(), random);
    for (auto& corners : renumbered.corners) std::shuffle(corners.begin(), corners.end(), random);
    CHECK(mesh::fingerprint(renumbered) == expected);
  }
}

TEST_CASE_TEMPLATE("fingerprint_changes_with_one_unit_in_the_last_place_of_any_coordinate", Mesh,
                   TriangleMesh, TetMesh) {
  using Point = typename Mesh::Point;
  const auto mesh = shelves::shaken<Mesh>(shelves::is_plane<Mesh> ? 5 : 2, 2);
  std::vector<double Point::*> coordinates{&Point::x, &Point::y};
  if constexpr (!shelves::is_plane<Mesh>) coordinates.push_back(&Point::z);
  std::set<std::string> seen{mesh::fingerprint(mesh).hex()};
  for (const VertexId v : mesh.points.ids()) {
    for (const auto coordinate : coordinates) {
      for (const double towards : {-1e9, 1e9}) {
        auto moved = mesh;
        moved.points[v].*coordinate = std::nextafter(moved.points[v].*coordinate, towards);
        CHECK(seen.insert(mesh::fingerprint(moved).hex()).second);
      }
    }
  }
}

TEST_CASE_TEMPLATE("fingerprint_changes_when_a_cell_goes_or_comes_twice_and_takes_minus_zero_as_zero", Mesh,
                   TriangleMesh, TetMesh) {
  auto mesh = shelves::regular<Mesh>(2);
  const auto before = mesh::fingerprint(mesh);
  auto fewer = mesh;
  fewer.corners.flat().pop_back();
  CHECK(mesh::fingerprint(fewer) != before);
  auto twice = mesh;
  twice.corners.push_back(twice.corners.flat()[0]);
  CHECK(mesh::fingerprint(twice) != before);
  for (auto& p : mesh.points) {
    if (p.x == 0) p.x = -0.0;
    if (p.y == 0) p.y = -0.0;
    if constexpr (!shelves::is_plane<Mesh>)
      if (p.z == 0) p.z = -0.0;
  }
  CHECK(mesh::fingerprint(mesh) == before);
}

TEST_CASE("fingerprint_changes_when_an_edge_is_flipped") {
  auto mesh = shelf::grid(3, 3);
  const auto before = mesh::fingerprint(mesh);
  const auto [a, b, c] = mesh.corners[TriangleId{0}];
  const VertexId d = mesh.corners[TriangleId{1}][2];
  mesh.corners[TriangleId{0}] = {a, b, d};
  mesh.corners[TriangleId{1}] = {b, c, d};
  CHECK(mesh::fingerprint(mesh) != before);
}

TEST_CASE("fingerprints_of_different_meshes_differ_in_about_half_their_bits") {
  std::vector<Fingerprint> prints;
  for (unsigned seed = 0; seed < 40; ++seed) prints.push_back(mesh::fingerprint(shelf::shaken_grid(3, seed)));
  double sum = 0;
  int pairs = 0;
  for (std::size_t i = 0; i < prints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++pairs) {
      const int bits = __builtin_popcountll(prints[i].hi ^ prints[j].hi) +
                       __builtin_popcountll(prints[i].lo ^ prints[j].lo);
      CHECK(bits > 32);
      sum += bits;
    }
  }
  CHECK(sum / pairs == doctest::Approx(64).epsilon(0.02));
}

// The numbers come from a second implementation, 20 lines of Python with integers of any size. They may only change
// with the definition of the fingerprint, which makes all fingerprints ever reported worthless.
TEST_CASE("fingerprint_is_the_one_that_was_published") {
  CHECK(mesh::fingerprint(shelf::grid(2, 1)).hex() == "efcf0940616e5f088dcad2fb7df2d0b7");
  CHECK(mesh::fingerprint(shelf::grid(7, 4)).hex() == "b283323d077479d4a74b54cd055976f3");
  CHECK(mesh::fingerprint(tet_shelf::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}))
            .hex() == "6186d86ea398790991b67848c66a8da5");
  CHECK(mesh::fingerprint(tet_shelf::box(3, 2, 4)).hex() == "94dc28bdccdca2716680b609020186e8");
}

TEST_CASE("hex_has_32_digits_high_half_first") {
  CHECK(Fingerprint{0x0123456789abcdefU, 0xfU}.hex() == "0123456789abcdef000000000000000f");
}
