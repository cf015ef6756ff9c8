// SPDX-License-Identifier: MIT
#include "leonhard/mesh/quad_edge.hpp"

#include <doctest/doctest.h>

#include <random>
#include <set>
#include <vector>

#include "leonhard/mesh/data_structures.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

/// What the paper's section 2 demands of every edge, primal or dual, and what follows for the derived
/// functions.
void check_algebra(const QuadEdge& quads) {
  quads.for_each_edge([&](EdgeRef base) {
    EdgeRef e = base;
    for (int quarter = 0; quarter < 4; ++quarter, e = quads.rot(e)) {
      CHECK(quads.rot(quads.rot(quads.rot(quads.rot(e)))) == e);      // E1
      CHECK(quads.onext(quads.rot(quads.onext(quads.rot(e)))) == e);  // E2
      CHECK(quads.rot(quads.rot(e)) != e);                            // E3
      CHECK(quads.is_primal(e) != quads.is_primal(quads.rot(e)));     // E4
      CHECK(quads.is_primal(e) == quads.is_primal(quads.onext(e)));   // E5
      CHECK(quads.sym(e) == quads.rot(quads.rot(e)));
      CHECK(quads.rot(quads.inv_rot(e)) == e);
      CHECK(quads.oprev(quads.onext(e)) == e);
      CHECK(quads.dprev(quads.dnext(e)) == e);
      CHECK(quads.lprev(quads.lnext(e)) == e);
      CHECK(quads.rprev(quads.rnext(e)) == e);
      CHECK(quads.lnext(e) == quads.oprev(quads.sym(e)));
      CHECK(quads.rnext(e) == quads.sym(quads.oprev(e)));
      // The dual of the dual is the structure itself, its left face the origin of inv_rot.
      CHECK(quads.rot(quads.lnext(e)) == quads.dnext(quads.rot(e)));
    }
  });
}

std::size_t ring_count(const QuadEdge& quads, bool of_faces) {
  std::set<EdgeRef> seen;
  std::size_t rings = 0;
  quads.for_each_directed_edge([&](EdgeRef e) {
    if (seen.contains(e)) return;
    ++rings;
    const auto mark = [&](EdgeRef g) { seen.insert(g); };
    if (of_faces)
      quads.for_each_about_left(e, mark);
    else
      quads.for_each_about_origin(e, mark);
  });
  return rings;
}

QuadEdge triangle() {
  QuadEdge quads;
  const EdgeRef a = quads.make_edge(VertexId{0}, VertexId{1}), b = quads.make_edge(VertexId{1}, VertexId{2});
  quads.splice(quads.sym(a), b);
  quads.connect(b, a);
  return quads;
}

}  // namespace

TEST_CASE("the_axioms_of_the_edge_algebra_hold_after_any_sequence_of_splices") {
  std::mt19937 random(7);
  QuadEdge quads;
  std::vector<EdgeRef> edges;
  for (int i = 0; i < 24; ++i) edges.push_back(quads.make_edge());
  check_algebra(quads);
  for (int step = 0; step < 300; ++step) {
    // Both of the structure or both of its dual, as E5 demands.
    const bool dual = random() % 2 == 0;
    const auto any = [&] {
      const EdgeRef e = edges[random() % edges.size()], turned = dual ? quads.rot(e) : e;
      return random() % 2 == 0 ? turned : quads.sym(turned);
    };
    quads.splice(any(), any());
    if (step % 50 == 0) check_algebra(quads);
    REQUIRE_FALSE(quads.validate());
  }
}

TEST_CASE("a_splice_is_its_own_inverse") {
  QuadEdge quads = triangle();
  const EdgeRef a{0}, b{6};
  const EdgeRef next_a = quads.onext(a), next_b = quads.onext(b);
  quads.splice(a, b);
  CHECK(quads.onext(a) == next_b);
  quads.splice(a, b);
  CHECK(quads.onext(a) == next_a);
  CHECK(quads.onext(b) == next_b);
}

TEST_CASE("a_single_edge_has_two_vertices_and_one_face") {
  QuadEdge quads;
  const EdgeRef e = quads.make_edge(VertexId{3}, VertexId{5});
  CHECK(*quads.origin(e) == VertexId{3});
  CHECK(*quads.destination(e) == VertexId{5});
  CHECK(quads.onext(e) == e);
  CHECK(quads.lnext(e) == quads.sym(e));
  CHECK(ring_count(quads, false) == 2);
  CHECK(ring_count(quads, true) == 1);
  CHECK_FALSE(quads.validate());
}

TEST_CASE("connect_closes_a_triangle_and_remove_opens_it_again") {
  QuadEdge quads = triangle();
  CHECK(quads.edge_count() == 3);
  CHECK(ring_count(quads, false) == 3);
  CHECK(ring_count(quads, true) == 2);
  EdgeRef e{0};
  for (IdRaw v = 0; v < 3; ++v, e = quads.lnext(e)) CHECK(*quads.origin(e) == VertexId{v});
  CHECK(e == EdgeRef{0});
  quads.remove(EdgeRef{8});
  CHECK(quads.edge_count() == 2);
  CHECK_FALSE(quads.contains(EdgeRef{8}));
  CHECK(ring_count(quads, true) == 1);
  CHECK_FALSE(quads.validate());
  CHECK(quads.make_edge() == EdgeRef{8});
}

TEST_CASE("four_swaps_turn_a_diagonal_once_round_and_keep_vertices_and_faces") {
  QuadEdge quads = mesh::quad_edge(shelf::grid(1, 1));  // triangles 0 1 3 and 0 3 2
  EdgeRef diagonal{};
  quads.for_each_directed_edge([&](EdgeRef e) {
    if (quads.left(e) && quads.right(e) && *quads.origin(e) == VertexId{0}) diagonal = e;
  });
  quads.swap(diagonal);
  CHECK(*quads.origin(diagonal) == VertexId{1});
  CHECK(*quads.destination(diagonal) == VertexId{2});
  CHECK(ring_count(quads, true) == 3);
  CHECK_FALSE(quads.validate());
  quads.swap(diagonal);
  CHECK(*quads.origin(diagonal) == VertexId{3});
  CHECK(*quads.destination(diagonal) == VertexId{0});
  CHECK_FALSE(quads.validate());
}

TEST_CASE("edges_of_a_mesh_obey_the_algebra_with_triangles_on_their_left") {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    const QuadEdge quads = mesh::quad_edge(entry.mesh);
    check_algebra(quads);
    CHECK_FALSE(quads.validate());
    quads.for_each_directed_edge([&](EdgeRef e) {
      if (!quads.left(e)) return;
      const TriangleId t{(*quads.left(e)).raw};
      const EdgeRef next = quads.lnext(e);
      CHECK(quads.lnext(quads.lnext(next)) == e);
      const auto& corners = entry.mesh.corners[t];
      const auto at = std::find(corners.begin(), corners.end(), *quads.origin(e)) - corners.begin();
      CHECK(corners[static_cast<std::size_t>(at + 1) % 3] == *quads.destination(e));
      CHECK(corners[static_cast<std::size_t>(at + 2) % 3] == *quads.destination(next));
    });
    // A fan is a vertex, a boundary loop a face.
    CHECK(ring_count(quads, false) == entry.mesh.vertex_count() + entry.pinches);
    CHECK(ring_count(quads, true) == entry.mesh.triangle_count() + entry.components + entry.holes);
  }
}

TEST_CASE("validate_names_a_ring_with_two_vertices_and_a_face_with_two_ids") {
  QuadEdge quads = triangle();
  quads.set_origin(EdgeRef{0}, VertexId{9});
  REQUIRE(quads.validate());
  CHECK(quads.validate()->find("different vertices") != std::string::npos);
  quads.set_vertex(EdgeRef{0}, VertexId{9});
  CHECK_FALSE(quads.validate());
  quads.set_left(EdgeRef{0}, FaceId{1});
  REQUIRE(quads.validate());
  CHECK(quads.validate()->find("left face with different ids") != std::string::npos);
  quads.set_face(EdgeRef{0}, FaceId{1});
  CHECK_FALSE(quads.validate());
}
