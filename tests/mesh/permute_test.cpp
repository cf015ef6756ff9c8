// SPDX-License-Identifier: MIT
#include "leonhard/mesh/permute.hpp"

#include <doctest/doctest.h>

#include <random>
#include <tuple>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelf.hpp"

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

/// A grid on which everything that can be carried is different everywhere.
TriangleMesh laden_grid() {
  TriangleMesh mesh = shelf::grid(4, 3);
  Marker next = 10;
  for (Marker& marker : mesh.vertex_markers) marker = next++;
  for (double& region : mesh.regions) region = next++;
  for (MarkedEdge& edge : mesh.boundary) edge.marker = next++;
  mesh.constraints = {{VertexId{0}, VertexId{6}, next++}, {VertexId{7}, VertexId{6}, next++}};
  return mesh;
}

}  // namespace

TEST_CASE("renumbered_mesh_is_valid_and_the_inverse_brings_back_every_array") {
  const TriangleMesh mesh = laden_grid();
  REQUIRE_FALSE(mesh::validate(mesh));
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto permutation = random_permutation(mesh.vertex_count(), seed);
    const auto there = mesh::renumber_vertices(mesh, permutation, mesh::CellOrder::kept);
    CHECK(mesh::validate(there).value_or("") == "");
    const auto back = mesh::renumber_vertices(there, inverse(permutation), mesh::CellOrder::kept);
    CHECK(back.points == mesh.points);
    CHECK(back.corners == mesh.corners);
    CHECK(back.neighbours == mesh.neighbours);
    CHECK(back.boundary == mesh.boundary);
    CHECK(back.constraints == mesh.constraints);
    CHECK(back.vertex_markers == mesh.vertex_markers);
    CHECK(back.regions == mesh.regions);
    CHECK(back.marker_names == mesh.marker_names);
  }
}

TEST_CASE("what_a_vertex_or_a_triangle_carries_goes_with_its_place") {
  const TriangleMesh mesh = laden_grid();
  const auto permutation = random_permutation(mesh.vertex_count(), 4);
  const auto there = mesh::renumber_vertices(mesh, permutation);
  CHECK(mesh::validate(there).value_or("") == "");
  for (const VertexId v : mesh.points.ids()) {
    CHECK(there.points[permutation[v]] == mesh.points[v]);
    CHECK(there.vertex_markers[permutation[v]] == mesh.vertex_markers[v]);
  }
  for (const TriangleId t : there.corners.ids()) {
    const auto old =
        std::find(mesh.regions.begin(), mesh.regions.end(), there.regions[t]) - mesh.regions.begin();
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(there.corners[t][i] ==
            permutation[mesh.corners[TriangleId::from(static_cast<std::size_t>(old))][i]]);
    }
  }
}

TEST_CASE("triangles_come_sorted_by_their_vertices_whatever_their_order_was") {
  const TriangleMesh mesh = laden_grid();
  const auto permutation = random_permutation(mesh.vertex_count(), 8);
  const auto sorted = mesh::renumber_vertices(mesh, permutation);
  const auto key = [&](TriangleId t) {
    auto corners = sorted.corners[t];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (std::size_t t = 1; t < sorted.triangle_count(); ++t) {
    CHECK(key(TriangleId::from(t - 1)) < key(TriangleId::from(t)));
  }
}

TEST_CASE("numbers_that_are_no_permutation_are_refused") {
  const TriangleMesh mesh = shelf::grid(1, 1);
  const auto refusal = [&](std::vector<VertexId> ids) -> std::string {
    try {
      (void)mesh::renumber_vertices(mesh, PerId<VertexId, VertexId>(std::move(ids)));
    } catch (const InputError& error) {
      return error.problem();
    }
    return {};
  };
  CHECK(refusal({VertexId{3}, VertexId{1}, VertexId{0}, VertexId{2}}).empty());
  CHECK(refusal({VertexId{3}, VertexId{1}, VertexId{0}}) == "3 entries for 4 vertices");
  CHECK(refusal({VertexId{3}, VertexId{1}, VertexId{0}, VertexId{4}}) ==
        "vertex 3 is given the number 4, but there are 4 vertices");
  CHECK(refusal({VertexId{3}, VertexId{1}, VertexId{3}, VertexId{0}}) ==
        "vertex 2 is given the number 3, which vertex 0 has already");
}
