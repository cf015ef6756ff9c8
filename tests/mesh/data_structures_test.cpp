// SPDX-License-Identifier: MIT
#include "leonhard/mesh/data_structures.hpp"

#include <doctest/doctest.h>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

/// The triangles whose corners turn so that the smallest comes first.
auto turned(PerId<TriangleId, std::array<VertexId, 3>> corners) {
  for (auto& t : corners) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return corners;
}

void check_same(const EdgeStructure& a, const EdgeStructure& b) {
  CHECK(a.ends == b.ends);
  CHECK(a.sides == b.sides);
  CHECK(a.first_edge == b.first_edge);
}

/// Holes of three edges on the shelf: the one in the ring of triangles.
std::vector<std::array<VertexId, 3>> triangular_holes(const std::string& name) {
  if (name != "ring of triangles that touch at vertices") return {};
  return {{VertexId{5}, VertexId{3}, VertexId{4}}};
}

std::size_t largest_out_degree(const OutDegreeList& list) {
  std::size_t largest = 0;
  for (std::size_t v = 0; v < list.vertex_count(); ++v)
    largest = std::max(largest, list.out_degree(VertexId::from(v)));
  return largest;
}

}  // namespace

TEST_CASE("edges_and_quad_edges_lead_back_to_the_same_triangles_and_edges") {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    const TriangleMesh& mesh = entry.mesh;
    const EdgeStructure edges = mesh::build_edges(mesh);
    const QuadEdge quads = mesh::quad_edge(edges);
    check_same(mesh::edge_structure(quads, mesh.vertex_count()), edges);
    for (const TriangleMesh& back :
         {mesh::triangle_mesh(edges, mesh.points), mesh::triangle_mesh(quads, mesh.points)}) {
      CHECK_FALSE(mesh::validate(back));
      CHECK(back.corners == turned(mesh.corners));
      CHECK(back.boundary.size() == mesh.boundary.size());
      check_same(mesh::build_edges(back), edges);
    }
  }
}

TEST_CASE("an_out_degree_list_leads_back_to_the_same_triangles_if_told_of_triangular_holes") {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    const OutDegreeList list = mesh::out_degree_list(entry.mesh);
    const auto holes = triangular_holes(entry.name);
    const QuadEdge quads = mesh::quad_edge(list, entry.mesh.points, holes);
    CHECK_FALSE(quads.validate());
    CHECK(mesh::edge_structure(list, entry.mesh.points, holes).ends == mesh::build_edges(entry.mesh).ends);
    const TriangleMesh back = mesh::triangle_mesh(list, entry.mesh.points, holes);
    CHECK_FALSE(mesh::validate(back));
    CHECK(back.triangle_count() == entry.mesh.triangle_count());
    CHECK(mesh::fingerprint(back) == mesh::fingerprint(entry.mesh));
  }
}

TEST_CASE("smallest_last_lists_every_edge_once_and_no_vertex_has_more_than_five") {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    const EdgeStructure edges = mesh::build_edges(entry.mesh);
    const OutDegreeList list = mesh::out_degree_list(edges);
    CHECK(list.edge_count() == edges.edge_count());
    CHECK(largest_out_degree(list) <= 5);
    for (std::size_t v = 0; v < list.vertex_count(); ++v) {
      const auto heads = list.heads_of(VertexId::from(v));
      CHECK(std::is_sorted(heads.begin(), heads.end()));
      for (const VertexId head : heads) CHECK(edges.find(VertexId::from(v), head));
    }
    for (const auto& [a, b] : edges.ends) CHECK(list.has_edge(a, b));
  }
}

TEST_CASE("a_wheel_of_many_spokes_keeps_its_hub_short") {
  const TriangleMesh mesh = shelf::disc({0, 0}, 1, 200);  // the hub is vertex 0
  const OutDegreeList list = mesh::out_degree_list(mesh);
  CHECK(list.out_degree(VertexId{0}) <= 5);
  CHECK(largest_out_degree(list) <= 3);
}

TEST_CASE("given_tails_are_obeyed_and_wrong_ones_refused") {
  const EdgeStructure edges = mesh::build_edges(shelf::grid(2, 2));
  PerId<EdgeId, VertexId> tails;
  for (const auto& ends : edges.ends) tails.push_back(ends[1]);
  const OutDegreeList list = mesh::out_degree_list(edges, tails);
  for (std::size_t v = 0; v < list.vertex_count(); ++v)
    for (const VertexId head : list.heads_of(VertexId::from(v))) CHECK(head < VertexId::from(v));
  tails[EdgeId{0}] = VertexId{8};
  CHECK_THROWS_WITH_AS((void)mesh::out_degree_list(edges, tails),
                       doctest::Contains("vertex 8 is no end of edge 0"), InputError);
  tails.resize(3);
  CHECK_THROWS_AS((void)mesh::out_degree_list(edges, tails), InputError);
}

TEST_CASE("edges_whose_sides_make_no_triangle_are_refused") {
  const TriangleMesh mesh = shelf::grid(2, 2);
  EdgeStructure edges = mesh::build_edges(mesh);
  edges.sides[EdgeId{0}] = {};
  CHECK_THROWS_WITH_AS((void)mesh::triangle_mesh(edges, mesh.points), doctest::Contains("triangle 0"),
                       InputError);
  CHECK_THROWS_AS((void)mesh::quad_edge(edges), InputError);
  edges = mesh::build_edges(mesh);
  std::swap(edges.sides[EdgeId{0}][0], edges.sides[EdgeId{0}][1]);
  CHECK_THROWS_AS((void)mesh::triangle_mesh(edges, mesh.points), InputError);
}

TEST_CASE("a_quad_edge_structure_without_vertices_makes_no_edges") {
  QuadEdge quads;
  quads.make_edge(VertexId{0});
  CHECK_THROWS_WITH_AS((void)mesh::edge_structure(quads, 2),
                       doctest::Contains("edge 0 has an end without vertex"), InputError);
  quads = {};
  quads.make_edge(VertexId{0}, VertexId{1});
  CHECK_THROWS_AS((void)mesh::edge_structure(quads, 1), InputError);
  quads.make_edge(VertexId{1}, VertexId{0});
  CHECK_THROWS_WITH_AS((void)mesh::edge_structure(quads, 2), doctest::Contains("join the same vertices"),
                       InputError);
}
