// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// Take up to `steps` steps towards p from a real triangle.
///
/// from     where it began, and where it arrived
/// returns  whether `from` is the answer of walk
bool walk_some(const GhostTriangulation& in, std::span<const Point2> points, AnyTriangleId& from, Point2 p,
               Coin& coin, int steps) {
  const auto beyond = [&](SideId s) {
    return kernel::orient2d(points[in.origin(s).index()], points[in.destination(s).index()], p) ==
           Sign::negative;
  };
  for (; steps > 0; --steps) {
    if (in.is_ghost(from)) return true;
    const unsigned first = coin.flip();
    unsigned i = 0;
    while (i < 3 && !beyond(in.side(from, (first + i) % 3))) ++i;
    if (i == 3) return true;
    from = in.triangle(in.twin(in.side(from, (first + i) % 3)));
  }
  return in.is_ghost(from);
}

/// The next of a sequence of well mixed numbers (SplitMix64: Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// A rounded squared distance: good enough to choose where a walk starts.
double rough_distance(Point2 a, Point2 b) { return dot(a - b, a - b); }

}  // namespace

DynamicTriangulation::Search DynamicTriangulation::search_for(Point2 p, MaybeId<VertexId> hint) const {
  if (!is_finite(p)) throw InputError("point " + mesh::words(p), "is not finite", "give finite coordinates");
  return Search(hint && contains(*hint) ? hint : MaybeId<VertexId>{});
}

/// A real triangle at a vertex.
AnyTriangleId DynamicTriangulation::triangle_at(VertexId v) const {
  const AnyTriangleId t = triangles_.triangle(sides_[v]);
  return triangles_.is_ghost(t) ? triangles_.triangle(triangles_.twin(triangles_.side(t, 0))) : t;
}

/// The answer of walk. After a number of steps in vain the rest starts from a sample.
AnyTriangleId DynamicTriangulation::triangle_towards(Point2 p, Search& search) const {
  const int patience = search.near ? 48 : 16;
  AnyTriangleId t = triangle_at(search.near ? *search.near : last_);
  if (walk_some(triangles_, points_.flat(), t, p, search.coin, patience)) return t;
  const VertexId here = triangles_.corner(t, 1), sampled = sampled_vertex(p, here);
  return walk(triangles_, points_.flat(), sampled == here ? t : triangle_at(sampled), p, search.coin);
}

/// Of 2 n^(1/3) vertices drawn at random and `best`, the nearest to p. More would cost more than they save
/// from the walk, whose steps wait for memory one after another.
VertexId DynamicTriangulation::sampled_vertex(Point2 p, VertexId best) const {
  const std::size_t bound = id_bound();
  const auto samples = static_cast<std::size_t>(2 * std::cbrt(static_cast<double>(bound)));
  double nearest = rough_distance(points_[best], p);
  std::uint64_t state = std::bit_cast<std::uint64_t>(p.x) ^ std::rotl(std::bit_cast<std::uint64_t>(p.y), 32);
  for (std::size_t i = 0; i < samples; ++i) {
    const VertexId v = VertexId::from(((next_random(state) >> 32) * bound) >> 32);
    const double distance = rough_distance(points_[v], p);
    if (!(distance < nearest)) continue;  // NaN where v is removed
    nearest = distance;
    best = v;
  }
  return best;
}

/// Where p lies among triangles; the search goes on from there.
Location DynamicTriangulation::find(Point2 p, Search& search) const {
  const Location found = location_in(triangles_, points_.flat(), triangle_towards(p, search), p);
  search.near = triangles_.origin(found.side);
  return found;
}

/// What was found, in a form that does not depend on the way there.
PointLocation DynamicTriangulation::answer(Location found) const {
  const VertexId a = triangles_.origin(found.side), b = triangles_.destination(found.side);
  switch (found.kind) {
    case Location::Kind::outside:
      return {};
    case Location::Kind::on_vertex:
      return {PointLocation::Kind::on_vertex, {a}};
    case Location::Kind::on_side:
      return {PointLocation::Kind::on_edge, {std::min(a, b), std::max(a, b)}};
    case Location::Kind::in_triangle:
      break;
  }
  std::array<VertexId, 3> corners{a, b, triangles_.apex(found.side)};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return {PointLocation::Kind::in_triangle, {corners[0], corners[1], corners[2]}};
}

PointLocation DynamicTriangulation::locate_on_line(Point2 p) const {
  if (const MaybeId<VertexId> v = line_.find(p)) return {PointLocation::Kind::on_vertex, {v}};
  const auto [before, after] = line_.around(p);
  if (!before || !after || !line_.collinear_with(p)) return {};
  return {PointLocation::Kind::on_edge, {std::min(*before, *after), std::max(*before, *after)}};
}

PointLocation DynamicTriangulation::locate_from(Point2 p, Search& search) const {
  return extent() == Extent::plane ? answer(find(p, search)) : locate_on_line(p);
}

/// Whether a comes before b in the order of distances from p, ties broken by coordinates.
bool DynamicTriangulation::is_nearer(Point2 p, VertexId a, VertexId b) const {
  const Sign sign = kernel::compare_distance(p, points_[a], points_[b]);
  return sign == Sign::negative || (sign == Sign::zero && points_[a] < points_[b]);
}

/// A vertex with no neighbour nearer to p has p in its Voronoi cell, so going to the nearest neighbour until
/// there is none leads to the nearest vertex. Several equally near ones are corners of a convex polygon in an
/// empty circle, whose sides are edges: they lead on to the lexicographically first.
MaybeId<VertexId> DynamicTriangulation::nearest_from(Point2 p, Search& search) const {
  if (extent() != Extent::plane) return line_.nearest(p);
  const Location found = find(p, search);
  VertexId best = triangles_.origin(found.side);
  if (found.kind == Location::Kind::on_vertex) return best;
  for (const VertexId v : {triangles_.destination(found.side), triangles_.apex(found.side)})
    if (v != GhostTriangulation::ghost && is_nearer(p, v, best)) best = v;
  while (true) {
    const VertexId here = best;
    for (const VertexId v : NeighbourView(triangles_, sides_[here]))
      if (is_nearer(p, v, best)) best = v;
    if (best == here) return best;
  }
}

void DynamicTriangulation::collect_neighbours(VertexId v, Search&, std::vector<VertexId>& into) const {
  const NeighbourView all = neighbours(v);
  into.assign(all.begin(), all.end());
}

}  // namespace leonhard::delaunay
