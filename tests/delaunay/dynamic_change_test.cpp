// SPDX-License-Identifier: MIT
// Insertion and removal: after any sequence the triangles are those of the points that are there.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::DynamicTriangulation;
using delaunay::Extent;

std::vector<shapes::NamedPoints> all_families() {
  std::vector<shapes::NamedPoints> all = shapes::families();
  std::vector<Point2> line, steep;
  for (int i = 0; i < 40; ++i) line.push_back({3.0 * i, -7.0 * i}), steep.push_back({0.1, 0.3 * i});
  all.push_back({"line", line});
  all.push_back({"steep line", steep});
  all.push_back({"tiny line", {{0, 0}, {5e-324, 0}, {1e-323, 0}, {0, 5e-324}, {1e308, 0}}});
  return all;
}

void require_valid(const DynamicTriangulation& sites) {
  const auto broken = sites.validate();
  INFO(broken.value_or(""));
  REQUIRE_FALSE(broken.has_value());
}

std::vector<Point2> living(const DynamicTriangulation& sites) {
  std::vector<Point2> points;
  for (const VertexId v : sites.vertices()) points.push_back(sites.point(v));
  return points;
}

/// Valid, and the triangles that triangulate() gives.
void require_same_from_scratch(const DynamicTriangulation& sites) {
  require_valid(sites);
  const DynamicTriangulation::Mesh copy = sites.to_mesh();
  if (sites.extent() == Extent::plane) shapes::require_valid(copy.mesh);
  REQUIRE(mesh::fingerprint(copy.mesh) == mesh::fingerprint(delaunay::triangulate(living(sites)).mesh));
}

TEST_CASE("points_inserted_one_by_one_and_at_once_give_the_triangles_of_triangulate") {
  for (const shapes::NamedPoints& family : all_families()) {
    CAPTURE(family.name);
    DynamicTriangulation single;
    for (const Point2 p : family.points) {
      const auto [v, is_new] = single.insert(p);
      CHECK(single.point(v) == p);
      CHECK(single.insert(p).vertex == v);
      CHECK_FALSE(single.insert(p).is_new);
    }
    require_same_from_scratch(single);
    const DynamicTriangulation bulk(family.points);
    require_same_from_scratch(bulk);
    CHECK(bulk.fingerprint() == single.fingerprint());
    CHECK(bulk.size() == single.size());
  }
}

TEST_CASE("bulk_ids_count_the_distinct_points_in_their_order") {
  const std::vector<Point2> points{{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}, {-0.0, 1}};
  DynamicTriangulation sites;
  const std::vector<VertexId> ids = sites.insert(points);
  const std::vector<VertexId> expected{VertexId{0}, VertexId{1}, VertexId{0},
                                       VertexId{2}, VertexId{1}, VertexId{2}};
  CHECK(ids == expected);
  const std::vector<VertexId> more = sites.insert(std::vector<Point2>{{5, 5}, {0, 1}});
  CHECK(more == std::vector<VertexId>{VertexId{3}, VertexId{2}});
  require_same_from_scratch(sites);
}

TEST_CASE("every_family_can_be_taken_down_to_nothing_in_any_order") {
  for (const shapes::NamedPoints& family : all_families()) {
    CAPTURE(family.name);
    for (int kind = 0; kind < 4; ++kind) {
      CAPTURE(kind);
      DynamicTriangulation sites(family.points);
      std::vector<VertexId> order(sites.vertices().begin(), sites.vertices().end());
      const auto at = [&](VertexId v) { return sites.point(v); };
      if (kind == 0) order = shapes::shuffled(order, 7);
      if (kind == 1) std::sort(order.begin(), order.end(), [&](auto v, auto w) { return at(v) < at(w); });
      if (kind == 2) std::reverse(order.begin(), order.end());
      for (std::size_t i = 0; i < order.size(); ++i) {
        // Kind 3: the hull away, layer by layer.
        const VertexId v = kind == 3 ? sites.hull().back() : order[i];
        sites.remove(v);
        CHECK_FALSE(sites.contains(v));
        require_valid(sites);
        if (i % 29 == 0 || sites.size() < 6) require_same_from_scratch(sites);
      }
      CHECK(sites.empty());
      CHECK(sites.extent() == Extent::nothing);
    }
  }
}

/// A model: what a triangulation must know, kept by a map.
class Model {
 public:
  explicit Model(std::vector<Point2> pool) : pool_(std::move(pool)) {}

  void step(std::mt19937_64& random) {
    const Point2 p = pool_[random() % pool_.size()];
    const auto known = ids_.find(p);
    const MaybeId<VertexId> hint = sites.id_bound() > 0
                                       ? MaybeId<VertexId>(VertexId::from(random() % sites.id_bound()))
                                       : MaybeId<VertexId>{};
    if (known != ids_.end() && random() % 2 == 0) {
      sites.remove(known->second);
      ids_.erase(known);
    } else {
      const auto [v, is_new] = sites.insert(p, hint);
      CHECK(is_new == (known == ids_.end()));
      if (!is_new) CHECK(v == known->second);
      ids_.emplace(p, v);
    }
  }
  /// Ids of living vertices are what they were.
  void require_ids() const {
    REQUIRE(sites.size() == ids_.size());
    for (const auto& [p, v] : ids_) REQUIRE(sites.point(v) == p);
  }

  DynamicTriangulation sites;

 private:
  std::vector<Point2> pool_;
  std::map<Point2, VertexId, std::less<>> ids_;
};

TEST_CASE("random_insertions_and_removals_keep_ids_and_give_the_triangles_from_scratch") {
  std::mt19937_64 random(3);
  for (const shapes::NamedPoints& family : all_families()) {
    CAPTURE(family.name);
    for (const std::size_t pool_size : {std::size_t{4}, std::size_t{12}, std::size_t{400}}) {
      std::vector<Point2> pool = shapes::shuffled(family.points, pool_size);
      pool.resize(std::min(pool.size(), pool_size));
      Model model(pool);
      for (int i = 0; i < 300; ++i) {
        model.step(random);
        if (pool_size < 400 || i % 16 == 0) require_valid(model.sites);
        if (i % 32 == 0) require_same_from_scratch(model.sites);
      }
      model.require_ids();
      require_same_from_scratch(model.sites);
    }
  }
}

TEST_CASE("the_extent_rises_with_the_point_off_the_line_and_falls_when_it_goes") {
  DynamicTriangulation sites;
  CHECK(sites.extent() == Extent::nothing);
  const VertexId first = sites.insert({0, 0}).vertex;
  CHECK(sites.extent() == Extent::point);
  for (int i = 5; i > 0; --i) sites.insert({2.0 * i, 1.0 * i});
  CHECK(sites.extent() == Extent::line);
  CHECK(sites.hull().size() == 6);
  CHECK(std::distance(sites.edges().begin(), sites.edges().end()) == 5);
  const VertexId above = sites.insert({0, 1}).vertex;
  CHECK(sites.extent() == Extent::plane);
  require_same_from_scratch(sites);
  const VertexId below = sites.insert({1, 0}).vertex;
  require_same_from_scratch(sites);
  sites.remove(above);
  CHECK(sites.extent() == Extent::plane);
  sites.remove(below);
  CHECK(sites.extent() == Extent::line);
  require_same_from_scratch(sites);
  sites.remove(first);
  CHECK(sites.extent() == Extent::line);
  CHECK(sites.hull().size() == 5);
}

TEST_CASE("views_agree_with_the_mesh") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    DynamicTriangulation sites(family.points);
    if (sites.size() > 10) sites.remove(VertexId{3});
    const auto [mesh, mesh_vertex] = sites.to_mesh();
    std::set<delaunay::VertexPair> edges, from_triangles, from_neighbours;
    std::size_t edge_count = 0;
    for (const auto& [a, b] : sites.edges()) edges.insert({std::min(a, b), std::max(a, b)}), ++edge_count;
    CHECK(edges.size() == edge_count);
    std::size_t triangle_count = 0;
    for (const auto& corners : sites.triangles()) {
      ++triangle_count;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = corners[i], b = corners[(i + 1) % 3];
        from_triangles.insert({std::min(a, b), std::max(a, b)});
      }
    }
    for (const VertexId v : sites.vertices())
      for (const VertexId w : sites.neighbours(v)) from_neighbours.insert({std::min(v, w), std::max(v, w)});
    CHECK(triangle_count == mesh.triangle_count());
    CHECK(edges == from_triangles);
    CHECK(edges == from_neighbours);
    CHECK(sites.hull().size() == mesh.boundary.size());
    for (const VertexId v : sites.vertices()) CHECK(mesh.points[*mesh_vertex[v.index()]] == sites.point(v));
  }
}

TEST_CASE("neighbours_and_hull_turn_counter_clockwise") {
  DynamicTriangulation sites(std::vector<Point2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 0}});
  CHECK(sites.hull() ==
        std::vector<VertexId>{VertexId{0}, VertexId{5}, VertexId{1}, VertexId{2}, VertexId{3}});
  const delaunay::NeighbourView view = sites.neighbours(VertexId{4});
  const std::vector<VertexId> around(view.begin(), view.end());
  REQUIRE(around.size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(kernel::orient2d({1, 1}, sites.point(around[i]), sites.point(around[(i + 1) % 5])) ==
          Sign::positive);
}

TEST_CASE("bad_points_and_dead_vertices_are_refused_and_nothing_changes") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  DynamicTriangulation sites(shapes::grid(4));
  const Fingerprint before = sites.fingerprint();
  CHECK_THROWS_AS(sites.insert({nan, 0}), InputError);
  CHECK_THROWS_AS(sites.insert({0, -infinity}), InputError);
  CHECK_THROWS_WITH_AS(sites.insert(std::vector<Point2>{{8, 8}, {nan, 0}}), doctest::Contains("point 1"),
                       InputError);
  CHECK_THROWS_WITH_AS(DynamicTriangulation(std::vector<Point2>{{8, 8}, {infinity, 0}}),
                       doctest::Contains("point 1"), InputError);
  CHECK_THROWS_AS(sites.remove(VertexId{16}), InputError);
  CHECK_THROWS_AS((void)sites.locate({nan, 0}), InputError);
  CHECK(sites.size() == 16);
  CHECK(sites.fingerprint() == before);
  sites.remove(VertexId{5});
  CHECK_THROWS_WITH_AS(sites.remove(VertexId{5}), doctest::Contains("vertex 5"), InputError);
  CHECK_THROWS_AS((void)sites.neighbours(VertexId{5}), InputError);
  CHECK_THROWS_WITH_AS((void)sites.point(VertexId{5}), doctest::Contains("vertex 5"), InputError);
  CHECK_THROWS_WITH_AS((void)sites.point(VertexId{4000}), doctest::Contains("vertex 4000"), InputError);
  CHECK(sites.insert({1, 1}).vertex == VertexId{5});
  CHECK(sites.fingerprint() == before);
}

TEST_CASE("a_copy_lives_on_its_own") {
  DynamicTriangulation sites(shapes::grid(5));
  const DynamicTriangulation copy = sites;
  const Fingerprint before = copy.fingerprint();
  for (unsigned v = 0; v < 12; ++v) sites.remove(VertexId{v});
  CHECK(copy.fingerprint() == before);
  require_same_from_scratch(copy);
  require_same_from_scratch(sites);
}

/// Points that all become neighbours of the last one, within the hull or on it, far more than are filled
/// directly.
std::vector<shapes::NamedPoints> hubs() {
  std::vector<shapes::NamedPoints> all;
  all.push_back({"within cocircular points", shapes::lattice_circle(5 * 13 * 17 * 29)});
  all.push_back({"within a circle", shapes::circle(20'000)});
  all.push_back({"beside a line with one point behind", {{5000, 1}}});
  for (int i = 0; i < 20'000; ++i) all.back().points.push_back({static_cast<double>(i), 0});
  all.push_back({"beside a line", {}});
  for (int i = 0; i < 20'000; ++i) all.back().points.push_back({static_cast<double>(i), 0});
  all.push_back({"beside an arc", {}});
  for (const Point2 p : shapes::parabola(5'000)) all.back().points.push_back(p);
  return all;
}

TEST_CASE("a_hub_with_many_neighbours_can_be_removed") {
  for (const shapes::NamedPoints& family : hubs()) {
    CAPTURE(family.name);
    DynamicTriangulation sites(family.points);
    const bool within = family.name.find("within") == 0;
    const VertexId hub = sites.insert(within ? Point2{0, 0} : Point2{10, -1e9}).vertex;
    const delaunay::NeighbourView around = sites.neighbours(hub);
    const auto degree = static_cast<std::size_t>(std::distance(around.begin(), around.end()));
    CHECK(degree + 1 >= family.points.size());
    sites.remove(hub);
    require_same_from_scratch(sites);
  }
}

TEST_CASE("a_hub_among_reflex_corners_can_be_removed") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> off(-0.0015, 0.0015);
  for (int i = 0; i < 30; ++i) {
    std::vector<Point2> points{{0, 0}};
    for (const Point2 p : shapes::circle(100)) points.push_back(p + off(random) * (p - Point2{}));
    for (const Point2 p : shapes::circle(30)) points.push_back({1.5 * p.x, 1.5 * p.y});
    DynamicTriangulation sites(points);
    sites.remove(VertexId{0});
    require_same_from_scratch(sites);
  }
}

TEST_CASE("a_hundred_thousand_insertions_and_half_as_many_removals_end_as_from_scratch") {
  const std::vector<Point2> points = shapes::uniform(100'000, 5);
  DynamicTriangulation sites;
  for (const Point2 p : points) sites.insert(p);
  std::mt19937_64 random(9);
  for (std::size_t removed = 0; removed < 50'000;) {
    const VertexId v = VertexId::from(random() % sites.id_bound());
    if (!sites.contains(v)) continue;
    sites.remove(v);
    ++removed;
  }
  require_same_from_scratch(sites);
}

}  // namespace
}  // namespace leonhard
