// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mixed_mesh.hpp"

#include <doctest/doctest.h>

#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/structures/sorted_facet.hpp"
#include "tests/mesh/mixed_shelf.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;

namespace {

constexpr std::array kinds_of_space{CellKind::tetrahedron, CellKind::pyramid, CellKind::prism,
                                    CellKind::hexahedron};

std::string refusal_of_simplices(const MixedMesh<3>& mesh) {
  try {
    (void)mesh::simplex_mesh_of(mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("facets_of_every_kind_of_cell_turn_outwards_and_close_it") {
  for (const CellKind kind : kinds_of_space) {
    const MixedMesh<3> mesh = mixed_shelf::single(kind);
    CAPTURE(shape_of(kind).name);
    const CellId cell{0};
    Vec3 centre;
    for (const VertexId v : mesh.corners_of(cell)) centre += mesh.points[v] - Point3{};
    centre /= static_cast<double>(mesh.vertex_count());
    std::set<std::pair<VertexId, VertexId>> directed;
    for (std::size_t side = 0; side < mesh.shape(cell).facets.size(); ++side) {
      const MixedFacet<3> facet = mesh.facet_of(cell, side);
      const Point3 a = mesh.points[facet[0]];
      const Vec3 normal = cross(mesh.points[facet[1]] - a, mesh.points[facet[2]] - a);
      CHECK(dot(normal, a - (Point3{} + centre)) > 0);
      for (std::size_t i = 0; i < facet.size(); ++i)
        CHECK(directed.insert({facet[i], facet[(i + 1) % facet.size()]}).second);
    }
    std::size_t edges = 0;
    mesh::for_each_edge_of(mesh, cell, [&](VertexId a, VertexId b) {
      ++edges;
      CHECK(directed.contains({a, b}));
      CHECK(directed.contains({b, a}));
    });
    CHECK(2 * edges == directed.size());
    CHECK(mesh.vertex_count() + mesh.shape(cell).facets.size() == edges + 2);  // Euler's formula
  }
}

TEST_CASE("edges_of_cells_of_the_plane_go_round_them") {
  const MixedMesh<2> mesh = mixed_shelf::plane_grid(1, 1, [](std::size_t, std::size_t) { return false; });
  std::vector<VertexId> round;
  mesh::for_each_edge_of(mesh, CellId{0}, [&](VertexId a, VertexId b) {
    if (!round.empty()) CHECK(round.back() == a);
    round.push_back(b);
  });
  CHECK(round == std::vector{VertexId{1}, VertexId{3}, VertexId{2}, VertexId{0}});
}

TEST_CASE_TEMPLATE("meshes_of_simplices_become_mixed_ones_and_come_back", Mesh, TriangleMesh, TetMesh) {
  for (const auto& entry : shelves::all<Mesh>()) {
    CAPTURE(entry.name);
    Mesh mesh = entry.mesh;
    for (const auto cell : mesh.corners.ids()) mesh.regions[cell] = 0.5 * static_cast<double>(cell.index());
    for (const VertexId v : mesh.points.ids()) mesh.vertex_markers[v] = static_cast<Marker>(v.raw % 3);
    for (const auto cell : mesh.corners.ids()) {
      for (std::size_t i = 0; i < mesh.corners[cell].size(); ++i) {
        if (!mesh.neighbours[cell][i]) continue;
        mesh.inner_facets().push_back(
            shelves::Kind<Mesh>::marked(mesh::outward_facet(mesh.corners[cell], i), 7));
        break;
      }
      if (!mesh.inner_facets().empty()) break;
    }
    const auto mixed = mesh::mixed_mesh_of(mesh);
    CHECK(mixed.cell_count() == mesh.cell_count());
    CHECK(mesh::simplex_mesh_of(mixed) == mesh);
  }
}

TEST_CASE("cells_that_are_no_simplices_have_no_way_back") {
  CHECK(refusal_of_simplices(mixed_shelf::single(CellKind::pyramid)) ==
        "mesh: pyramid 0 (vertices 0, 1, 2, 3, 4 at (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, "
        "1)) is no tetrahedron; give a mesh of tetrahedra alone");
}

TEST_CASE("mixed_meshes_that_would_be_read_beyond_an_array_are_refused") {
  const auto refusal = [](auto spoil) {
    MixedMesh<3> mesh = mixed_shelf::mixture();
    spoil(mesh);
    try {
      mesh::require_ids_in_range(mesh);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal([](auto&) {}).empty());
  CHECK(refusal([](auto& m) { m.regions.resize(1); }).find("regions has 1 entries for ") == 6);
  CHECK(refusal([](auto& m) { m.vertex_markers.clear(); }).find("vertex_markers has 0 ") == 6);
  CHECK(refusal([](auto& m) { m.kinds.push_back(CellKind::prism); }).find("corners has ") == 6);
  CHECK(refusal([](auto& m) {
          m.kinds[CellId{0}] = CellKind::quadrilateral;
        }).find("cell 0 is a quadrilateral, which is no cell of space") == 6);
  CHECK(refusal([](auto& m) {
          m.kinds[CellId{0}] = CellKind::prism;
        }).find("cell 0, a prism, has 8 corners and not 6") == 6);
  CHECK(refusal([](auto& m) { m.corners[0][3] = VertexId{99}; }).find("vertex 99 of hexahedron 0 (") == 6);
  CHECK(refusal([](auto& m) {
          m.boundary[2].corners[1] = VertexId{99};
        }).find("vertex 99 of boundary entry 2 does not exist, there are ") == 6);
  CHECK(refusal([](auto& m) { m.boundary[2].corners = {}; }).find("boundary entry 2 has 0 corners") == 6);
}

TEST_CASE("a_facet_reversed_keeps_the_first_vertex_of_a_face") {
  const MixedFacet<3> quadrilateral{VertexId{4}, VertexId{1}, VertexId{3}, VertexId{2}};
  CHECK(quadrilateral.reversed() == MixedFacet<3>{VertexId{4}, VertexId{2}, VertexId{3}, VertexId{1}});
  CHECK(quadrilateral.reversed().reversed() == quadrilateral);
  CHECK(MixedFacet<2>{VertexId{4}, VertexId{1}}.reversed() == MixedFacet<2>{VertexId{1}, VertexId{4}});
}
