// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"

#include <doctest/doctest.h>

#include <set>

#include "leonhard/delaunay/topology/cavity.hpp"

namespace leonhard {
namespace {

using delaunay::Cavity;
using delaunay::GhostTriangulation;
using delaunay::SideId;

using Triangles = std::set<std::set<IdRaw>>;

Triangles real_triangles(const GhostTriangulation& in) {
  Triangles all;
  for (std::size_t i = 0; i < in.triangle_count(); ++i) {
    const delaunay::AnyTriangleId t = delaunay::AnyTriangleId::from(i);
    if (!in.is_ghost(t)) all.insert({in.corner(t, 0).raw, in.corner(t, 1).raw, in.corner(t, 2).raw});
  }
  return all;
}

GhostTriangulation two_triangles() {
  GhostTriangulation in;
  in.start(VertexId{0}, VertexId{1}, VertexId{2});
  // Vertex 3 behind the edge 1-2, which is side 0 of the first triangle.
  Cavity cavity;
  cavity.start(in, in.triangle(in.twin(SideId{0})));
  cavity.grow(in, [](SideId) { return false; });
  cavity.fill(in, VertexId{3});
  return in;
}

TEST_CASE("a_first_triangle_has_a_ghost_behind_each_side") {
  GhostTriangulation in;
  in.start(VertexId{0}, VertexId{1}, VertexId{2});
  CHECK_FALSE(in.validate());
  CHECK(in.triangle_count() == 4);
  for (unsigned i = 0; i < 3; ++i)
    CHECK(in.is_ghost(in.triangle(in.twin(in.side(delaunay::AnyTriangleId{0}, i)))));
}

TEST_CASE("a_ghost_triangle_filled_with_a_vertex_makes_one_real_triangle") {
  const GhostTriangulation in = two_triangles();
  CHECK_FALSE(in.validate());
  CHECK(real_triangles(in) == Triangles{{0, 1, 2}, {1, 2, 3}});
  CHECK(in.triangle_count() == 6);
}

TEST_CASE("a_flip_exchanges_diagonals_and_two_flips_are_none") {
  GhostTriangulation in = two_triangles();
  const GhostTriangulation::Flipped flipped = in.flip(SideId{0});
  CHECK_FALSE(in.validate());
  CHECK(real_triangles(in) == Triangles{{0, 1, 3}, {0, 2, 3}});
  in.flip(flipped.diagonal);
  CHECK_FALSE(in.validate());
  CHECK(real_triangles(in) == Triangles{{0, 1, 2}, {1, 2, 3}});
}

TEST_CASE("a_flip_says_where_the_outer_sides_went") {
  GhostTriangulation in = two_triangles();
  std::set<std::pair<IdRaw, IdRaw>> before, after;
  GhostTriangulation flipped = in;
  for (const auto& [from, to] : flipped.flip(SideId{0}).moved) {
    before.insert({in.origin(from).raw, in.destination(from).raw});
    after.insert({flipped.origin(to).raw, flipped.destination(to).raw});
    CHECK(in.origin(from) == flipped.origin(to));
    CHECK(in.destination(from) == flipped.destination(to));
  }
  CHECK(before == after);
  CHECK(before.size() == 4);
}

TEST_CASE("a_cavity_over_an_edge_becomes_a_fan_of_four") {
  GhostTriangulation in = two_triangles();
  Cavity cavity;
  cavity.start(in, SideId{0});
  cavity.grow(in, [](SideId) { return false; });
  REQUIRE(cavity.border().size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(cavity.border()[i].to == cavity.border()[(i + 1) % 4].from);
  cavity.fill(in, VertexId{4});
  CHECK_FALSE(in.validate());
  CHECK(real_triangles(in) == Triangles{{0, 1, 4}, {0, 2, 4}, {1, 3, 4}, {2, 3, 4}});
}

TEST_CASE("validate_finds_a_broken_link") {
  GhostTriangulation in = two_triangles();
  in.set_corners(delaunay::AnyTriangleId{0}, VertexId{0}, VertexId{2}, VertexId{1});
  REQUIRE(in.validate());
  CHECK(in.validate()->find("triangle 0") != std::string::npos);
}

}  // namespace
}  // namespace leonhard
