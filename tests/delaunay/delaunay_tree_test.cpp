// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/delaunay_tree.hpp"

#include <doctest/doctest.h>

#include <random>
#include <utility>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::DelaunayTree;
using delaunay::Location;

/// Points to ask about: sites, middles of sites, and others in and about their box.
std::vector<Point2> queries(const std::vector<Point2>& sites) {
  const auto [low, high] = std::minmax_element(sites.begin(), sites.end());
  const double width = high->x - low->x + 1;
  std::vector<Point2> all = sites;
  for (std::size_t i = 1; i < sites.size(); ++i)
    all.push_back({sites[i - 1].x / 2 + sites[i].x / 2, sites[i - 1].y / 2 + sites[i].y / 2});
  for (const Point2 p : shapes::uniform(300, 5))
    all.push_back({low->x + width * (2 * p.x - 0.5), low->y + width * (2 * p.y - 1)});
  std::erase_if(all, [](Point2 p) { return !is_finite(p); });
  return all;
}

/// Whether an answer is true of p, in rational arithmetic.
bool holds(const DelaunayTree& tree, const Location& at, Point2 p) {
  const delaunay::GhostTriangulation& in = tree.triangulation();
  const auto side_of = [&](delaunay::SideId s) {
    return kernel::exact::orient2d(tree.points()[in.origin(s).index()],
                                   tree.points()[in.destination(s).index()], p);
  };
  const delaunay::SideId s = at.side, next = in.next(s), last = in.previous(s);
  const bool real = !in.is_ghost(in.triangle(s));
  switch (at.kind) {
    case Location::Kind::outside:
      return !real && in.number(s) == 0 && side_of(s) == Sign::positive;
    case Location::Kind::in_triangle:
      return real && side_of(s) == Sign::positive && side_of(next) == Sign::positive &&
             side_of(last) == Sign::positive;
    case Location::Kind::on_side:
      return real && side_of(s) == Sign::zero && side_of(next) == Sign::positive &&
             side_of(last) == Sign::positive;
    case Location::Kind::on_vertex:
      return tree.points()[in.origin(s).index()] == p;
  }
  return false;
}

TEST_CASE("the_tree_locates_every_point_exactly") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const DelaunayTree tree(shapes::distinct(family.points));
    REQUIRE(tree.outcome() == delaunay::TriangulateOutcome::done);
    for (const Point2 p : queries(tree.points())) REQUIRE(holds(tree, tree.locate(p), p));
  }
}

TEST_CASE("the_tree_finds_the_nearest_site_and_the_first_of_equally_near_ones") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const DelaunayTree tree(shapes::shuffled(shapes::distinct(family.points), 7));
    for (const Point2 p : queries(tree.points())) {
      Point2 nearest = tree.points()[0];
      for (const Point2 q : tree.points()) {
        const Sign farther = kernel::compare_distance(p, nearest, q);
        if (farther == Sign::positive || (farther == Sign::zero && q < nearest)) nearest = q;
      }
      REQUIRE(tree.points()[tree.nearest(p).index()] == nearest);
    }
  }
}

TEST_CASE("the_history_ends_in_the_triangles_of_today") {
  const DelaunayTree tree(shapes::uniform(300));
  const delaunay::TriangleHistory& history = tree.history();
  std::size_t today = 0;
  for (const auto n : IdRange<delaunay::HistoryNodeId>(history.node_count())) {
    today += history.child_count(n) == 0 ? 1 : 0;
    for (std::size_t i = 0; i < history.child_count(n); ++i) {
      CHECK(n < history.child(n, i));
    }
  }
  CHECK(today == tree.triangulation().triangle_count());
}

TEST_CASE("a_tree_without_triangles_says_why") {
  CHECK(DelaunayTree({{0, 0}, {1, 1}}).outcome() == delaunay::TriangulateOutcome::too_few_points);
  CHECK(DelaunayTree({{0, 0}, {1, 1}, {2, 2}}).outcome() == delaunay::TriangulateOutcome::all_collinear);
}

}  // namespace
}  // namespace leonhard
