// SPDX-License-Identifier: MIT
#include "leonhard/mesh/permute.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;
using shelves::random_permutation;

namespace {

PerId<VertexId, VertexId> inverse(const PerId<VertexId, VertexId>& permutation) {
  PerId<VertexId, VertexId> result(permutation.size());
  for (const VertexId v : permutation.ids()) result[permutation[v]] = v;
  return result;
}

/// A mesh on which everything that can be carried is different everywhere.
template <class Mesh>
Mesh laden() {
  Mesh mesh = shelves::shaken<Mesh>(3, 7);
  Marker next = 10;
  for (Marker& marker : mesh.vertex_markers) marker = next++;
  for (double& region : mesh.regions) region = next++;
  for (auto& facet : mesh.boundary) facet.marker = next++;
  for (const auto t : mesh.corners.ids()) {
    if (t.raw % 5 != 0) continue;
    for (std::size_t i = 0; i < mesh.corners[t].size(); ++i) {
      if (!mesh.neighbours[t][i]) continue;
      typename Mesh::FacetCorners facet;  // in whichever direction: inner facets may have either
      for (std::size_t k = 0; k < facet.size(); ++k)
        facet[k] = mesh.corners[t][(i + 1 + k) % mesh.corners[t].size()];
      mesh.inner_facets().push_back(shelves::Kind<Mesh>::marked(facet, next++));
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE_TEMPLATE("renumbered_mesh_is_valid_and_the_inverse_brings_back_every_array", Mesh, TriangleMesh,
                   TetMesh) {
  const auto mesh = laden<Mesh>();
  REQUIRE(mesh.inner_facets().size() > 1);
  REQUIRE_FALSE(mesh::validate(mesh));
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto permutation = random_permutation(mesh.vertex_count(), seed);
    const auto there = mesh::renumber_vertices(mesh, permutation, mesh::CellOrder::kept);
    CHECK(mesh::validate(there).value_or("") == "");
    CHECK(mesh::fingerprint(there) == mesh::fingerprint(mesh));
    CHECK(there.regions == mesh.regions);
    CHECK(there.neighbours == mesh.neighbours);
    const auto back = mesh::renumber_vertices(there, inverse(permutation), mesh::CellOrder::kept);
    CHECK(back.points == mesh.points);
    CHECK(back.corners == mesh.corners);
    CHECK(back.neighbours == mesh.neighbours);
    CHECK(back.boundary == mesh.boundary);
    CHECK(back.inner_facets() == mesh.inner_facets());
    CHECK(back.vertex_markers == mesh.vertex_markers);
    CHECK(back.regions == mesh.regions);
    CHECK(back.marker_names == mesh.marker_names);
  }
}

TEST_CASE_TEMPLATE("what_a_vertex_a_facet_or_a_cell_carries_goes_with_its_place", Mesh, TriangleMesh,
                   TetMesh) {
  const auto mesh = laden<Mesh>();
  const auto permutation = random_permutation(mesh.vertex_count(), 4);
  const auto there = mesh::renumber_vertices(mesh, permutation);
  CHECK(mesh::validate(there).value_or("") == "");
  CHECK(mesh::fingerprint(there) == mesh::fingerprint(mesh));
  for (const VertexId v : mesh.points.ids()) {
    CHECK(there.points[permutation[v]] == mesh.points[v]);
    CHECK(there.vertex_markers[permutation[v]] == mesh.vertex_markers[v]);
  }
  for (const auto t : there.corners.ids()) {
    const auto old =
        std::find(mesh.regions.begin(), mesh.regions.end(), there.regions[t]) - mesh.regions.begin();
    for (std::size_t i = 0; i < there.corners[t].size(); ++i)
      CHECK(there.corners[t][i] == permutation[mesh.corners.flat()[static_cast<std::size_t>(old)][i]]);
  }
  CHECK(there.boundary[5].marker == mesh.boundary[5].marker);
  CHECK(shelves::Kind<Mesh>::corners_of(there.boundary[5])[1] ==
        permutation[shelves::Kind<Mesh>::corners_of(mesh.boundary[5])[1]]);
}

TEST_CASE_TEMPLATE("cells_come_sorted_by_their_vertices_whatever_their_order_was", Mesh, TriangleMesh,
                   TetMesh) {
  const auto mesh = laden<Mesh>();
  auto corners = mesh::renumber_vertices(mesh, random_permutation(mesh.vertex_count(), 8)).corners.flat();
  for (auto& key : corners) std::sort(key.begin(), key.end());
  for (std::size_t t = 1; t < corners.size(); ++t) CHECK(corners[t - 1] < corners[t]);
}

TEST_CASE_TEMPLATE("numbers_that_are_no_permutation_are_refused", Mesh, TriangleMesh, TetMesh) {
  const auto mesh = shelves::regular<Mesh>(1);
  const auto refusal = [&](const PerId<VertexId, VertexId>& new_of_old) -> std::string {
    try {
      (void)mesh::renumber_vertices(mesh, new_of_old);
    } catch (const InputError& error) {
      return error.problem();
    }
    return {};
  };
  auto backwards = PerId<VertexId, VertexId>();  // so that vertex 0 has the last number
  for (std::size_t v = mesh.vertex_count(); v-- > 0;) backwards.push_back(VertexId::from(v));
  const std::string count = std::to_string(mesh.vertex_count()),
                    last = std::to_string(mesh.vertex_count() - 1);
  CHECK(refusal(backwards).empty());
  auto bad = backwards;
  bad.flat().pop_back();
  CHECK(refusal(bad) == last + " entries for " + count + " vertices");
  bad.push_back(VertexId::from(mesh.vertex_count()));
  CHECK(refusal(bad) ==
        "vertex " + last + " is given the number " + count + ", but there are " + count + " vertices");
  bad = backwards;
  bad[VertexId{2}] = bad[VertexId{0}];
  CHECK(refusal(bad) == "vertex 2 is given the number " + last + ", which vertex 0 has already");
}
