// SPDX-License-Identifier: MIT
// Points of space that come and go: after any sequence the tetrahedra are those of the points that are there; location
// and nearest vertices against brute force, batches against single queries.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/delaunay/shapes3.hpp"
#include "tests/delaunay/tet_oracles.hpp"

namespace leonhard {
namespace {

using delaunay::DynamicTetrahedralization;
using delaunay::Extent;
using delaunay::TetLocation;
using Kind = TetLocation::Kind;

/// Spaces, and what spans none.
std::vector<shapes3::NamedPoints> all_families() {
  std::vector<shapes3::NamedPoints> all = shapes3::families();
  all.push_back({"nothing", {}});
  all.push_back({"line", {}});
  for (int i = 0; i < 20; ++i) all.back().points.push_back({3.0 * i, -7.0 * i, 1.0 * i});
  all.push_back({"tilted plane", {}});
  for (const Point3& p : shapes3::grid(5, 4, 1)) all.back().points.push_back({p.x, p.y, 3 * p.x - 2 * p.y});
  all.push_back({"tiny and huge plane",
                 {{0, 0, 1}, {5e-324, 0, 1}, {1e-323, 5e-324, 1}, {1e308, 0, 1}, {0, -1e308, 1}}});
  return all;
}

void require_valid(const DynamicTetrahedralization& sites) {
  const auto broken = sites.validate();
  INFO(broken.value_or(""));
  REQUIRE_FALSE(broken.has_value());
}

std::vector<Point3> living(const DynamicTetrahedralization& sites) {
  std::vector<Point3> points;
  for (const VertexId v : sites.vertices()) points.push_back(sites.point(v));
  return points;
}

/// Valid, and the tetrahedra that tetrahedralize() gives.
void require_same_from_scratch(const DynamicTetrahedralization& sites) {
  require_valid(sites);
  const delaunay::Tetrahedralization made = delaunay::tetrahedralize(living(sites));
  CHECK((made.outcome == delaunay::TetrahedralizeOutcome::done) == (sites.extent() == Extent::space));
  const TetMesh copy = sites.to_mesh().mesh;
  if (sites.extent() == Extent::space) {
    for (const auto& broken : {mesh::validate(copy), mesh::validate_delaunay(copy)}) {
      INFO(broken.value_or(""));
      REQUIRE_FALSE(broken.has_value());
    }
  }
  REQUIRE(mesh::fingerprint(copy) == mesh::fingerprint(made.mesh));
}

TEST_CASE("points_inserted_one_by_one_and_at_once_give_the_tetrahedra_of_tetrahedralize") {
  for (const shapes3::NamedPoints& family : all_families()) {
    CAPTURE(family.name);
    DynamicTetrahedralization single;
    for (const Point3& p : shapes3::shuffled(family.points, 1)) {
      const auto [v, is_new] = single.insert(p);
      CHECK(single.point(v) == p);
      CHECK(single.insert(p).vertex == v);
      CHECK_FALSE(single.insert(p).is_new);
    }
    require_same_from_scratch(single);
    const DynamicTetrahedralization bulk(family.points);
    require_same_from_scratch(bulk);
    CHECK(bulk.fingerprint() == single.fingerprint());
    CHECK(bulk.size() == single.size());
    CHECK(bulk.extent() == single.extent());
    DynamicTetrahedralization halves(std::span(family.points).first(family.points.size() / 2));
    halves.insert(family.points);
    CHECK(halves.fingerprint() == bulk.fingerprint());
  }
}

TEST_CASE("bulk_ids_count_the_distinct_points_in_their_order") {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0},    {0, 0, 0}, {0, 1, 0},
                                   {1, 0, 0}, {-0.0, 1, 0}, {0, 0, 1}};
  DynamicTetrahedralization sites;
  const std::vector<VertexId> ids = sites.insert(points);
  CHECK(ids == std::vector<VertexId>{VertexId{0}, VertexId{1}, VertexId{0}, VertexId{2}, VertexId{1},
                                     VertexId{2}, VertexId{3}});
  CHECK(sites.insert(std::vector<Point3>{{5, 5, 5}, {0, 1, 0}}) ==
        std::vector<VertexId>{VertexId{4}, VertexId{2}});
  require_same_from_scratch(sites);
}

/// The order in which a family is taken down: at random, sorted, sorted backwards, the hull first.
VertexId next_to_go(const DynamicTetrahedralization& sites, int kind, std::mt19937_64& random) {
  std::vector<VertexId> all(sites.vertices().begin(), sites.vertices().end());
  const auto before = [&](VertexId v, VertexId w) { return sites.point(v) < sites.point(w); };
  if (kind == 0) return all[random() % all.size()];
  if (kind == 1) return *std::min_element(all.begin(), all.end(), before);
  if (kind == 2) return *std::max_element(all.begin(), all.end(), before);
  return *std::find_if(all.begin(), all.end(), [&](VertexId v) { return sites.on_hull(v); });
}

TEST_CASE("every_family_can_be_taken_down_to_nothing_in_any_order") {
  std::mt19937_64 random(2);
  for (const shapes3::NamedPoints& family : all_families()) {
    CAPTURE(family.name);
    for (int kind = 0; kind < 4; ++kind) {
      CAPTURE(kind);
      DynamicTetrahedralization sites(family.points);
      for (std::size_t i = 0; !sites.empty(); ++i) {
        const VertexId v = next_to_go(sites, kind, random);
        sites.remove(v);
        CHECK_FALSE(sites.contains(v));
        if (i % 12 == 0 || sites.size() < 12) require_valid(sites);
        if (i % 47 == 0 || sites.size() < 7) require_same_from_scratch(sites);
      }
      CHECK(sites.extent() == Extent::nothing);
    }
  }
}

/// What a tetrahedralisation must know, kept by a map.
class Model {
 public:
  explicit Model(std::vector<Point3> pool) : pool_(std::move(pool)) {}

  void step(std::mt19937_64& random) {
    const Point3 p = pool_[random() % pool_.size()];
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
  void require_ids() const {
    REQUIRE(sites.size() == ids_.size());
    for (const auto& [p, v] : ids_) REQUIRE(sites.point(v) == p);
  }

  DynamicTetrahedralization sites;

 private:
  std::vector<Point3> pool_;
  std::map<Point3, VertexId, std::less<>> ids_;
};

TEST_CASE("random_insertions_and_removals_keep_ids_and_give_the_tetrahedra_from_scratch") {
  std::mt19937_64 random(3);
  for (const shapes3::NamedPoints& family : all_families()) {
    if (family.points.empty()) continue;
    CAPTURE(family.name);
    for (const std::size_t pool_size : {std::size_t{6}, std::size_t{15}, std::size_t{150}}) {
      std::vector<Point3> pool = shapes3::shuffled(family.points, pool_size);
      pool.resize(std::min(pool.size(), pool_size));
      Model model(pool);
      for (int i = 0; i < 100; ++i) {
        model.step(random);
        if (pool_size < 16 || i % 16 == 0) require_valid(model.sites);
        if (i % 32 == 0) require_same_from_scratch(model.sites);
      }
      model.require_ids();
      require_same_from_scratch(model.sites);
    }
  }
}

TEST_CASE("the_extent_rises_and_falls_with_the_points") {
  DynamicTetrahedralization sites;
  CHECK(sites.extent() == Extent::nothing);
  const VertexId first = sites.insert({0, 0, 0}).vertex;
  CHECK(sites.extent() == Extent::point);
  for (int i = 5; i > 0; --i) sites.insert({2.0 * i, 1.0 * i, 3.0 * i});
  CHECK(sites.extent() == Extent::line);
  const VertexId beside = sites.insert({1, 0, 0}).vertex;
  CHECK(sites.extent() == Extent::plane);
  CHECK(sites.neighbours(beside).empty());
  CHECK(sites.to_mesh().mesh == TetMesh{});
  const VertexId above = sites.insert({0, 1, 0}).vertex;
  CHECK(sites.extent() == Extent::space);
  require_same_from_scratch(sites);
  const VertexId below = sites.insert({0, -1, 0}).vertex;
  require_same_from_scratch(sites);
  sites.remove(above);
  CHECK(sites.extent() == Extent::space);
  sites.remove(below);
  CHECK(sites.extent() == Extent::plane);
  sites.remove(beside);
  CHECK(sites.extent() == Extent::line);
  sites.remove(first);
  CHECK(sites.extent() == Extent::line);
  require_same_from_scratch(sites);
}

TEST_CASE("a_tip_upon_a_flat_face_can_be_removed") {
  std::vector<Point3> points = shapes3::grid(4, 4, 1);
  points.push_back({1.5, 1.25, -2});
  DynamicTetrahedralization sites(points);
  const VertexId tip = sites.insert({1.25, 1.5, 1}).vertex;
  CHECK(sites.neighbours(tip).size() == 16);
  const auto corners = sites.tets_at(tip);
  CHECK(corners.size() == 18);
  sites.remove(tip);
  CHECK(sites.extent() == Extent::space);
  require_same_from_scratch(sites);
}

TEST_CASE("a_hub_with_many_neighbours_can_be_removed") {
  std::vector<shapes3::NamedPoints> hubs;
  hubs.push_back({"within a sphere", shapes3::sphere(600)});
  hubs.push_back({"within an integer sphere", shapes3::lattice_sphere(41 * 41)});
  hubs.push_back({"between skew lines", shapes3::skew_lines(25)});
  for (const shapes3::NamedPoints& family : hubs) {
    CAPTURE(family.name);
    DynamicTetrahedralization sites(family.points);
    const VertexId hub =
        sites.insert(family.name == "between skew lines" ? Point3{12.25, 0.5, 12} : Point3{}).vertex;
    CHECK(sites.neighbours(hub).size() > 40);
    sites.remove(hub);
    require_same_from_scratch(sites);
    CHECK(sites.fingerprint() == DynamicTetrahedralization(family.points).fingerprint());
  }
}

TEST_CASE("views_agree_with_the_mesh") {
  for (const shapes3::NamedPoints& family : shapes3::families()) {
    CAPTURE(family.name);
    DynamicTetrahedralization sites(family.points);
    if (sites.size() > 10) sites.remove(VertexId{3});
    const auto [mesh, mesh_vertex] = sites.to_mesh();
    std::set<std::pair<VertexId, VertexId>> from_tets, from_neighbours;
    std::size_t tets = 0, corners = 0;
    for (const auto& tet : sites.tets()) {
      ++tets;
      for (const VertexId a : tet)
        for (const VertexId b : tet)
          if (a != b) from_tets.insert({a, b});
    }
    std::set<VertexId> hull;
    for (const MarkedFace& face : mesh.boundary) hull.insert(face.corners.begin(), face.corners.end());
    for (const VertexId v : sites.vertices()) {
      for (const VertexId w : sites.neighbours(v)) from_neighbours.insert({v, w});
      for (const auto& tet : sites.tets_at(v)) {
        ++corners;
        CHECK(std::count(tet.begin(), tet.end(), v) == 1);
      }
      CHECK(mesh.points[*mesh_vertex[v.index()]] == sites.point(v));
      CHECK(sites.on_hull(v) == (hull.count(*mesh_vertex[v.index()]) == 1));
    }
    CHECK(tets == mesh.tet_count());
    CHECK(corners == 4 * tets);
    CHECK(from_tets == from_neighbours);
    for (const MarkedFace& face : mesh.boundary) {
      const auto& [a, b, c] = face.corners;
      for (const Point3& p : mesh.points)
        REQUIRE(kernel::orient3d(mesh.points[a], mesh.points[b], mesh.points[c], p) != Sign::positive);
    }
  }
}

TEST_CASE("bad_points_and_dead_vertices_are_refused_and_nothing_changes") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  DynamicTetrahedralization sites(shapes3::grid(3, 3, 3));
  const auto before = living(sites);
  CHECK_THROWS_AS(sites.insert({nan, 0, 0}), InputError);
  CHECK_THROWS_AS(sites.insert({0, 0, -infinity}), InputError);
  CHECK_THROWS_WITH_AS(sites.insert(std::vector<Point3>{{8, 8, 8}, {0, nan, 0}}),
                       doctest::Contains("point 1"), InputError);
  CHECK_THROWS_WITH_AS(DynamicTetrahedralization(std::vector<Point3>{{8, 8, 8}, {infinity, 0, 0}}),
                       doctest::Contains("point 1"), InputError);
  CHECK_THROWS_AS(sites.remove(VertexId{27}), InputError);
  CHECK_THROWS_AS((void)sites.locate({nan, 0, 0}), InputError);
  CHECK_THROWS_AS((void)sites.nearest_vertex({0, nan, 0}), InputError);
  CHECK_THROWS_AS((void)sites.locate(std::vector<Point3>{{0, 0, nan}}), InputError);
  CHECK(living(sites) == before);
  sites.remove(VertexId{5});
  CHECK_THROWS_WITH_AS(sites.remove(VertexId{5}), doctest::Contains("vertex 5"), InputError);
  CHECK_THROWS_AS((void)sites.neighbours(VertexId{5}), InputError);
  CHECK_THROWS_AS((void)sites.tets_at(VertexId{5}), InputError);
  CHECK_THROWS_AS((void)sites.on_hull(VertexId{5}), InputError);
  CHECK(sites.insert(before[5]).vertex == VertexId{5});
  CHECK(living(sites) == before);
  require_same_from_scratch(sites);
}

TEST_CASE("a_copy_lives_on_its_own") {
  DynamicTetrahedralization sites(shapes3::grid(3, 3, 3));
  const DynamicTetrahedralization copy = sites;
  for (unsigned v = 0; v < 12; ++v) sites.remove(VertexId{v});
  CHECK(copy.size() == 27);
  require_same_from_scratch(copy);
  require_same_from_scratch(sites);
}

// ---- queries ----

/// States to ask: every family, some of it removed again.
std::vector<DynamicTetrahedralization> states() {
  std::vector<DynamicTetrahedralization> all;
  for (const shapes3::NamedPoints& family : all_families()) {
    all.emplace_back(family.points);
    DynamicTetrahedralization thinned(family.points);
    for (unsigned v = 0; v < thinned.id_bound(); v += 3) thinned.remove(VertexId{v});
    all.push_back(thinned);
  }
  return all;
}

/// Vertices, midpoints of edges, places in faces, and points all around.
std::vector<Point3> queries(const DynamicTetrahedralization& sites, std::uint64_t seed) {
  std::vector<Point3> points{
      {0, 0, 0}, {0.5, 0.5, 0.5}, {1e308, -1e308, 1e308}, {-5e-324, 5e-324, 0}, {1, 1, 1}};
  const auto half = [](const Point3& a, const Point3& b) {
    return Point3{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  };
  for (const VertexId v : sites.vertices()) points.push_back(sites.point(v));
  for (const auto& [a, b, c, d] : sites.tets()) {
    const Point3 ab = half(sites.point(a), sites.point(b)), face = half(ab, sites.point(c));
    points.insert(points.end(), {ab, face, half(face, sites.point(d))});
  }
  std::mt19937_64 random(seed);
  for (std::size_t i = points.size(); i-- > 5;) {
    const Point3 p = half(points[random() % points.size()], points[random() % points.size()]);
    points.push_back(p);
    points.push_back({2 * p.x - points[i].x / 2, 2 * p.y - points[i].y / 2, 2 * p.z - points[i].z / 2});
  }
  points.erase(std::remove_if(points.begin(), points.end(), [](const Point3& p) { return !is_finite(p); }),
               points.end());
  points = shapes3::shuffled(points, seed);
  points.resize(std::min<std::size_t>(points.size(), 24));
  return points;
}

/// Whether p adds nothing to what the points span.
bool in_span_of(const std::vector<Point3>& points, const Point3& p) {
  std::vector<Point3> with = points;
  with.push_back(p);
  return delaunay::first_tetrahedron(with).extent == delaunay::first_tetrahedron(points).extent;
}

/// The only right answer, from a look at every tetrahedron.
TetLocation brute_location(const DynamicTetrahedralization& sites, const Point3& p) {
  for (const VertexId v : sites.vertices())
    if (sites.point(v) == p) return {Kind::on_vertex, {v}};
  if (sites.extent() != Extent::space)
    return {!sites.empty() && in_span_of(living(sites), p) ? Kind::in_span : Kind::outside, {}};
  for (const auto& corners : sites.tets()) {
    std::vector<VertexId> carrier;
    bool inside = true;
    for (std::size_t i = 0; i < 4 && inside; ++i) {
      std::array<Point3, 4> q;
      for (std::size_t k = 0; k < 4; ++k) q[k] = k == i ? p : sites.point(corners[k]);
      const Sign side = kernel::orient3d(q[0], q[1], q[2], q[3]);
      inside = side != Sign::negative;
      if (side == Sign::positive) carrier.push_back(corners[i]);
    }
    if (!inside) continue;
    std::sort(carrier.begin(), carrier.end());
    TetLocation at;
    at.kind = carrier.size() == 2   ? Kind::on_edge
              : carrier.size() == 3 ? Kind::on_face
                                    : Kind::in_tetrahedron;
    if (carrier.size() == 4 &&
        kernel::exact::orient3d(sites.point(carrier[0]), sites.point(carrier[1]), sites.point(carrier[2]),
                                sites.point(carrier[3])) == Sign::negative)
      std::swap(carrier[2], carrier[3]);
    std::copy(carrier.begin(), carrier.end(), at.vertices.begin());
    return at;
  }
  return {};
}

MaybeId<VertexId> brute_nearest(const DynamicTetrahedralization& sites, const Point3& p) {
  MaybeId<VertexId> best;
  for (const VertexId v : sites.vertices()) {
    if (!best) best = v;
    const Sign sign = kernel::exact::compare_distance(p, sites.point(v), sites.point(*best));
    if (sign == Sign::negative || (sign == Sign::zero && sites.point(v) < sites.point(*best))) best = v;
  }
  return best;
}

MaybeId<VertexId> any_hint(const DynamicTetrahedralization& sites, std::mt19937_64& random) {
  if (sites.id_bound() == 0 || random() % 4 == 0) return {};
  return VertexId::from(random() % (sites.id_bound() + 2));  // some are removed or have never been
}

TEST_CASE("location_in_space_is_that_of_brute_force_from_any_hint") {
  std::mt19937_64 random(4);
  std::set<Kind> kinds;
  for (const DynamicTetrahedralization& sites : states()) {
    CAPTURE(sites.size());
    for (const Point3& p : queries(sites, 1)) {
      const TetLocation expected = brute_location(sites, p);
      kinds.insert(expected.kind);
      CHECK(sites.locate(p) == expected);
      CHECK(sites.locate(p, any_hint(sites, random)) == expected);
    }
  }
  CHECK(kinds.size() == 6);
}

TEST_CASE("nearest_vertices_in_space_are_those_of_brute_force_ties_to_the_lexicographically_first") {
  std::mt19937_64 random(5);
  for (const DynamicTetrahedralization& sites : states()) {
    CAPTURE(sites.size());
    for (const Point3& p : queries(sites, 2)) {
      const MaybeId<VertexId> expected = brute_nearest(sites, p);
      CHECK(sites.nearest_vertex(p) == expected);
      CHECK(sites.nearest_vertex(p, any_hint(sites, random)) == expected);
    }
  }
}

TEST_CASE("many_queries_at_once_have_the_answers_of_single_ones") {
  for (const std::size_t n : {std::size_t{0}, std::size_t{30}, std::size_t{1500}}) {
    const DynamicTetrahedralization sites(shapes3::uniform(n, 7));
    const std::vector<Point3> points = shapes3::transformed(shapes3::uniform(3000, 8), 1.1, 0);
    for (const unsigned threads : {1U, 2U, 0U}) {
      const auto locations = sites.locate(points, threads);
      const auto nearest = sites.nearest_vertices(points, threads);
      REQUIRE(locations.size() == points.size());
      REQUIRE(nearest.size() == points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        REQUIRE(locations[i] == sites.locate(points[i]));
        REQUIRE(nearest[i] == sites.nearest_vertex(points[i]));
      }
    }
  }
}

}  // namespace
}  // namespace leonhard
