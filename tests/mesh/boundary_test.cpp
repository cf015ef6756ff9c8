// SPDX-License-Identifier: MIT
#include "leonhard/mesh/boundary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "tests/mesh/shelf.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;
using mesh::BoundaryLoop;
using mesh::BoundarySurface;

namespace {

template <class Parts>
std::pair<std::size_t, std::size_t> outer_and_inner(const Parts& parts) {
  const auto outer = static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(), [](const auto& part) { return part.is_outer; }));
  return {outer, parts.size() - outer};
}

mpq_class area2_of(const TriangleMesh& mesh, const BoundaryLoop& loop) {
  TriangleMesh alone;
  alone.points = mesh.points;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    alone.boundary.push_back({loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()], 0});
  return mesh::exact_boundary_area2(alone);
}

/// A marker of its own for each edge of the boundary.
TriangleMesh with_markers(TriangleMesh mesh) {
  Marker marker = 100;
  for (MarkedEdge& edge : mesh.boundary) edge.marker = ++marker;
  return mesh;
}

}  // namespace

TEST_CASE("loops_are_simple_and_together_have_each_boundary_edge_once_with_its_marker") {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    const TriangleMesh mesh = with_markers(entry.mesh);
    std::map<std::pair<VertexId, VertexId>, Marker> edges;
    mpq_class area2 = 0;
    for (const BoundaryLoop& loop : mesh::boundary_loops(mesh)) {
      REQUIRE(loop.vertices.size() == loop.markers.size());
      CHECK(std::set(loop.vertices.begin(), loop.vertices.end()).size() == loop.vertices.size());
      CHECK(*std::min_element(loop.vertices.begin(), loop.vertices.end()) == loop.vertices.front());
      for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const std::pair edge{loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]};
        CHECK(edges.emplace(edge, loop.markers[i]).second);
      }
      CHECK(loop.is_outer == (area2_of(mesh, loop) > 0));
      area2 += area2_of(mesh, loop);
    }
    CHECK(edges.size() == mesh.boundary.size());
    for (const MarkedEdge& edge : mesh.boundary) CHECK(edges.at({edge.from, edge.to}) == edge.marker);
    CHECK(area2 == mesh::exact_area2(mesh));
  }
}

TEST_CASE("each_part_has_one_outer_loop_and_touching_holes_are_apart") {
  // Of the shelf in its order: the numbers of outer loops and of holes.
  const std::vector<std::pair<std::size_t, std::size_t>> expected{
      {1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 1}, {3, 1}, {1, 3}, {2, 0}, {1, 2}, {1, 1}, {3, 0}};
  const std::vector<shelf::Entry> all = shelf::all();
  REQUIRE(all.size() == expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i].name);
    const auto loops = mesh::boundary_loops(all[i].mesh);
    CHECK(outer_and_inner(loops) == expected[i]);
    std::size_t component = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      if (l > 0 && loops[l].is_outer) ++component;
      CHECK(loops[l].component == component);
      if (l > 0 && !loops[l].is_outer && !loops[l - 1].is_outer)
        CHECK(loops[l - 1].vertices < loops[l].vertices);
    }
  }
}

TEST_CASE("a_horseshoe_whose_ends_touch_in_a_vertex_has_a_hole") {
  // A ring of squares but for the corner (1, 1), whose neighbours touch there.
  const TriangleMesh mesh = shelf::grid_without(3, {{0, 0}, {1, 1}});
  const auto loops = mesh::boundary_loops(mesh);
  CHECK(outer_and_inner(loops) == std::pair<std::size_t, std::size_t>{1, 1});
  CHECK(loops[1].vertices.size() == 4);
}

TEST_CASE("loops_do_not_depend_on_the_order_of_the_boundary") {
  std::mt19937 random(7);
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    TriangleMesh mesh = with_markers(entry.mesh);
    const auto before = mesh::boundary_loops(mesh);
    std::shuffle(mesh.boundary.begin(), mesh.boundary.end(), random);
    const auto after = mesh::boundary_loops(mesh);
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      CHECK(before[i].vertices == after[i].vertices);
      CHECK(before[i].markers == after[i].markers);
      CHECK(before[i].component == after[i].component);
    }
  }
}

TEST_CASE("a_boundary_that_is_not_the_meshs_is_refused") {
  TriangleMesh grid = shelf::grid(2, 2);
  grid.boundary.pop_back();
  CHECK_THROWS_AS((void)mesh::boundary_loops(grid), InputError);
  grid.boundary.push_back(grid.boundary.front());
  CHECK_THROWS_AS((void)mesh::boundary_loops(grid), InputError);
  TetMesh box = tet_shelf::box(1, 1, 1);
  box.boundary.back().corners = {VertexId{0}, VertexId{1}, VertexId{77}};
  CHECK_THROWS_AS((void)mesh::boundary_surfaces(box), InputError);
}

TEST_CASE("each_part_in_space_has_one_outer_surface_and_each_cavity_one") {
  for (const tet_shelf::Entry& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const auto surfaces = mesh::boundary_surfaces(entry.mesh);
    CHECK(outer_and_inner(surfaces) == std::pair(entry.components, entry.cavities));
    std::size_t component = 0;
    std::set<std::size_t> faces;
    mpq_class volume6 = 0;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      if (s > 0 && surfaces[s].is_outer) ++component;
      CHECK(surfaces[s].component == component);
      CHECK(std::is_sorted(surfaces[s].faces.begin(), surfaces[s].faces.end()));
      faces.insert(surfaces[s].faces.begin(), surfaces[s].faces.end());
      TetMesh alone;
      alone.points = entry.mesh.points;
      for (const std::size_t f : surfaces[s].faces) alone.boundary.push_back(entry.mesh.boundary[f]);
      CHECK((mesh::exact_boundary_volume6(alone) > 0) == surfaces[s].is_outer);
      volume6 += mesh::exact_boundary_volume6(alone);
    }
    CHECK(faces.size() == entry.mesh.boundary.size());
    CHECK(volume6 == mesh::exact_volume6(entry.mesh));
  }
}
