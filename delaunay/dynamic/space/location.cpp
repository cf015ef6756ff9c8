// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// The next of a sequence of well mixed numbers (SplitMix64: Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// A rounded squared distance: good enough to choose where a walk starts.
double rough_distance(const Point3& a, const Point3& b) { return dot(a - b, a - b); }

/// Whether the permutation that brings the corners in rising order is odd.
bool sort_corners(TetCorners& c) {
  bool odd = false;
  for (std::size_t end = 3; end > 0; --end)
    for (std::size_t i = 0; i < end; ++i) {
      if (c[i] <= c[i + 1]) continue;
      std::swap(c[i], c[i + 1]);
      odd = !odd;
    }
  return odd;
}

}  // namespace

DynamicTetrahedralization::Search DynamicTetrahedralization::search_for(const Point3& p,
                                                                        MaybeId<VertexId> hint) const {
  if (!is_finite(p)) throw InputError("point " + mesh::words(p), "is not finite", "give finite coordinates");
  return Search(hint && contains(*hint) ? hint : MaybeId<VertexId>{});
}

/// Of 2 n^(1/4) vertices drawn at random and `best`, the nearest to p.
VertexId DynamicTetrahedralization::sampled_vertex(const Point3& p, VertexId best) const {
  const std::size_t bound = id_bound();
  const auto samples = static_cast<std::size_t>(2 * std::sqrt(std::sqrt(static_cast<double>(bound))));
  double nearest = rough_distance(points_[best], p);
  std::uint64_t state = std::bit_cast<std::uint64_t>(p.x) ^ std::rotl(std::bit_cast<std::uint64_t>(p.y), 21) ^
                        std::rotl(std::bit_cast<std::uint64_t>(p.z), 42);
  for (std::size_t i = 0; i < samples; ++i) {
    const VertexId v = VertexId::from(((next_random(state) >> 32) * bound) >> 32);
    const double distance = rough_distance(points_[v], p);
    if (!(distance < nearest)) continue;  // NaN where v is removed
    nearest = distance;
    best = v;
  }
  return best;
}

/// The answer of walk; the search goes on from there. After a number of steps in vain the rest starts from a sample.
TetId DynamicTetrahedralization::find(const Point3& p, Search& search) const {
  const std::size_t patience = search.near ? 48 : 16;
  TetId t = tets_[search.near ? *search.near : last_];
  if (!walk_some(cells_, points_.flat(), t, p, patience)) {
    const VertexId here = cells_.corners[t][1], sampled = sampled_vertex(p, here);
    t = walk(cells_, points_.flat(), sampled == here ? t : tets_[sampled], p);
  }
  search.near = cells_.corners[t][1];
  return t;
}

/// What was found, in a form that does not depend on the way there.
TetLocation DynamicTetrahedralization::answer(const Point3& p, TetId found) const {
  using Kind = TetLocation::Kind;
  if (cells_.is_ghost(found)) return {};
  TetCorners carrier;  // p is strictly inside the simplex of these
  carrier.fill(ghost);
  std::size_t count = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (side_of_face(cells_, points_.flat(), found, i, p) != Sign::zero)
      carrier[count++] = cells_.corners[found][i];
  const bool odd = sort_corners(carrier);  // the ghost has the highest number
  if (count == 4 && odd) std::swap(carrier[2], carrier[3]);
  TetLocation at;
  constexpr std::array kinds{Kind::outside, Kind::on_vertex, Kind::on_edge, Kind::on_face,
                             Kind::in_tetrahedron};
  at.kind = kinds[count];
  std::copy_n(carrier.begin(), count, at.vertices.begin());
  return at;
}

TetLocation DynamicTetrahedralization::locate_in_span(const Point3& p) const {
  if (const MaybeId<VertexId> v = flat_.find(p)) return {TetLocation::Kind::on_vertex, {v}};
  return {flat_.spans(p) ? TetLocation::Kind::in_span : TetLocation::Kind::outside, {}};
}

TetLocation DynamicTetrahedralization::locate_from(const Point3& p, Search& search) const {
  return has_tets() ? answer(p, find(p, search)) : locate_in_span(p);
}

/// Whether a comes before b in the order of distances from p, ties broken by coordinates.
bool DynamicTetrahedralization::is_nearer(const Point3& p, VertexId a, VertexId b) const {
  const Sign sign = kernel::compare_distance(p, points_[a], points_[b]);
  return sign == Sign::negative || (sign == Sign::zero && points_[a] < points_[b]);
}

/// A vertex with no neighbour nearer to p has p in its Voronoi cell, so going to the nearest neighbour until there is none
/// leads to the nearest vertex. Several equally near ones are corners of a convex polytope in an empty sphere, whose edges
/// are there: some lead on to the lexicographically first, as in the simplex method.
MaybeId<VertexId> DynamicTetrahedralization::nearest_from(const Point3& p, Search& search) const {
  if (!has_tets()) return flat_.nearest(p);
  const TetId found = find(p, search);
  VertexId best = cells_.corners[found][1];
  for (const VertexId v : cells_.corners[found])
    if (v != ghost && is_nearer(p, v, best)) best = v;
  if (points_[best] == p) return best;
  while (true) {
    const VertexId here = best;
    search.star.collect(cells_, tets_[here], here);
    for (const VertexId v : search.star.neighbours())
      if (v != ghost && is_nearer(p, v, best)) best = v;
    if (best == here) return best;
  }
}

}  // namespace leonhard::delaunay
