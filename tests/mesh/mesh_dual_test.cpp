// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mesh_dual.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/median_dual.hpp"
#include "leonhard/mesh/permute.hpp"
#include "tests/mesh/mixed_shelf.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;
using doctest::Approx;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

template <int Dim>
using VectorOf = typename Simplex<Dim>::Vector;

/// Largest gap of any control volume relative to the size of its own boundary.
template <int Dim>
double largest_gap(const MeshDual<Dim>& dual) {
  PerId<VertexId, VectorOf<Dim>> sum(dual.vertex_count());
  PerId<VertexId, double> size(dual.vertex_count());
  const auto add = [&](VertexId v, const VectorOf<Dim>& part) {
    sum[v] += part;
    size[v] += norm(part);
  };
  for (const EdgeId e : dual.edges.ends.ids()) {
    add(dual.edges.ends[e][0], dual.face[e]);
    add(dual.edges.ends[e][1], -dual.face[e]);
  }
  for (const DualFacet<Dim>& facet : dual.boundary)
    for (std::size_t i = 0; i < facet.corners.size(); ++i) add(facet.corners[i], facet.shares[i]);
  double gap = 0;
  for (const VertexId v : sum.ids()) gap = std::max(gap, norm(sum[v]) / size[v]);
  return gap;
}

template <int Dim>
double total_volume(const MeshDual<Dim>& dual) {
  double sum = 0;
  for (const double volume : dual.volume) sum += volume;
  return sum;
}

/// The mean of points.
template <class Point>
Point mean(const std::vector<Point>& points) {
  auto sum = Point{} - Point{};
  for (const Point& p : points) sum += p - Point{};
  return Point{} + sum / static_cast<double>(points.size());
}

template <class Point>
std::vector<Point> places(const std::vector<Point>& points, const mixed_shelf::Corners& corners) {
  std::vector<Point> at;
  for (const std::size_t c : corners) at.push_back(points[c]);
  return at;
}

/// What the boundary encloses, from its corners alone: each face as triangles about its mean.
double enclosed(const MixedMesh<2>& mesh) {
  double sum = 0;
  for (const auto& facet : mesh.boundary)
    sum += 0.5 * cross(mesh.points[facet.corners[0]] - Point2{}, mesh.points[facet.corners[1]] - Point2{});
  return sum;
}
double enclosed(const MixedMesh<3>& mesh) {
  double sum = 0;
  for (const auto& facet : mesh.boundary) {
    std::vector<Point3> at;
    for (const VertexId v : facet.corners) at.push_back(mesh.points[v]);
    const Vec3 centre = mean(at) - Point3{};
    for (std::size_t i = 0; i < at.size(); ++i)
      sum += dot(cross(at[i] - Point3{}, at[(i + 1) % at.size()] - Point3{}), centre) / 6;
  }
  return sum;
}

/// The dual of one cell of space from the definition: every corner, edge, face and the cell span a small tetrahedron; its
/// volume belongs to the corner, its side without the corner, turned away from it, to the edge's face.
struct SmallTetrahedra {
  std::vector<double> volume;
  std::map<std::pair<std::size_t, std::size_t>, Vec3> face;

  SmallTetrahedra(const std::vector<Point3>& points, const mixed_shelf::Cell& cell) : volume(points.size()) {
    const Point3 g = mean(points);
    for (const mixed_shelf::Corners& facet : mixed_shelf::facets_of(cell)) {
      const Point3 f = mean(places(points, facet));
      for (std::size_t i = 0; i < facet.size(); ++i) {
        const std::size_t from = facet[i], to = facet[(i + 1) % facet.size()];
        const Point3 m = mean(places(points, {from, to}));
        for (const std::size_t v : {from, to}) {
          const double volume6 = dot(cross(m - points[v], f - points[v]), g - points[v]);
          volume[v] += std::abs(volume6) / 6;
          const Vec3 side = 0.5 * cross(f - m, g - m);
          face[{v, v == from ? to : from}] += dot(side, m - points[v]) > 0 ? side : -side;
        }
      }
    }
  }
};

}  // namespace

TEST_CASE_TEMPLATE("dual_is_closed_and_fills_the_mesh_on_every_shelf", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    const auto dual = mesh::build_dual(entry.mesh);
    CHECK(largest_gap(dual) < 1e-15);
    CHECK(total_volume(dual) == Approx(entry.measure).epsilon(1e-14));
    CHECK(dual.boundary.size() == entry.mesh.boundary.size());
    CHECK(dual.points == entry.mesh.points);
    for (const unsigned seed : {1, 2, 3}) {
      const auto shaken = mixed_shelf::shaken(entry.mesh, seed);
      const auto bent = mesh::build_dual(shaken);
      CHECK(largest_gap(bent) < 1e-14);
      CHECK(total_volume(bent) == Approx(enclosed(shaken)).epsilon(1e-13));
      for (const double volume : bent.volume) CHECK(volume > 0);
    }
  }
}

TEST_CASE("a_uniform_stream_is_kept_by_thin_and_distant_cells_to_1e_13") {
  MixedMesh<3> mesh = mixed_shelf::shaken(mixed_shelf::mixture(), 5, 0.1, 1024, {1e6, -3e6, 2e6});
  for (Point3& p : mesh.points) p.z *= 1.0 / 4096;  // cells as flat as a boundary layer's
  CHECK(largest_gap(mesh::build_dual(mesh)) < 1e-13);
  MixedMesh<2> plane = mixed_shelf::shaken(mixed_shelf::all<2>()[3].mesh, 5, 0.1, 1024, {1e6, -3e6});
  for (Point2& p : plane.points) p.y *= 1.0 / 4096;
  CHECK(largest_gap(mesh::build_dual(plane)) < 1e-13);
}

TEST_CASE_TEMPLATE("dual_of_simplices_is_the_median_dual", Mesh, TriangleMesh, TetMesh) {
  const auto near = [](double a, double b, double size) { return std::abs(a - b) <= 1e-14 * size; };
  for (const auto& entry : shelves::all<Mesh>()) {
    CAPTURE(entry.name);
    const auto edges = mesh::build_edges(entry.mesh);
    const auto expected = mesh::median_dual(entry.mesh, edges);
    const auto dual = mesh::build_dual(entry.mesh);
    REQUIRE(dual.edges.ends == edges.ends);
    CHECK(dual.edges.first_edge == edges.first_edge);
    double size = 0;  // of the largest face: small ones are sums of large parts
    for (const auto& normal : expected.normal) size = std::max(size, norm(normal));
    for (const EdgeId e : edges.ends.ids()) CHECK(norm(dual.face[e] - expected.normal[e]) <= 1e-14 * size);
    for (const VertexId v : dual.volume.ids())
      CHECK(near(dual.volume[v], expected.volume[v], expected.volume[v]));
    REQUIRE(dual.boundary.size() == expected.boundary_normal.size());
    for (std::size_t i = 0; i < dual.boundary.size(); ++i) {
      const auto& facet = dual.boundary[i];
      CHECK(facet.normal == expected.boundary_normal[i]);
      CHECK(facet.marker == entry.mesh.boundary[i].marker);
      for (std::size_t c = 0; c < facet.corners.size(); ++c)
        CHECK(norm(facet.shares[c] - facet.normal / static_cast<double>(facet.corners.size())) <=
              1e-15 * norm(facet.normal));
    }
  }
}

TEST_CASE("dual_of_one_bent_cell_is_what_its_definition_says") {
  for (const CellKind kind :
       {CellKind::tetrahedron, CellKind::pyramid, CellKind::prism, CellKind::hexahedron}) {
    CAPTURE(shape_of(kind).name);
    const MixedMesh<3> mesh = mixed_shelf::shaken(mixed_shelf::single(kind), 7, 0.1);
    const MeshDual<3> dual = mesh::build_dual(mesh);
    mixed_shelf::Corners corners;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) corners.push_back(i);
    const SmallTetrahedra expected(mesh.points.flat(), {kind, corners});
    for (const VertexId v : dual.volume.ids())
      CHECK(dual.volume[v] == Approx(expected.volume[v.index()]).epsilon(1e-13));
    CHECK(2 * dual.edge_count() == expected.face.size());
    for (const EdgeId e : dual.edges.ends.ids()) {
      const auto ends = dual.edges.ends[e];
      CHECK(norm(dual.face[e] - expected.face.at({ends[0].index(), ends[1].index()})) < 1e-15);
    }
  }
}

TEST_CASE("dual_of_a_unit_cube_has_quarter_faces_and_shares") {
  const MeshDual<3> dual = mesh::build_dual(mixed_shelf::single(CellKind::hexahedron));
  CHECK(dual.edge_count() == 12);
  for (const double volume : dual.volume) CHECK(volume == Approx(0.125).epsilon(1e-15));
  for (const EdgeId e : dual.edges.ends.ids()) {
    const auto ends = dual.edges.ends[e];
    CHECK(dual.face[e] == 0.25 * (dual.points[ends[1]] - dual.points[ends[0]]));
  }
  for (const DualFacet<3>& facet : dual.boundary)
    for (const Vec3& share : facet.shares) CHECK(share == 0.25 * facet.normal);
}

TEST_CASE("shares_of_a_bent_quadrilateral_are_unlike_and_add_up_to_its_normal") {
  const PerId<VertexId, Point3> points(std::vector<Point3>{{0, 0, 0}, {2, 0, 0.5}, {3, 1, 0}, {0, 1, 0.25}});
  const MarkedMixedFacet<3> facet{{VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}}, 4};
  const DualFacet<3> dual = mesh::dual_facet<3>(points, facet);
  CHECK(dual.marker == 4);
  Vec3 sum, triangles;
  const Point3 centre = mean(points.flat());
  for (std::size_t i = 0; i < 4; ++i) {
    sum += dual.shares[i];
    const Point3 a = points.flat()[i], b = points.flat()[(i + 1) % 4], z = points.flat()[(i + 3) % 4];
    triangles += 0.5 * cross(a - centre, b - centre);
    const Vec3 halves = 0.25 * (cross(a - centre, b - centre) + cross(z - centre, a - centre));
    CHECK(norm(dual.shares[i] - halves) < 1e-15);
  }
  CHECK(norm(sum - dual.normal) < 1e-15);
  CHECK(norm(triangles - dual.normal) < 1e-15);
  CHECK(norm(dual.shares[0] - dual.shares[1]) > 0.01);
}

TEST_CASE("dual_does_not_depend_on_where_a_cell_begins") {
  MixedMesh<3> mesh = mixed_shelf::shaken(mixed_shelf::box(2, 1, 1, mixed_shelf::Filling::hexahedron), 3);
  const MeshDual<3> before = mesh::build_dual(mesh);
  const auto row = mesh.corners[0];
  std::rotate(row.begin(), row.begin() + 1, row.begin() + 4);
  std::rotate(row.begin() + 4, row.begin() + 5, row.end());
  const MeshDual<3> after = mesh::build_dual(mesh);
  CHECK(after.edges == before.edges);
  for (const EdgeId e : before.face.ids()) CHECK(norm(after.face[e] - before.face[e]) < 1e-15);
  for (const VertexId v : before.volume.ids())
    CHECK(after.volume[v] == Approx(before.volume[v]).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("dual_renumbered_is_that_of_the_renumbered_mesh", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    auto mesh = mixed_shelf::shaken(entry.mesh, 8);
    const auto before = mesh::build_dual(mesh);
    const auto new_of_old = shelves::random_permutation(mesh.vertex_count(), 9);
    const auto points = mesh.points;
    for (const VertexId v : points.ids()) mesh.points[new_of_old[v]] = points[v];
    for (VertexId& v : mesh.corners.links()) v = new_of_old[v];
    for (auto& facet : mesh.boundary)
      for (std::size_t i = 0; i < facet.corners.size(); ++i) facet.corners[i] = new_of_old[facet.corners[i]];
    const auto renumbered = mesh::renumber_vertices(before, new_of_old);
    // Parts are added up cell by cell in both, so that not a bit differs.
    CHECK(renumbered == mesh::build_dual(mesh));
    CHECK_THROWS_AS((void)mesh::renumber_vertices(before, PerId<VertexId, VertexId>(1)), InputError);
  }
}

TEST_CASE("dual_of_a_broken_mesh_is_refused") {
  MixedMesh<3> mesh = mixed_shelf::single(CellKind::prism);
  mesh.corners[0][2] = VertexId{17};
  CHECK_THROWS_AS((void)mesh::build_dual(mesh), InputError);
}
