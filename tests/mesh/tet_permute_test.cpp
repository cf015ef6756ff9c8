// SPDX-License-Identifier: MIT
#include "leonhard/mesh/permute.hpp"

#include <doctest/doctest.h>

#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

PerId<VertexId, VertexId> random_permutation(std::size_t count, unsigned seed) {
  PerId<VertexId, VertexId> permutation;
  for (std::size_t i = 0; i < count; ++i) permutation.push_back(VertexId::from(i));
  std::shuffle(permutation.begin(), permutation.end(), std::mt19937(seed));
  return permutation;
}

PerId<VertexId, VertexId> inverse(const PerId<VertexId, VertexId>& permutation) {
  PerId<VertexId, VertexId> result(permutation.size());
  for (const VertexId v : permutation.ids()) result[permutation[v]] = v;
  return result;
}

/// A mesh in which every array has something to say.
TetMesh marked_box() {
  TetMesh mesh = tet_shelf::shaken_box(3, 7);
  for (const VertexId v : mesh.points.ids()) mesh.vertex_markers[v] = static_cast<Marker>(v.raw % 5);
  for (const TetId t : mesh.corners.ids()) mesh.regions[t] = static_cast<double>(t.raw % 7);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) mesh.boundary[i].marker = static_cast<Marker>(i % 3);
  for (std::size_t i = 0; i < 4; ++i) {
    if (mesh.neighbours[TetId{40}][i])
      mesh.interfaces.push_back(
          {{mesh.corners[TetId{40}][tet_face_corners[i][0]], mesh.corners[TetId{40}][tet_face_corners[i][1]],
            mesh.corners[TetId{40}][tet_face_corners[i][2]]},
           9});
  }
  return mesh;
}

}  // namespace

TEST_CASE("renumbered_tetrahedra_are_the_same_and_the_way_back_is_exact") {
  const TetMesh mesh = marked_box();
  REQUIRE(mesh.interfaces.size() > 1);
  REQUIRE_FALSE(mesh::validate(mesh));
  const auto permutation = random_permutation(mesh.vertex_count(), 3);
  const TetMesh kept = mesh::renumber_vertices(mesh, permutation, mesh::CellOrder::kept);
  CHECK(mesh::validate(kept).value_or("") == "");
  CHECK(mesh::fingerprint(kept) == mesh::fingerprint(mesh));
  CHECK(kept.regions == mesh.regions);
  CHECK(kept.neighbours == mesh.neighbours);
  for (const VertexId v : mesh.points.ids()) {
    CHECK(kept.points[permutation[v]] == mesh.points[v]);
    CHECK(kept.vertex_markers[permutation[v]] == mesh.vertex_markers[v]);
  }
  CHECK(kept.boundary[5].marker == mesh.boundary[5].marker);
  CHECK(kept.boundary[5].corners[1] == permutation[mesh.boundary[5].corners[1]]);
  CHECK(mesh::renumber_vertices(kept, inverse(permutation), mesh::CellOrder::kept) == mesh);
}

TEST_CASE("tetrahedra_sorted_by_vertices_carry_their_regions_and_neighbours_along") {
  const TetMesh mesh = marked_box();
  const auto permutation = random_permutation(mesh.vertex_count(), 4);
  const TetMesh sorted = mesh::renumber_vertices(mesh, permutation);
  CHECK(mesh::validate(sorted).value_or("") == "");
  CHECK(mesh::fingerprint(sorted) == mesh::fingerprint(mesh));
  std::array<VertexId, 4> last{};
  std::map<std::array<VertexId, 4>, double> region_of;
  for (const TetId t : mesh.corners.ids()) {
    auto key = mesh.corners[t];
    for (VertexId& v : key) v = permutation[v];
    region_of[key] = mesh.regions[t];
  }
  for (const TetId t : sorted.corners.ids()) {
    auto key = sorted.corners[t];
    CHECK(region_of.at(key) == sorted.regions[t]);
    std::sort(key.begin(), key.end());
    CHECK(last < key);
    last = key;
  }
}

TEST_CASE("what_is_no_permutation_of_a_tetrahedral_meshs_vertices_is_refused") {
  const TetMesh mesh = tet_shelf::box(1, 1, 1);
  auto permutation = random_permutation(8, 1);
  permutation.flat().pop_back();
  CHECK_THROWS_AS((void)mesh::renumber_vertices(mesh, permutation), InputError);
  permutation.push_back(permutation[VertexId{0}]);
  CHECK_THROWS_AS((void)mesh::renumber_vertices(mesh, permutation), InputError);
  permutation[VertexId{0}] = VertexId{8};
  CHECK_THROWS_AS((void)mesh::renumber_vertices(mesh, permutation), InputError);
}
