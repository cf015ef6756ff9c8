// SPDX-License-Identifier: MIT
#include "leonhard/mesh/data_structures.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/topology.hpp"

namespace leonhard::mesh {
namespace {

constexpr const char* number_them = "number triangles without gaps and give each of them three edges";

// ---- from edges ----

/// The sides of one triangle, which lies to their left.
struct TriangleSides {
  std::array<std::pair<VertexId, VertexId>, 3> sides;
  std::size_t count = 0;  ///< may exceed three in a bad structure

  void add(VertexId from, VertexId to) {
    if (count < 3) sides[count] = {from, to};
    ++count;
  }
  /// The three corners, the smallest first; none if the sides do not close.
  [[nodiscard]] std::optional<std::array<VertexId, 3>> corners() {
    if (count != 3) return std::nullopt;
    std::sort(sides.begin(), sides.end());
    const VertexId a = sides[0].first, b = sides[0].second;
    if (sides[1].first != b) std::swap(sides[1], sides[2]);
    const VertexId c = sides[1].second;
    if (a == c || sides[1].first != b || sides[2] != std::pair(c, a)) return std::nullopt;
    return std::array{a, b, c};
  }
};

PerId<TriangleId, TriangleSides> sides_by_triangle(const EdgeStructure& edges) {
  PerId<TriangleId, TriangleSides> triangles;
  const auto add = [&](MaybeId<TriangleId> t, VertexId from, VertexId to) {
    if (!t) return;
    if ((*t).index() >= 2 * edges.edge_count())
      throw InputError("edges", "triangle " + std::to_string((*t).raw) + " is one of too many", number_them);
    if (!triangles.contains(*t)) triangles.resize((*t).index() + 1);
    triangles[*t].add(from, to);
  };
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    add(edges.sides[e][0], a, b);
    add(edges.sides[e][1], b, a);
  }
  return triangles;
}

PerId<TriangleId, std::array<VertexId, 3>> corners_of(const EdgeStructure& edges) {
  PerId<TriangleId, TriangleSides> triangles = sides_by_triangle(edges);
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  corners.reserve(triangles.size());
  for (const TriangleId t : triangles.ids()) {
    const auto abc = triangles[t].corners();
    if (!abc) {
      throw InputError("edges",
                       "the sides of triangle " + std::to_string(t.raw) + " are not three that close",
                       number_them);
    }
    corners.push_back(*abc);
  }
  return corners;
}

/// Rings of edges about vertices, as QuadEdge wants them spliced.
class Rings {
 public:
  explicit Rings(QuadEdge& quads)
      : quads_(quads), next_(2 * quads.edge_count()), previous_(2 * quads.edge_count()) {}

  /// `after` comes next, counter-clockwise about the same origin.
  void follow(EdgeRef before, EdgeRef after) {
    next_[slot(before)] = after;
    previous_[slot(after)] = before;
  }
  /// Splice all edges into their rings; one that ends on both sides is closed over the outside.
  void splice() {
    std::vector<bool> spliced(next_.size(), false);
    quads_.for_each_directed_edge([&](EdgeRef e) {
      if (!previous_[slot(e)]) splice_from(e, spliced);
    });
    quads_.for_each_directed_edge([&](EdgeRef e) {
      if (!spliced[slot(e)]) splice_from(e, spliced);
    });
  }

 private:
  static std::size_t slot(EdgeRef e) { return e.index() >> 1; }
  void splice_from(EdgeRef first, std::vector<bool>& spliced) {
    spliced[slot(first)] = true;
    EdgeRef last = first;
    while (next_[slot(last)] && *next_[slot(last)] != first) {
      const EdgeRef e = *next_[slot(last)];
      quads_.splice(last, e);
      spliced[slot(e)] = true;
      last = e;
    }
  }
  QuadEdge& quads_;
  std::vector<MaybeId<EdgeRef>> next_, previous_;
};

// ---- from the quad-edge structure ----

struct Joined {
  VertexId low, high;
  EdgeRef edge;  ///< from low to high
};

Joined joined(const QuadEdge& quads, EdgeRef e, std::size_t vertices) {
  const MaybeId<VertexId> from = quads.origin(e), to = quads.destination(e);
  const std::string name = QuadEdge::name(e);
  if (!from || !to) throw InputError("quads", name + " has an end without vertex", "set its vertex");
  for (const VertexId v : {*from, *to}) {
    if (v.index() < vertices) continue;
    throw InputError("quads",
                     name + " ends in vertex " + std::to_string(v.raw) + " of " + std::to_string(vertices),
                     "give the number of all vertices");
  }
  if (*from == *to) {
    throw InputError("quads", name + " joins vertex " + std::to_string((*from).raw) + " to itself",
                     "an edge structure cannot hold it");
  }
  return *from < *to ? Joined{*from, *to, e} : Joined{*to, *from, QuadEdge::sym(e)};
}

MaybeId<TriangleId> triangle_left_of(const QuadEdge& quads, EdgeRef e) {
  const MaybeId<FaceId> face = quads.left(e);
  return face ? MaybeId<TriangleId>(TriangleId{(*face).raw}) : MaybeId<TriangleId>();
}

// ---- from a graph in the plane ----

/// Directions about a vertex, counter-clockwise from straight down, which itself comes last.
class AngularOrder {
 public:
  AngularOrder(const QuadEdge& quads, const PerId<VertexId, Point2>& points)
      : quads_(quads), points_(points) {}
  bool operator()(EdgeRef e, EdgeRef f) const {
    const Point2 p = points_[*quads_.origin(e)], q = points_[*quads_.destination(e)],
                 r = points_[*quads_.destination(f)];
    const bool q_rises = p < q, r_rises = p < r;
    if (q_rises != r_rises) return q_rises;
    return kernel::orient2d(p, q, r) == Sign::positive;
  }

 private:
  const QuadEdge& quads_;
  const PerId<VertexId, Point2>& points_;
};

void splice_in_order(QuadEdge& quads, const PerId<VertexId, Point2>& points, std::size_t vertices) {
  std::vector<std::vector<EdgeRef>> star(vertices);
  quads.for_each_directed_edge([&](EdgeRef e) { star[(*quads.origin(e)).index()].push_back(e); });
  for (std::vector<EdgeRef>& edges : star) {
    std::sort(edges.begin(), edges.end(), AngularOrder(quads, points));
    for (std::size_t i = 1; i < edges.size(); ++i) quads.splice(edges[i - 1], edges[i]);
  }
}

using VertexTriple = std::array<VertexId, 3>;

VertexTriple sorted(VertexTriple triple) {
  std::sort(triple.begin(), triple.end());
  return triple;
}

/// Face ids for all bounded faces of three edges that are no holes.
void number_triangles(QuadEdge& quads, const PerId<VertexId, Point2>& points,
                      std::span<const VertexTriple> holes) {
  std::vector<VertexTriple> empty;
  for (const VertexTriple& hole : holes) empty.push_back(sorted(hole));
  std::sort(empty.begin(), empty.end());
  IdRaw faces = 0;
  quads.for_each_directed_edge([&](EdgeRef e) {
    if (quads.left(e) || quads.lnext(quads.lnext(quads.lnext(e))) != e) return;
    const VertexTriple corners{*quads.origin(e), *quads.destination(e), *quads.destination(quads.lnext(e))};
    if (kernel::orient2d(points[corners[0]], points[corners[1]], points[corners[2]]) != Sign::positive)
      return;
    if (std::binary_search(empty.begin(), empty.end(), sorted(corners))) return;
    quads.set_face(e, FaceId{faces++});
  });
}

}  // namespace

TriangleMesh triangle_mesh(const EdgeStructure& edges, const PerId<VertexId, Point2>& points, Marker marker) {
  std::vector<MarkedEdge> boundary;
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    if (edges.is_boundary(e))
      boundary.push_back(edges.sides[e][0] ? MarkedEdge{a, b, marker} : MarkedEdge{b, a, marker});
  }
  return make_triangle_mesh(points, corners_of(edges), std::move(boundary));
}

QuadEdge quad_edge(const EdgeStructure& edges) {
  QuadEdge quads;
  quads.reserve(edges.edge_count());
  for (const auto& [a, b] : edges.ends) quads.make_edge(a, b);
  const auto directed = [&](VertexId from, VertexId to) {
    const EdgeRef e{4 * (*edges.find(from, to)).raw};
    return from < to ? e : QuadEdge::sym(e);
  };
  Rings rings(quads);
  const auto corners = corners_of(edges);
  for (const TriangleId t : corners.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeRef e = directed(corners[t][i], corners[t][(i + 1) % 3]);
      rings.follow(e, directed(corners[t][i], corners[t][(i + 2) % 3]));
      quads.set_left(e, FaceId{t.raw});
    }
  }
  rings.splice();
  return quads;
}

EdgeStructure edge_structure(const QuadEdge& quads, std::size_t vertices) {
  std::vector<Joined> all;
  all.reserve(quads.edge_count());
  quads.for_each_edge([&](EdgeRef e) { all.push_back(joined(quads, e, vertices)); });
  const auto ends = [](const Joined& j) { return std::pair(j.low, j.high); };
  std::sort(all.begin(), all.end(), [&](const Joined& j, const Joined& k) { return ends(j) < ends(k); });
  EdgeStructure edges;
  edges.first_edge.assign(vertices + 1, 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && ends(all[i]) == ends(all[i - 1])) {
      throw InputError(
          "quads",
          QuadEdge::name(all[i - 1].edge) + " and " + QuadEdge::name(all[i].edge) + " join the same vertices",
          "an edge structure cannot hold both");
    }
    edges.ends.push_back({all[i].low, all[i].high});
    edges.sides.push_back(
        {triangle_left_of(quads, all[i].edge), triangle_left_of(quads, QuadEdge::sym(all[i].edge))});
    ++edges.first_edge[all[i].low.index() + 1];
  }
  for (std::size_t v = 1; v < edges.first_edge.size(); ++v) edges.first_edge[v] += edges.first_edge[v - 1];
  return edges;
}

QuadEdge quad_edge(const OutDegreeList& list, const PerId<VertexId, Point2>& points,
                   std::span<const std::array<VertexId, 3>> holes) {
  if (points.size() < list.vertex_count()) {
    throw InputError("points",
                     "there are " + std::to_string(points.size()) + " for " +
                         std::to_string(list.vertex_count()) + " vertices",
                     "give one a vertex");
  }
  std::vector<std::pair<VertexId, VertexId>> ends;
  for (std::size_t v = 0; v < list.vertex_count(); ++v)
    for (const VertexId head : list.heads_of(VertexId::from(v)))
      ends.emplace_back(std::min(VertexId::from(v), head), std::max(VertexId::from(v), head));
  std::sort(ends.begin(), ends.end());
  QuadEdge quads;
  quads.reserve(ends.size());
  for (const auto& [low, high] : ends) quads.make_edge(low, high);
  splice_in_order(quads, points, list.vertex_count());
  number_triangles(quads, points, holes);
  return quads;
}

}  // namespace leonhard::mesh
