// SPDX-License-Identifier: MIT
// The calls that DynamicTriangulation and DynamicTetrahedralization share, one text for both: incidence, counts, the k
// nearest vertices, interpolation, moves, Voronoi cells and refusals against brute force in every family of points.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/delaunay/shapes.hpp"
#include "tests/delaunay/shapes3.hpp"

namespace leonhard {
namespace {

using delaunay::DynamicTetrahedralization;
using delaunay::DynamicTriangulation;
using delaunay::Extent;
using delaunay::MoveOutcome;
using delaunay::VertexWeight;

using Cell = std::vector<VertexId>;  // corners in rising order

// ---- what differs ----

template <class Sites>
struct Twin;

template <>
struct Twin<DynamicTriangulation> {
  using Point = Point2;
  static constexpr Extent full = Extent::plane;

  static std::vector<std::vector<Point2>> families() {
    std::vector<std::vector<Point2>> all{
        {}, {{0.5, 0.25}}, {{0, 3}, {0, 1}}, {{0, 0}, {1, 2}, {-3, -6}, {8, 16}}};
    for (const shapes::NamedPoints& family : shapes::families()) all.push_back(family.points);
    return all;
  }
  static std::vector<Point2> uniform(std::size_t n, std::uint64_t seed) { return shapes::uniform(n, seed); }
  static Point2 between(Point2 a, Point2 b, double t) {
    return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
  }
  static double linear(Point2 p) { return 3 * p.x - 7 * p.y + 2; }
  static Point2 not_a_place() { return {0, std::numeric_limits<double>::quiet_NaN()}; }
  static std::array<double, 3> coordinates(Point2 p) { return {p.x, p.y, 0}; }

  static auto cells(const DynamicTriangulation& sites) { return sites.triangles(); }
  static std::size_t cell_count(const DynamicTriangulation& sites) { return sites.triangle_count(); }
  static auto cells_at(const DynamicTriangulation& sites, VertexId v) { return sites.triangles_at(v); }
  static std::set<VertexId> on_hull(const DynamicTriangulation& sites) {
    const std::vector<VertexId> loop = sites.hull();
    return {loop.begin(), loop.end()};
  }
  static std::vector<VertexId> across(const delaunay::VoronoiCell& cell) { return cell.across; }
};

template <>
struct Twin<DynamicTetrahedralization> {
  using Point = Point3;
  static constexpr Extent full = Extent::space;

  static std::vector<std::vector<Point3>> families() {
    std::vector<std::vector<Point3>> all{{}, {{0.5, 0.25, 2}}, {{0, 3, 1}, {0, 1, 1}}, {}, {}};
    for (int i = 0; i < 20; ++i) all[3].push_back({3.0 * i, -7.0 * i, 1.0 * i});
    for (const Point3& p : shapes3::grid(5, 4, 1)) all[4].push_back({p.x, p.y, 3 * p.x - 2 * p.y});
    for (const shapes3::NamedPoints& family : shapes3::families()) all.push_back(family.points);
    return all;
  }
  static std::vector<Point3> uniform(std::size_t n, std::uint64_t seed) { return shapes3::uniform(n, seed); }
  static Point3 between(const Point3& a, const Point3& b, double t) {
    return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, (1 - t) * a.z + t * b.z};
  }
  static double linear(const Point3& p) { return 3 * p.x - 7 * p.y + 5 * p.z + 2; }
  static Point3 not_a_place() { return {0, 1, std::numeric_limits<double>::infinity()}; }
  static std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

  static auto cells(const DynamicTetrahedralization& sites) { return sites.tets(); }
  static std::size_t cell_count(const DynamicTetrahedralization& sites) { return sites.tet_count(); }
  static auto cells_at(const DynamicTetrahedralization& sites, VertexId v) { return sites.tets_at(v); }
  static std::set<VertexId> on_hull(const DynamicTetrahedralization& sites) {
    std::set<VertexId> all;
    for (const auto& face : sites.hull()) all.insert(face.begin(), face.end());
    if (sites.extent() != Extent::space) all.insert(sites.vertices().begin(), sites.vertices().end());
    return all;
  }
  static std::vector<VertexId> across(const delaunay::TetVoronoiCell& cell) {
    std::vector<VertexId> all;
    for (const auto& face : cell.faces) all.push_back(face.across);
    return all;
  }
};

// ---- states and places to ask ----

/// Every family, some of it removed again.
template <class Sites>
std::vector<Sites> states() {
  std::vector<Sites> all;
  for (const auto& family : Twin<Sites>::families()) {
    all.emplace_back(family);
    Sites thinned(family);
    for (std::size_t v = 0; v < thinned.id_bound(); v += 3) thinned.remove(VertexId::from(v));
    all.push_back(thinned);
  }
  return all;
}

/// Vertices, midpoints of edges and places between these.
template <class Sites>
auto places(const Sites& sites, std::size_t count, std::uint64_t seed) {
  using T = Twin<Sites>;
  std::vector<typename T::Point> points = T::uniform(4, seed);
  std::mt19937_64 random(seed);
  for (const VertexId v : sites.vertices()) points.push_back(sites.point(v));
  for (const auto& [a, b] : sites.edges()) points.push_back(T::between(sites.point(a), sites.point(b), 0.5));
  for (std::size_t i = points.size(); i-- > 0;) {
    const auto p = points[random() % points.size()];
    points.push_back(T::between(points[random() % points.size()], p, 0.25));
    points.push_back(T::between(points[i], p, 1.25));
  }
  std::erase_if(points, [](const auto& p) { return !is_finite(p); });
  std::shuffle(points.begin(), points.end(), random);
  points.resize(std::min(points.size(), count));
  return points;
}

template <class Sites>
MaybeId<VertexId> any_hint(const Sites& sites, std::mt19937_64& random) {
  if (sites.id_bound() == 0 || random() % 4 == 0) return {};
  return VertexId::from(random() % (sites.id_bound() + 2));  // some are removed or have never been
}

template <class Cells>
std::multiset<Cell> sorted_cells(const Cells& cells) {
  std::multiset<Cell> all;
  for (const auto& corners : cells) {
    Cell cell(corners.begin(), corners.end());
    std::sort(cell.begin(), cell.end());
    all.insert(cell);
  }
  return all;
}

// ---- incidence ----

TEST_CASE_TEMPLATE("edges_neighbours_cells_and_counts_agree", Sites, DynamicTriangulation,
                   DynamicTetrahedralization) {
  using T = Twin<Sites>;
  for (const Sites& sites : states<Sites>()) {
    CAPTURE(sites.size());
    const std::multiset<Cell> cells = sorted_cells(T::cells(sites));
    CHECK(T::cell_count(sites) == cells.size());
    std::set<Cell> from_cells, from_neighbours;
    std::multiset<Cell> edges;
    for (const auto& [a, b] : sites.edges()) edges.insert({std::min(a, b), std::max(a, b)});
    for (const Cell& cell : cells)
      for (const VertexId a : cell)
        for (const VertexId b : cell)
          if (a < b) from_cells.insert({a, b});
    const std::set<VertexId> hull = T::on_hull(sites);
    for (const VertexId v : sites.vertices()) {
      for (const VertexId w : sites.neighbours(v)) from_neighbours.insert({std::min(v, w), std::max(v, w)});
      std::multiset<Cell> mine;
      for (const Cell& cell : cells)
        if (std::count(cell.begin(), cell.end(), v) > 0) mine.insert(cell);
      CHECK(sorted_cells(T::cells_at(sites, v)) == mine);
      CHECK(sites.on_hull(v) == (hull.count(v) > 0));
    }
    CHECK(edges.size() == sites.edge_count());
    CHECK(std::set<Cell>(edges.begin(), edges.end()).size() == edges.size());
    CHECK(std::set<Cell>(edges.begin(), edges.end()) == from_neighbours);
    if (sites.extent() == T::full) CHECK(from_cells == from_neighbours);
  }
}

TEST_CASE("triangles_at_a_vertex_start_with_it_and_turn_counter_clockwise") {
  for (const DynamicTriangulation& sites : states<DynamicTriangulation>())
    for (const VertexId v : sites.vertices()) {
      const auto triangles = sites.triangles_at(v);
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        CHECK(triangles[i][0] == v);
        CHECK(kernel::exact::orient2d(sites.point(v), sites.point(triangles[i][1]),
                                      sites.point(triangles[i][2])) == Sign::positive);
        if (i > 0) CHECK(triangles[i][1] == triangles[i - 1][2]);
      }
      if (!triangles.empty()) CHECK(sites.on_hull(v) == (triangles.front()[1] != triangles.back()[2]));
    }
}

TEST_CASE("the_hull_of_space_is_the_boundary_of_the_mesh") {
  for (const DynamicTetrahedralization& sites : states<DynamicTetrahedralization>()) {
    const auto [mesh, mesh_vertex] = sites.to_mesh();
    std::set<std::array<VertexId, 3>> boundary;
    for (const MarkedFace& face : mesh.boundary) {
      auto corners = face.corners;
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      boundary.insert(corners);
    }
    const auto hull = sites.hull();
    CHECK(std::is_sorted(hull.begin(), hull.end()));
    std::set<std::array<VertexId, 3>> in_mesh;
    for (const auto& [a, b, c] : hull) {
      CHECK((a < b && a < c));
      in_mesh.insert({*mesh_vertex[a.index()], *mesh_vertex[b.index()], *mesh_vertex[c.index()]});
    }
    CHECK(hull.size() == boundary.size());
    CHECK(in_mesh == boundary);  // mesh_vertex keeps the order of ids
  }
}

// ---- k nearest ----

TEST_CASE_TEMPLATE("the_k_nearest_vertices_are_those_of_brute_force_in_their_order", Sites,
                   DynamicTriangulation, DynamicTetrahedralization) {
  std::mt19937_64 random(6);
  for (const Sites& sites : states<Sites>()) {
    CAPTURE(sites.size());
    for (const auto& p : places(sites, 6, 3)) {
      std::vector<VertexId> all(sites.vertices().begin(), sites.vertices().end());
      std::sort(all.begin(), all.end(), [&](VertexId a, VertexId b) {
        const Sign sign = kernel::exact::compare_distance(p, sites.point(a), sites.point(b));
        return sign == Sign::negative || (sign == Sign::zero && sites.point(a) < sites.point(b));
      });
      for (const std::size_t k :
           {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{9}, all.size() + 1}) {
        std::vector<VertexId> expected = all;
        expected.resize(std::min(k, all.size()));
        CHECK(sites.k_nearest_vertices(p, k, any_hint(sites, random)) == expected);
      }
    }
  }
}

// ---- interpolation ----

/// How far a convex combination is from p, as a part of the distances that it sums; and from a sum of 1.
template <class Sites, class Point>
double error_of(const Sites& sites, const Point& p, const std::vector<VertexWeight>& weights) {
  std::array<mpq_class, 3> off{0, 0, 0};
  mpq_class sum = 0, size = 0, total = 0;
  const auto here = Twin<Sites>::coordinates(p);
  for (const auto& [v, weight] : weights) {
    CHECK(weight >= 0);
    const auto there = Twin<Sites>::coordinates(sites.point(v));
    for (std::size_t i = 0; i < 3; ++i) {
      const mpq_class arm = mpq_class(there[i]) - mpq_class(here[i]);
      off[i] += weight * arm;
      size += weight * abs(arm);
    }
    total += weight;
  }
  for (const mpq_class& part : off) sum += abs(part);
  const mpq_class relative = size == 0 ? sum : mpq_class(sum / size);
  return std::max(relative.get_d(), mpq_class(abs(mpq_class(total - 1))).get_d());
}

TEST_CASE_TEMPLATE("weights_are_convex_combinations_in_every_family_whatever_the_hint", Sites,
                   DynamicTriangulation, DynamicTetrahedralization) {
  std::mt19937_64 random(8);
  std::size_t inside = 0;
  for (const Sites& sites : states<Sites>()) {
    CAPTURE(sites.size());
    for (const auto& p : places(sites, 30, 4)) {
      const auto found = sites.natural_neighbours(p);
      const auto at = sites.locate(p);
      CHECK(found.where == at.kind);
      CHECK(found.inside() == at.inside());
      CHECK(found.weights.empty() == !at.inside());
      CHECK(sites.natural_neighbours(p, any_hint(sites, random)).weights == found.weights);
      if (!at.inside()) continue;
      ++inside;
      CHECK(error_of(sites, p, found.weights) < 1e-9);
    }
  }
  CHECK(inside > 300);
}

TEST_CASE_TEMPLATE("linear_functions_are_reproduced_by_both_interpolations", Sites, DynamicTriangulation,
                   DynamicTetrahedralization) {
  using T = Twin<Sites>;
  const Sites sites(T::uniform(1000, 21));
  std::vector<double> values;
  for (const VertexId v : sites.vertices()) values.push_back(T::linear(sites.point(v)));
  std::size_t inside = 0;
  for (const auto& p : T::uniform(1000, 22)) {
    const auto linear = sites.interpolate_linear(p, values);
    const auto natural = sites.interpolate_natural_neighbour(p, values);
    CHECK(linear.where == natural.where);
    if (!linear.inside()) {
      CHECK(std::isnan(linear.value));
      CHECK(std::isnan(natural.value));
      continue;
    }
    ++inside;
    CHECK(linear.value == doctest::Approx(T::linear(p)).epsilon(1e-10).scale(1));
    CHECK(natural.value == doctest::Approx(T::linear(p)).epsilon(1e-10).scale(1));
  }
  CHECK(inside > 800);
}

TEST_CASE_TEMPLATE("batches_have_the_answers_of_single_queries_to_the_bit", Sites, DynamicTriangulation,
                   DynamicTetrahedralization) {
  const auto same = [](const auto& a, const auto& b) {
    return a.where == b.where && (a.value == b.value || !a.inside());
  };
  for (const Sites& sites : states<Sites>()) {
    CAPTURE(sites.size());
    const auto points = places(sites, 25, 5);
    std::vector<double> values;
    for (std::size_t i = 0; i < sites.id_bound(); ++i) values.push_back(static_cast<double>(i % 17) / 3);
    const auto located = sites.locate(points, 2);
    const auto nearest = sites.nearest_vertices(points, 2);
    const auto linear = sites.interpolate_linear(points, values, 2);
    const auto natural = sites.interpolate_natural_neighbour(points, values, 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(located.at(i) == sites.locate(points[i]));
      CHECK(nearest.at(i) == sites.nearest_vertex(points[i]));
      CHECK(same(linear.at(i), sites.interpolate_linear(points[i], values)));
      CHECK(same(natural.at(i), sites.interpolate_natural_neighbour(points[i], values)));
    }
  }
}

// ---- moves ----

TEST_CASE_TEMPLATE("moved_vertices_keep_their_ids_and_the_cells_are_those_from_scratch", Sites,
                   DynamicTriangulation, DynamicTetrahedralization) {
  using T = Twin<Sites>;
  std::mt19937_64 random(9);
  for (const auto& family : T::families()) {
    if (family.empty()) continue;
    CAPTURE(family.size());
    Sites sites(family);
    std::map<VertexId, typename T::Point> model;
    for (const VertexId v : sites.vertices()) model[v] = sites.point(v);
    for (int step = 0; step < 25; ++step) {
      const VertexId v =
          std::next(model.begin(), static_cast<std::ptrdiff_t>(random() % model.size()))->first;
      const auto candidates = places(sites, 1, random());
      const auto to =
          step % 5 == 0
              ? std::next(model.begin(), static_cast<std::ptrdiff_t>(random() % model.size()))->second
              : candidates.front();
      const auto occupant =
          std::find_if(model.begin(), model.end(), [&](const auto& m) { return m.second == to; });
      const delaunay::Moved moved = sites.move(v, to);
      if (occupant == model.end() || occupant->first == v) {
        CHECK(moved.outcome == MoveOutcome::moved);
        CHECK(moved.vertex == v);
        model[v] = to;
      } else {
        CHECK(moved.outcome == MoveOutcome::occupied);
        CHECK(moved.vertex == occupant->first);
      }
      REQUIRE_FALSE(sites.validate().has_value());
    }
    std::vector<typename T::Point> points;
    REQUIRE(sites.size() == model.size());
    for (const auto& [v, p] : model) {
      CHECK(sites.point(v) == p);
      points.push_back(p);
    }
    CHECK(sites.fingerprint() == Sites(points).fingerprint());
  }
}

TEST_CASE_TEMPLATE("a_move_to_no_place_or_of_a_dead_vertex_changes_nothing", Sites, DynamicTriangulation,
                   DynamicTetrahedralization) {
  using T = Twin<Sites>;
  Sites sites(T::uniform(30, 1));
  sites.remove(VertexId{4});
  const Fingerprint before = sites.fingerprint();
  CHECK_THROWS_AS((void)sites.move(VertexId{3}, T::not_a_place()), InputError);
  CHECK_THROWS_WITH_AS((void)sites.move(VertexId{4}, sites.point(VertexId{3})), doctest::Contains("vertex 4"),
                       InputError);
  CHECK_THROWS_AS((void)sites.move(VertexId{30}, sites.point(VertexId{3})), InputError);
  CHECK(sites.fingerprint() == before);
}

// ---- Voronoi cells ----

TEST_CASE_TEMPLATE("a_place_is_in_the_cell_of_its_nearest_vertex_and_bounded_cells_are_within_the_hull",
                   Sites, DynamicTriangulation, DynamicTetrahedralization) {
  using T = Twin<Sites>;
  for (const Sites& sites : states<Sites>()) {
    CAPTURE(sites.size());
    const bool has_edges = sites.extent() == T::full || sites.edge_count() > 0;
    std::vector<VertexId> some(sites.vertices().begin(), sites.vertices().end());
    some = shapes::shuffled(some, 1);
    some.resize(std::min<std::size_t>(some.size(), 40));
    const auto points = places(sites, 12, 7);
    for (const VertexId v : some) {
      const auto cell = sites.voronoi_cell(v);
      CHECK(cell.is_bounded() == (sites.extent() == T::full && !sites.on_hull(v)));
      const std::vector<VertexId> across = T::across(cell);
      if (!has_edges) {
        CHECK(across.empty());
        continue;
      }
      const auto is_nearer = [&](const auto& p, VertexId w) {
        return kernel::exact::compare_distance(p, sites.point(w), sites.point(v)) == Sign::negative;
      };
      for (const auto& p : points) {
        const bool in_cell =
            std::none_of(across.begin(), across.end(), [&](VertexId w) { return is_nearer(p, w); });
        const bool is_nearest = std::none_of(sites.vertices().begin(), sites.vertices().end(),
                                             [&](VertexId w) { return is_nearer(p, w); });
        CHECK(in_cell == is_nearest);
      }
    }
  }
}

TEST_CASE_TEMPLATE("corners_of_cells_are_as_far_from_their_vertex_as_from_those_beyond", Sites,
                   DynamicTriangulation, DynamicTetrahedralization) {
  using T = Twin<Sites>;
  const Sites sites(T::uniform(400, 31));
  std::size_t corners = 0;
  for (const VertexId v : sites.vertices()) {
    const auto cell = sites.voronoi_cell(v);
    for (const auto& [at, error] : cell.corners) {
      ++corners;
      const double radius = norm(at - sites.point(v));
      std::size_t equal = 0;
      for (const VertexId w : T::across(cell)) {
        const double distance = norm(at - sites.point(w));
        CHECK(distance > radius - 2 * error - 1e-9 * radius);
        equal += std::abs(distance - radius) <= 2 * error + 1e-9 * radius ? 1 : 0;
      }
      CHECK(equal >= T::coordinates(at).size() - (std::is_same_v<typename T::Point, Point2> ? 1 : 0));
    }
  }
  CHECK(corners > 2000);
}

// ---- refusals ----

TEST_CASE_TEMPLATE("dead_and_foreign_vertices_are_refused_by_name", Sites, DynamicTriangulation,
                   DynamicTetrahedralization) {
  using T = Twin<Sites>;
  Sites sites(T::uniform(20, 2));
  sites.remove(VertexId{7});
  for (const VertexId v : {VertexId{7}, VertexId{20}, VertexId{std::numeric_limits<IdRaw>::max() - 1}}) {
    CHECK_THROWS_AS((void)T::cells_at(sites, v), InputError);
    CHECK_THROWS_AS((void)sites.neighbours(v), InputError);
    CHECK_THROWS_AS((void)sites.on_hull(v), InputError);
    CHECK_THROWS_AS((void)sites.voronoi_cell(v), InputError);
  }
  const std::vector<double> values(20), too_few(19);
  CHECK_THROWS_AS((void)sites.k_nearest_vertices(T::not_a_place(), 3), InputError);
  CHECK_THROWS_AS((void)sites.natural_neighbours(T::not_a_place()), InputError);
  CHECK_THROWS_AS((void)sites.interpolate_linear(T::not_a_place(), values), InputError);
  CHECK_THROWS_WITH_AS((void)sites.interpolate_natural_neighbour(sites.point(VertexId{0}), too_few),
                       doctest::Contains("19 values"), InputError);
}

}  // namespace
}  // namespace leonhard
