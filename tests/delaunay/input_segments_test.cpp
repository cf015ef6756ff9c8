// SPDX-License-Identifier: MIT
// Which input segment each marked edge is a part of: edges lie exactly on their segments and chain from end to end,
// overlaps belong to the first, markers come through as they were.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "leonhard/delaunay/refine.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::InputSegments;
using delaunay::mesh_pslg;
using delaunay::RefinedMesh;
using delaunay::SegmentId;
using delaunay::triangulate;
using delaunay::Triangulation;

/// The graph of shapes::random_graph with markers 0, 7 and 8, and some segments turned round.
Pslg marked_graph(std::uint64_t seed) {
  Pslg pslg = shapes::random_graph(seed);
  std::mt19937_64 random(seed);
  for (Pslg::Segment& s : pslg.segments) {
    s.marker = std::array<Marker, 3>{0, 7, 8}[random() % 3];
    if (random() % 2 == 0) std::swap(s.from, s.to);
  }
  return pslg;
}

bool lies_on(const Pslg& pslg, std::size_t segment, Point2 p) {
  const auto [a, b] =
      std::minmax(pslg.points[pslg.segments[segment].from], pslg.points[pslg.segments[segment].to]);
  return kernel::exact::orient2d(a, b, p) == Sign::zero && !(p < a) && !(b < p);
}

struct NamedEdge {
  MarkedEdge edge;
  MaybeId<SegmentId> segment;
};

std::vector<NamedEdge> named_edges(const TriangleMesh& mesh, const InputSegments& segments) {
  REQUIRE(segments.boundary.size() == mesh.boundary.size());
  REQUIRE(segments.constraints.size() == mesh.constraints.size());
  std::vector<NamedEdge> all;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    all.push_back({mesh.boundary[i], segments.boundary[i]});
  for (std::size_t i = 0; i < mesh.constraints.size(); ++i)
    all.push_back({mesh.constraints[i], segments.constraints[i]});
  return all;
}

/// Every edge on the first segment that covers it, with the first marker that is not 0; all edges that a segment covers
/// lead from one of its ends to the other.
void check_segments(const Pslg& pslg, const TriangleMesh& mesh, const InputSegments& segments) {
  const std::vector<NamedEdge> edges = named_edges(mesh, segments);
  std::vector<std::vector<std::pair<Point2, Point2>>> pieces(pslg.segments.size());
  for (const auto& [edge, segment] : edges) {
    const auto [a, b] = std::minmax(mesh.points[edge.from], mesh.points[edge.to]);
    MaybeId<SegmentId> first;
    Marker marker = 0;
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      if (pslg.points[pslg.segments[s].from] == pslg.points[pslg.segments[s].to]) continue;
      if (!lies_on(pslg, s, a) || !lies_on(pslg, s, b)) continue;
      if (!first) first = SegmentId::from(s);
      if (marker == 0) marker = pslg.segments[s].marker;
      pieces[s].emplace_back(a, b);
    }
    REQUIRE(segment.has_value());
    CHECK(segment == first);
    CHECK(edge.marker == marker);
  }
  for (std::size_t s = 0; s < pieces.size(); ++s) {
    const auto [a, b] = std::minmax(pslg.points[pslg.segments[s].from], pslg.points[pslg.segments[s].to]);
    if (a == b) continue;
    std::sort(pieces[s].begin(), pieces[s].end());
    REQUIRE_FALSE(pieces[s].empty());
    CHECK(pieces[s].front().first == a);
    CHECK(pieces[s].back().second == b);
    for (std::size_t i = 1; i < pieces[s].size(); ++i) CHECK(pieces[s][i].first == pieces[s][i - 1].second);
  }
}

TEST_CASE("edges_of_a_triangulation_lie_exactly_on_the_segments_that_they_name_and_chain_along_these") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = marked_graph(seed);
    const Triangulation result = triangulate(pslg);
    check_segments(pslg, result.mesh, result.segments);
  }
}

TEST_CASE("edges_of_a_refined_mesh_lie_exactly_on_the_segments_that_they_name_and_chain_along_these") {
  std::size_t exact = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = marked_graph(seed);
    const RefinedMesh result = mesh_pslg(pslg, {.min_angle_deg = 20, .max_area = 2, .progress = {}});
    const auto edges = named_edges(result.mesh, result.segments);
    for (const auto& [edge, segment] : edges) CHECK(segment.has_value());
    if (result.report.rounded_splits > 0) continue;
    ++exact;
    check_segments(pslg, result.mesh, result.segments);
    for (const auto& [edge, segment] : edges)
      for (const VertexId v : {edge.from, edge.to})
        if (v.index() >= pslg.points.size()) {
          const Marker marker = result.mesh.vertex_markers[v];
          CHECK(std::any_of(edges.begin(), edges.end(), [&](const NamedEdge& e) {
            return (e.edge.from == v || e.edge.to == v) && e.edge.marker == marker;
          }));
        }
  }
  CHECK(exact > 5);
}

TEST_CASE("a_segment_marked_0_stays_0_and_only_the_hull_without_segments_is_marked_1") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 4, 4), 0);
  pslg.segments[2].marker = 5;
  const RefinedMesh refined = mesh_pslg(pslg, {.max_area = 0.25, .progress = {}});
  CHECK(refined.report.segment_splits > 0);
  for (std::size_t i = 0; i < refined.mesh.boundary.size(); ++i) {
    const MarkedEdge& edge = refined.mesh.boundary[i];
    CHECK(edge.marker == pslg.segments[(*refined.segments.boundary[i]).index()].marker);
    for (const VertexId v : {edge.from, edge.to})
      if (v.index() >= 4) CHECK(refined.mesh.vertex_markers[v] == edge.marker);
  }
  pslg.segments = {{0, 2, 0}};
  const Triangulation hull = triangulate(pslg, {.keep_convex_hull = true, .progress = {}});
  REQUIRE(hull.mesh.constraints.size() == 1);
  CHECK(hull.mesh.constraints[0].marker == 0);
  CHECK(hull.segments.constraints == std::vector<MaybeId<SegmentId>>{SegmentId{0}});
  CHECK(hull.segments.boundary == std::vector<MaybeId<SegmentId>>(4));
  for (const MarkedEdge& edge : hull.mesh.boundary) CHECK(edge.marker == 1);
  const Triangulation points = triangulate(pslg.points);
  CHECK(points.segments.boundary == std::vector<MaybeId<SegmentId>>(points.mesh.boundary.size()));
}

TEST_CASE("where_segments_overlap_the_first_keeps_the_edge") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 4, 4), 0);
  pslg.points.push_back({1, 0});
  pslg.points.push_back({3, 0});
  pslg.segments.push_back({5, 4, 3});  // a part of segment 0, turned round
  const Triangulation result = triangulate(pslg);
  CHECK(result.repairs ==
        std::vector<std::string>{"segment 4 overlaps segment 0: merged where they do (counted from 0)"});
  std::size_t shared = 0;
  for (std::size_t i = 0; i < result.mesh.boundary.size(); ++i) {
    const MarkedEdge& edge = result.mesh.boundary[i];
    const bool is_shared = edge.from == VertexId{4} && edge.to == VertexId{5};
    shared += is_shared ? 1 : 0;
    CHECK(edge.marker == (is_shared ? 3 : 0));
    CHECK((*result.segments.boundary[i]).index() < 4);
  }
  CHECK(shared == 1);
}

}  // namespace
}  // namespace leonhard
