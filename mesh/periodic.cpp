// SPDX-License-Identifier: MIT
#include "leonhard/mesh/periodic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

constexpr double tolerance_share = 1e-7;  ///< of the mesh's extent
constexpr std::size_t most_listed = 5;

std::array<double, 2> numbers(Point2 p) { return {p.x, p.y}; }
std::array<double, 3> numbers(const Point3& p) { return {p.x, p.y, p.z}; }

template <int Dim>
std::string name_of(const MeshDual<Dim>& dual, Marker marker) {
  const auto found = dual.marker_names.find(marker);
  return found == dual.marker_names.end() ? "marker " + std::to_string(marker) : "\"" + found->second + "\"";
}

std::string translation_words(Vec2 v) { return mesh::words(Point2{v.x, v.y}); }
std::string translation_words(const Vec3& v) { return mesh::words(Point3{v.x, v.y, v.z}); }

/// The vertices on the facets of a marker, ascending.
template <int Dim>
std::vector<VertexId> vertices_of(const MeshDual<Dim>& dual, Marker marker) {
  std::set<VertexId> vertices;
  for (const DualFacet<Dim>& facet : dual.boundary)
    if (facet.marker == marker) vertices.insert(facet.corners.begin(), facet.corners.end());
  return {vertices.begin(), vertices.end()};
}

template <int Dim>
double extent_of(const MeshDual<Dim>& dual) {
  auto low = numbers(dual.points[VertexId{}]), high = low;
  for (const auto& point : dual.points) {
    const auto p = numbers(point);
    for (std::size_t i = 0; i < Dim; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  }
  double extent = 0;
  for (std::size_t i = 0; i < Dim; ++i) extent = std::max(extent, high[i] - low[i]);
  return extent;
}

/// Points in boxes of a tolerance's size, so that the one nearest to a place is found among the boxes about it.
template <int Dim>
class NearPoints {
 public:
  using Point = typename Simplex<Dim>::Point;

  NearPoints(const PerId<VertexId, Point>& points, const std::vector<VertexId>& vertices, double tolerance)
      : points_(points), tolerance_(tolerance) {
    for (const VertexId v : vertices) boxes_[box_of(points[v])].push_back(v);
  }

  /// The nearest one within the tolerance.
  [[nodiscard]] MaybeId<VertexId> nearest(const Point& place) const {
    MaybeId<VertexId> found;
    double least = tolerance_;
    const Box centre = box_of(place);
    std::size_t count = 1;
    for (int i = 0; i < Dim; ++i) count *= 3;
    for (std::size_t k = 0; k < count; ++k) {
      Box box = centre;
      std::size_t rest = k;
      for (auto& along : box) along += static_cast<std::int64_t>(rest % 3) - 1, rest /= 3;
      const auto here = boxes_.find(box);
      if (here == boxes_.end()) continue;
      for (const VertexId v : here->second)
        if (const double d = norm(points_[v] - place); d < least || (!found && d <= least)) least = d, found = v;
    }
    return found;
  }

 private:
  using Box = std::array<std::int64_t, Dim>;
  [[nodiscard]] Box box_of(const Point& p) const {
    Box box;
    const auto x = numbers(p);
    for (std::size_t i = 0; i < Dim; ++i) box[i] = static_cast<std::int64_t>(std::floor(x[i] / tolerance_));
    return box;
  }

  const PerId<VertexId, Point>& points_;
  double tolerance_;
  std::map<Box, std::vector<VertexId>> boxes_;
};

/// The translation between the means of two sides, and that between their lowest coordinates, which a vertex too many moves
/// less often.
template <int Dim>
std::array<typename Simplex<Dim>::Vector, 2> guesses(const MeshDual<Dim>& dual, const std::vector<VertexId>& from,
                                                     const std::vector<VertexId>& to) {
  const auto origin = dual.points[from.front()];
  const auto mean = [&](const std::vector<VertexId>& side) {
    typename Simplex<Dim>::Vector sum{};
    for (const VertexId v : side) sum += dual.points[v] - origin;
    return (1.0 / static_cast<double>(side.size())) * sum;
  };
  const auto lowest = [&](const std::vector<VertexId>& side) {
    auto low = dual.points[side.front()] - origin;
    for (const VertexId v : side) {
      const auto d = dual.points[v] - origin;
      low.x = std::min(low.x, d.x), low.y = std::min(low.y, d.y);
      if constexpr (Dim == 3) low.z = std::min(low.z, d.z);
    }
    return low;
  };
  return {mean(to) - mean(from), lowest(to) - lowest(from)};
}

/// The pairs of two sides under one translation, and who is left over.
template <int Dim>
struct Pairing {
  typename Simplex<Dim>::Vector translation;
  std::vector<std::array<VertexId, 2>> pairs;
  std::vector<VertexId> alone_from, alone_to;
  double mismatch = 0;
  [[nodiscard]] std::size_t alone() const { return alone_from.size() + alone_to.size(); }
};

template <int Dim>
Pairing<Dim> pair_up(const MeshDual<Dim>& dual, const std::vector<VertexId>& from, const std::vector<VertexId>& to,
                     const NearPoints<Dim>& near, typename Simplex<Dim>::Vector translation) {
  Pairing<Dim> result{translation, {}, {}, {}};
  std::set<VertexId> taken;
  for (const VertexId v : from) {
    const auto place = dual.points[v] + translation;
    const MaybeId<VertexId> image = near.nearest(place);
    if (!image || !taken.insert(*image).second) {
      result.alone_from.push_back(v);
      continue;
    }
    result.pairs.push_back({v, *image});
    result.mismatch = std::max(result.mismatch, norm(dual.points[*image] - place));
  }
  for (const VertexId v : to)
    if (!taken.contains(v)) result.alone_to.push_back(v);
  return result;
}

template <int Dim>
std::string listed(const MeshDual<Dim>& dual, const std::vector<VertexId>& vertices, Marker marker) {
  std::string words = std::to_string(vertices.size()) + " of " + name_of(dual, marker) + " have no partner";
  for (std::size_t i = 0; i < std::min(most_listed, vertices.size()); ++i)
    words += (i == 0 ? ": " : ", ") + std::to_string(vertices[i].raw) + " at " + mesh::words(dual.points[vertices[i]]);
  return words + (vertices.size() > most_listed ? ", ..." : "");
}

template <int Dim>
std::vector<VertexId> sorted_corners(const DualFacet<Dim>& facet) {
  std::vector<VertexId> corners(facet.corners.begin(), facet.corners.end());
  std::ranges::sort(corners);
  return corners;
}

/// Each facet of one side must be one of the other, facing the other way, once its vertices are exchanged for their images.
template <int Dim>
void check_facets(const MeshDual<Dim>& dual, const PeriodicMatch<Dim>& match, const std::string& between) {
  std::map<VertexId, VertexId> image;
  for (const auto& [a, b] : match.pairs) image[a] = b;
  std::map<std::vector<VertexId>, const DualFacet<Dim>*> there;
  for (const DualFacet<Dim>& facet : dual.boundary)
    if (facet.marker == match.to) there[sorted_corners(facet)] = &facet;
  std::size_t count = 0;
  for (const DualFacet<Dim>& facet : dual.boundary) {
    if (facet.marker != match.from) continue;
    ++count;
    std::vector<VertexId> corners;
    for (const VertexId v : facet.corners) corners.push_back(image.at(v));
    std::ranges::sort(corners);
    const auto found = there.find(corners);
    if (found == there.end())
      throw InputError(between,
                       std::string(Dim == 2 ? "the edge" : "the face") + " of " + name_of(dual, match.from) + " about " +
                           mesh::words(facet.centre) + " (first vertex " + std::to_string(facet.corners[0].raw) +
                           ") has no image on the other side, though its vertices have",
                       "mesh both sides alike");
    if (!(dot(found->second->normal, facet.normal) < 0))
      throw InputError(between,
                       "face the same way at " + mesh::words(facet.centre) + ", so the mesh does not lie between them",
                       "name the two opposite sides");
  }
  if (count != there.size())
    throw InputError(between, "have " + std::to_string(count) + " and " + std::to_string(there.size()) + " facets",
                     "mesh both sides alike");
}

}  // namespace

template <int Dim>
PeriodicMatch<Dim> match_sides(const MeshDual<Dim>& dual, const PeriodicSides<Dim>& sides) {
  const std::string between = "periodic sides " + name_of(dual, sides.from) + " and " + name_of(dual, sides.to);
  if (sides.from == sides.to) throw InputError(between, "are the same", "name two sides");
  const std::vector<VertexId> from = vertices_of(dual, sides.from), to = vertices_of(dual, sides.to);
  if (from.empty() || to.empty())
    throw InputError(between, "are not both on the boundary of the mesh", "correct the markers");
  std::vector<VertexId> both;
  std::ranges::set_intersection(from, to, std::back_inserter(both));
  if (!both.empty())
    throw InputError(between,
                     "share " + std::to_string(both.size()) + " vertices, the first one " + std::to_string(both.front().raw) + " at " +
                         mesh::words(dual.points[both.front()]),
                     "name two opposite sides that do not touch");
  const double tolerance = tolerance_share * extent_of(dual);
  const NearPoints<Dim> near(dual.points, to, tolerance);
  Pairing<Dim> best;
  if (sides.translation) {
    best = pair_up(dual, from, to, near, *sides.translation);
  } else {
    const auto [by_means, by_corners] = guesses(dual, from, to);
    best = pair_up(dual, from, to, near, by_means);
    if (best.alone() > 0)
      if (Pairing<Dim> other = pair_up(dual, from, to, near, by_corners); other.alone() < best.alone()) best = std::move(other);
  }
  if (best.alone() > 0) {
    std::string told;
    if (!best.alone_from.empty()) told = listed(dual, best.alone_from, sides.from);
    if (!best.alone_to.empty()) told += (told.empty() ? "" : "; ") + listed(dual, best.alone_to, sides.to);
    throw InputError(between,
                     "do not match under the translation " + translation_words(best.translation) + " within " + mesh::words(tolerance) +
                         ": vertices " + told,
                     sides.translation ? "correct the translation, or mesh both sides alike"
                                       : "mesh both sides alike, or give the translation");
  }
  PeriodicMatch<Dim> match{sides.from, sides.to, best.translation, std::move(best.pairs), best.mismatch};
  check_facets(dual, match, between);
  return match;
}

namespace {

/// An edge of the mesh between joined vertices, the smaller one first.
template <int Dim>
struct JoinedEdge {
  std::array<VertexId, 2> ends;
  typename Simplex<Dim>::Vector span, face;
};

template <int Dim>
std::vector<JoinedEdge<Dim>> joined_edges(const MeshDual<Dim>& dual, const PerId<VertexId, VertexId>& joined_of) {
  std::vector<JoinedEdge<Dim>> edges;
  edges.reserve(dual.edge_count());
  for (const EdgeId e : dual.edges.ends.ids()) {
    const auto [a, b] = dual.edges.ends[e];
    JoinedEdge<Dim> edge{{joined_of[a], joined_of[b]}, dual.edge_vector(e), dual.face[e]};
    if (edge.ends[1] < edge.ends[0]) {
      std::swap(edge.ends[0], edge.ends[1]);
      edge.span = -edge.span, edge.face = -edge.face;
    }
    edges.push_back(edge);
  }
  std::ranges::stable_sort(edges, {}, &JoinedEdge<Dim>::ends);
  return edges;
}

/// Add an edge to the last ones of the dual: to the face of one that leads the same way between the same vertices, or as a new
/// one. Two ways differ by a translation or by rounding, nothing in between.
template <int Dim>
void add_edge(MeshDual<Dim>& dual, const JoinedEdge<Dim>& edge, double apart) {
  for (std::size_t k = dual.edge_count(); k-- > 0;) {
    const EdgeId e = EdgeId::from(k);
    if (dual.edges.ends[e] != edge.ends) break;
    if (norm(dual.span[e] - edge.span) < apart) return void(dual.face[e] += edge.face);
    if (edge.ends[0] == edge.ends[1] && norm(dual.span[e] + edge.span) < apart) return void(dual.face[e] += -edge.face);
  }
  dual.edges.ends.push_back(edge.ends);
  dual.span.push_back(edge.span);
  dual.face.push_back(edge.face);
}

}  // namespace

template <int Dim>
JoinedDual<Dim> join_sides(const MeshDual<Dim>& dual, std::span<const PeriodicMatch<Dim>> matches) {
  DisjointSets classes(dual.vertex_count());
  std::set<Marker> joined_markers;
  double shortest = std::numeric_limits<double>::infinity();
  for (const PeriodicMatch<Dim>& match : matches) {
    for (const auto& [a, b] : match.pairs) classes.join(a.index(), b.index());
    joined_markers.insert({match.from, match.to});
    shortest = std::min(shortest, norm(match.translation));
  }
  JoinedDual<Dim> joined;
  MeshDual<Dim>& result = joined.dual;
  PerId<VertexId, MaybeId<VertexId>> of_class(dual.vertex_count());
  for (const VertexId v : dual.points.ids()) {
    MaybeId<VertexId>& standing = of_class[VertexId::from(classes.find(v.index()))];
    if (!standing) {
      standing = VertexId::from(result.points.size());
      result.points.push_back(dual.points[v]);
      result.volume.push_back(0);
      joined.first_of.push_back(v);
    }
    joined.joined_of.push_back(*standing);
    result.volume[*standing] += dual.volume[v];
  }
  for (const JoinedEdge<Dim>& edge : joined_edges(dual, joined.joined_of)) add_edge(result, edge, shortest / 4);
  result.edges.first_edge.assign(result.points.size() + 1, 0);
  for (const auto& ends : result.edges.ends) ++result.edges.first_edge[ends[0].index() + 1];
  for (std::size_t v = 1; v < result.edges.first_edge.size(); ++v) result.edges.first_edge[v] += result.edges.first_edge[v - 1];
  for (DualFacet<Dim> facet : dual.boundary) {
    if (joined_markers.contains(facet.marker)) continue;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) facet.corners[i] = joined.joined_of[facet.corners[i]];
    result.boundary.push_back(facet);
  }
  result.marker_names = dual.marker_names;
  return joined;
}

template PeriodicMatch<2> match_sides(const MeshDual<2>&, const PeriodicSides<2>&);
template PeriodicMatch<3> match_sides(const MeshDual<3>&, const PeriodicSides<3>&);
template JoinedDual<2> join_sides(const MeshDual<2>&, std::span<const PeriodicMatch<2>>);
template JoinedDual<3> join_sides(const MeshDual<3>&, std::span<const PeriodicMatch<3>>);

}  // namespace leonhard::mesh
