// SPDX-License-Identifier: MIT
// Edges and faces of another mesh are refused by all that takes them beside a mesh.
#include <doctest/doctest.h>

#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/centroid_dual.hpp"
#include "leonhard/mesh/dirichlet_dual.hpp"
#include "leonhard/mesh/euler.hpp"
#include "leonhard/mesh/median_dual.hpp"
#include "leonhard/mesh/tet_euler.hpp"
#include "leonhard/mesh/topology.hpp"
#include "tests/mesh/shelf.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

/// The words of the InputError that a call throws; empty if it does not.
template <class Call>
std::string words_of_refusal(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("duals_and_the_account_of_triangles_refuse_edges_of_another_mesh") {
  for (const auto& one : shelf::all()) {
    for (const auto& other : shelf::all()) {
      CAPTURE(one.name);
      CAPTURE(other.name);
      const EdgeStructure edges = mesh::build_edges(other.mesh);
      const bool same = edges.ends == mesh::build_edges(one.mesh).ends &&
                        edges.sides == mesh::build_edges(one.mesh).sides &&
                        one.mesh.vertex_count() == other.mesh.vertex_count();
      CHECK(words_of_refusal([&] { return mesh::median_dual(one.mesh, edges); }).empty() == same);
      CHECK(words_of_refusal([&] { return mesh::centroid_dual(one.mesh, edges); }).empty() == same);
      CHECK(words_of_refusal([&] { return mesh::dirichlet_dual(one.mesh, edges); }).empty() == same);
      if (words_of_refusal([&] { return mesh::euler_account(one.mesh, edges); }).empty() && !same)
        CHECK_FALSE(mesh::euler_account(one.mesh, edges).balances());
    }
  }
}

TEST_CASE("the_duals_of_triangles_refuse_an_edge_less_and_name_an_edge_that_is_turned_round") {
  const TriangleMesh mesh = shelf::all().front().mesh;
  const EdgeStructure edges = mesh::build_edges(mesh);
  EdgeStructure fewer = edges;
  fewer.ends.flat().pop_back();
  fewer.sides.flat().pop_back();
  CHECK_FALSE(words_of_refusal([&] { return mesh::median_dual(mesh, fewer); }).empty());
  fewer.first_edge.back() = static_cast<IdRaw>(fewer.edge_count());
  CHECK_FALSE(words_of_refusal([&] { return mesh::median_dual(mesh, fewer); }).empty());
  EdgeStructure turned = edges;
  std::swap(turned.sides.flat()[1][0], turned.sides.flat()[1][1]);
  CHECK(words_of_refusal([&] {
          return mesh::median_dual(mesh, turned);
        }).find("edges: edge 1, from vertex") == 0);
  EdgeStructure without_sides = edges;
  without_sides.sides.flat()[0] = {};
  CHECK(words_of_refusal([&] {
          return mesh::euler_account(mesh, without_sides);
        }).find("edges: edge 0, from vertex") == 0);
  TriangleMesh beyond = mesh;
  beyond.boundary.push_back({VertexId::from(0), VertexId::from(999), 1});
  CHECK(words_of_refusal([&] { return mesh::median_dual(beyond, edges); }).find("999") != std::string::npos);
}

TEST_CASE("the_dual_and_the_account_of_tetrahedra_refuse_edges_and_faces_of_another_mesh") {
  for (const auto& one : tet_shelf::all()) {
    const FaceStructure own_faces = mesh::build_faces(one.mesh);
    const TetEdges own_edges = mesh::build_edges(one.mesh);
    for (const auto& other : tet_shelf::all()) {
      CAPTURE(one.name);
      CAPTURE(other.name);
      const FaceStructure faces = mesh::build_faces(other.mesh);
      const TetEdges edges = mesh::build_edges(other.mesh);
      const bool same = edges.ends == own_edges.ends && one.mesh.vertex_count() == other.mesh.vertex_count();
      CHECK(words_of_refusal([&] { return mesh::median_dual(one.mesh, edges); }).empty() == same);
      if (words_of_refusal([&] { return mesh::euler_account(one.mesh, own_faces, edges); }).empty() && !same)
        CHECK_FALSE(mesh::euler_account(one.mesh, own_faces, edges).balances());
      if (words_of_refusal([&] { return mesh::euler_account(one.mesh, faces, own_edges); }).empty() &&
          faces.corners != own_faces.corners)
        CHECK_FALSE(mesh::euler_account(one.mesh, faces, own_edges).balances());
    }
  }
}
