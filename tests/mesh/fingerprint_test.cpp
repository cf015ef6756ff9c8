// SPDX-License-Identifier: MIT
#include "leonhard/mesh/fingerprint.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "leonhard/mesh/permute.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

PerId<VertexId, VertexId> random_permutation(std::size_t count, unsigned seed) {
  PerId<VertexId, VertexId> permutation;
  for (std::size_t i = 0; i < count; ++i) permutation.push_back(VertexId::from(i));
  std::shuffle(permutation.begin(), permutation.end(), std::mt19937(seed));
  return permutation;
}

}  // namespace

TEST_CASE("fingerprint_ignores_numbering_of_vertices_triangles_and_corners") {
  unsigned seed = 1;
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const Fingerprint expected = mesh::fingerprint(mesh);
    auto renumbered = mesh::renumber_vertices(mesh, random_permutation(mesh.vertex_count(), ++seed));
    CHECK(mesh::fingerprint(renumbered) == expected);
    std::shuffle(renumbered.corners.begin(), renumbered.corners.end(), std::mt19937(seed));
    for (auto& c : renumbered.corners) c = {c[2], c[0], c[1]};
    CHECK(mesh::fingerprint(renumbered) == expected);
  }
}

TEST_CASE("fingerprint_changes_with_one_unit_in_the_last_place_of_any_coordinate") {
  const auto mesh = shelf::shaken_grid(5, 2);
  std::set<std::string> seen{mesh::fingerprint(mesh).hex()};
  for (const VertexId v : mesh.points.ids()) {
    for (double Point2::*coordinate : {&Point2::x, &Point2::y}) {
      for (const double towards : {-1e9, 1e9}) {
        auto moved = mesh;
        moved.points[v].*coordinate = std::nextafter(moved.points[v].*coordinate, towards);
        CHECK(seen.insert(mesh::fingerprint(moved).hex()).second);
      }
    }
  }
}

TEST_CASE("fingerprint_changes_when_a_triangle_goes_or_an_edge_is_flipped") {
  auto mesh = shelf::grid(3, 3);
  const auto before = mesh::fingerprint(mesh);
  auto fewer = mesh;
  fewer.corners.flat().pop_back();
  CHECK(mesh::fingerprint(fewer) != before);
  auto twice = mesh;
  twice.corners.push_back(twice.corners[TriangleId{0}]);
  CHECK(mesh::fingerprint(twice) != before);
  const auto [a, b, c] = mesh.corners[TriangleId{0}];
  const VertexId d = mesh.corners[TriangleId{1}][2];
  mesh.corners[TriangleId{0}] = {a, b, d};
  mesh.corners[TriangleId{1}] = {b, c, d};
  CHECK(mesh::fingerprint(mesh) != before);
}

TEST_CASE("fingerprint_takes_minus_zero_as_zero") {
  auto mesh = shelf::grid(2, 2);
  const auto before = mesh::fingerprint(mesh);
  for (Point2& p : mesh.points) {
    if (p.x == 0) p.x = -0.0;
    if (p.y == 0) p.y = -0.0;
  }
  CHECK(mesh::fingerprint(mesh) == before);
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
}

TEST_CASE("hex_has_32_digits_high_half_first") {
  CHECK(Fingerprint{0x0123456789abcdefU, 0xfU}.hex() == "0123456789abcdef000000000000000f");
}
