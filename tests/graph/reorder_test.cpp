// SPDX-License-Identifier: MIT
#include "leonhard/graph/reorder.hpp"

#include <doctest/doctest.h>

#include "leonhard/graph/order.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

/// The same cells at the same places, whatever their numbers.
template <int Dim>
void check_same_cells(const SimplexMesh<Dim>& mesh, const Reordered<Dim>& made) {
  REQUIRE(made.new_cell.size() == mesh.corners.size());
  std::vector<char> seen(mesh.corners.size(), 0);
  for (const auto old : mesh.corners.ids()) {
    const auto cell = made.new_cell[old];
    CHECK(seen[cell.index()]++ == 0);
    for (std::size_t i = 0; i < mesh.corners[old].size(); ++i) {
      CHECK(made.mesh.corners[cell][i] == made.new_vertex[mesh.corners[old][i]]);
      CHECK(made.mesh.points[made.mesh.corners[cell][i]] == mesh.points[mesh.corners[old][i]]);
    }
  }
}

}  // namespace

TEST_CASE("an_order_applied_to_a_mesh_says_where_vertices_and_triangles_went") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const TriangleMesh mesh = random_triangulation(6, 5, seed);
    const auto order = random_order(static_cast<std::uint32_t>(mesh.vertex_count()), seed);
    const auto made = reorder(mesh, order);
    check_same_cells(mesh, made);
    for (std::uint32_t i = 0; i < order.size(); ++i)
      CHECK(made.new_vertex[VertexId{order[i]}] == VertexId{i});
    const CsrGraph before = vertex_graph(mesh, mesh::build_edges(mesh));
    CHECK(vertex_graph(made.mesh, mesh::build_edges(made.mesh)) == renamed(before, invert(order)));
    CHECK(carried(mesh.points, made.new_vertex) == made.mesh.points);
    CHECK(carried(mesh.regions, made.new_cell) == made.mesh.regions);
  }
}

TEST_CASE("an_order_applied_to_tetrahedra_says_where_they_went") {
  TetMesh mesh;
  const std::uint32_t n = 6;
  for (std::uint32_t i = 0; i < n + 3; ++i)
    mesh.points.push_back({double(i), double(i * i), double(i * i * i)});
  for (std::uint32_t i = 0; i < n; ++i)
    mesh.corners.push_back({VertexId{i}, VertexId{i + 1}, VertexId{i + 2}, VertexId{i + 3}});
  mesh.neighbours = PerId<TetId, std::array<MaybeId<TetId>, 4>>(n);
  mesh.regions = decltype(mesh.regions)(n);
  mesh.vertex_markers = decltype(mesh.vertex_markers)(n + 3);
  check_same_cells(mesh, reorder(mesh, random_order(n + 3, 4)));
  const auto kept = reorder(mesh, random_order(n + 3, 4), mesh::CellOrder::kept);
  check_same_cells(mesh, kept);
  for (const TetId t : mesh.corners.ids()) CHECK(kept.new_cell[t] == t);
}

TEST_CASE("an_order_of_another_mesh_is_refused") {
  const TriangleMesh mesh = random_triangulation(2, 2, 1);
  CHECK_THROWS_WITH_AS(static_cast<void>(reorder(mesh, random_order(8, 1))),
                       doctest::Contains("8 numbers for 9"), InputError);
  CHECK_THROWS_AS(static_cast<void>(reorder(mesh, std::vector<std::uint32_t>(9, 0))), InputError);
}
