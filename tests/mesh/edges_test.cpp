// SPDX-License-Identifier: MIT
#include "leonhard/mesh/edges.hpp"

#include <doctest/doctest.h>

#include <map>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

/// Edges and their sides by an ordered map: an independent answer.
std::map<std::pair<VertexId, VertexId>, std::array<MaybeId<TriangleId>, 2>> edges_by_map(
    const TriangleMesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, std::array<MaybeId<TriangleId>, 2>> edges;
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId from = mesh.corners[t][i], to = mesh.corners[t][(i + 1) % 3];
      edges[{std::min(from, to), std::max(from, to)}][from < to ? 0 : 1] = t;
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("edge_structure_is_that_of_an_ordered_map_for_every_mesh_on_the_shelf") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const EdgeStructure edges = mesh::build_edges(mesh);
    const auto expected = edges_by_map(mesh);
    REQUIRE(edges.edge_count() == expected.size());
    auto at = expected.begin();
    for (const EdgeId e : edges.ends.ids()) {
      CHECK(edges.ends[e] == std::array{at->first.first, at->first.second});
      CHECK(edges.sides[e] == at->second);
      CHECK(edges.is_boundary(e) == !(at->second[0] && at->second[1]));
      CHECK(edges.find(at->first.first, at->first.second) == MaybeId<EdgeId>(e));
      CHECK(edges.find(at->first.second, at->first.first) == MaybeId<EdgeId>(e));
      ++at;
    }
  }
}

TEST_CASE("find_says_none_for_vertices_without_common_edge") {
  const EdgeStructure edges = mesh::build_edges(shelf::grid(2, 1));  // 3 4 5 over 0 1 2
  CHECK(edges.find(VertexId{0}, VertexId{4}));
  CHECK_FALSE(edges.find(VertexId{1}, VertexId{3}));
  CHECK_FALSE(edges.find(VertexId{0}, VertexId{5}));
  CHECK_FALSE(edges.find(VertexId{2}, VertexId{2}));
  CHECK_FALSE(edges.find(VertexId{40}, VertexId{50}));
}

TEST_CASE("edges_are_built_from_corners_alone") {
  auto mesh = shelf::grid(3, 2);
  const EdgeStructure before = mesh::build_edges(mesh);
  mesh.neighbours.clear();
  mesh.boundary.clear();
  const EdgeStructure after = mesh::build_edges(mesh);
  CHECK(before.ends == after.ends);
  CHECK(before.sides == after.sides);
}

TEST_CASE("edges_of_three_triangles_are_refused") {
  auto mesh = shelf::grid(1, 1);
  mesh.corners.push_back(mesh.corners[TriangleId{0}]);
  CHECK_THROWS_AS((void)mesh::build_edges(mesh), InputError);
}
