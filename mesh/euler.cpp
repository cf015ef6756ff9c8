// SPDX-License-Identifier: MIT
#include "leonhard/mesh/euler.hpp"

#include <algorithm>
#include <optional>

#include "leonhard/mesh/check/same_mesh.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/exact_sum.hpp"

namespace leonhard {

bool EulerAccount::balances() const {
  return std::all_of(formulas.begin(), formulas.end(), [](const Formula& f) { return f.holds(); });
}

namespace mesh {
namespace {

/// The number of the corner of t at v: 3 t + i where corners[t][i] == v.
std::size_t corner_at(const TriangleMesh& mesh, TriangleId t, VertexId v) {
  const auto& corners = mesh.corners[t];
  return 3 * t.index() +
         static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
}

/// Corners that meet at a vertex and are joined across edges: each class is a fan.
DisjointSets fans_of(const TriangleMesh& mesh, const EdgeStructure& edges) {
  DisjointSets fans(3 * mesh.triangle_count());
  for (const EdgeId e : edges.ends.ids()) {
    if (edges.is_boundary(e)) continue;
    for (const VertexId v : edges.ends[e]) {
      fans.join(corner_at(mesh, *edges.sides[e][0], v), corner_at(mesh, *edges.sides[e][1], v));
    }
  }
  return fans;
}

std::size_t component_count(const TriangleMesh& mesh, const EdgeStructure& edges) {
  DisjointSets components(mesh.triangle_count());
  for (const auto& [left, right] : edges.sides) {
    if (left && right) components.join((*left).index(), (*right).index());
  }
  return components.class_count();
}

/// A boundary edge with the mesh on its left, and the fans in which it leaves `from` and reaches `to`.
struct DirectedEdge {
  VertexId from, to;
  std::size_t fan_from, fan_to;
};

std::vector<DirectedEdge> directed_boundary(const TriangleMesh& mesh, const EdgeStructure& edges,
                                            DisjointSets& fans) {
  std::vector<DirectedEdge> directed;
  for (const EdgeId e : edges.ends.ids()) {
    if (!edges.is_boundary(e)) continue;
    const bool forward = edges.sides[e][0].has_value();
    const TriangleId t = *edges.sides[e][forward ? 0 : 1];
    const VertexId from = edges.ends[e][forward ? 0 : 1], to = edges.ends[e][forward ? 1 : 0];
    directed.push_back({from, to, fans.find(corner_at(mesh, t, from)), fans.find(corner_at(mesh, t, to))});
  }
  return directed;
}

struct LoopCount {
  std::size_t all{}, outer{}, holes{};
};

/// Walk every boundary loop once. A fan is open or closed; an open one is a row of triangles with one boundary edge
/// coming in and one going out, so the edge after one that reaches a fan is the one that leaves it.
LoopCount walk_loops(const TriangleMesh& mesh, const std::vector<DirectedEdge>& directed) {
  std::vector<std::optional<std::size_t>> leaving(3 * mesh.triangle_count());
  for (std::size_t i = 0; i < directed.size(); ++i) leaving[directed[i].fan_from] = i;

  LoopCount count;
  std::vector<char> walked(directed.size(), 0);
  for (std::size_t start = 0; start < directed.size(); ++start) {
    if (walked[start]) continue;
    ExactSum area2;
    for (std::optional<std::size_t> i = start; i && !walked[*i]; i = leaving[directed[*i].fan_to]) {
      walked[*i] = 1;
      const Point2 p = mesh.points[directed[*i].from], q = mesh.points[directed[*i].to];
      area2.add_cross(p.x, p.y, q.x, q.y);
    }
    ++count.all;
    if (area2.sign() == Sign::positive) ++count.outer;
    if (area2.sign() == Sign::negative) ++count.holes;
  }
  return count;
}

std::size_t vertices_in_use(const TriangleMesh& mesh) {
  PerId<VertexId, char> used(mesh.vertex_count(), 0);
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) used[v] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

void write_formulas(EulerAccount& account) {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const std::int64_t v = n(account.fans), e = n(account.edges), f = n(account.triangles);
  const std::int64_t e_in = n(account.interior_edges), e_bound = n(account.boundary_edges);
  const std::int64_t c = n(account.components), h = n(account.holes), l = n(account.boundary_loops);
  account.formulas = {
      {"(1.1.0)", "faces, counting the holes and the infinite face, are edges - vertices + 1 + components",
       f + h + 1, e - v + 1 + c},
      {"(1.1.1)", "triangles + vertices are edges + components - holes", f + v, e + c - h},
      {"(1.1.2)",
       "each triangle has three edges, each interior edge two triangles and each boundary edge one",
       2 * e_in + e_bound, 3 * f},
      {"(1.1.3)", "triangles are 2 vertices - boundary edges - 2 components + 2 holes", f,
       2 * v - e_bound - 2 * c + 2 * h},
      {"(1.1.4)", "edges are 3 vertices - boundary edges - 3 components + 3 holes", e,
       3 * v - e_bound - 3 * c + 3 * h},
      {"no handles",
       "vertices - edges + triangles are 2 components - boundary loops, as of spheres with loops cut out",
       v - e + f, 2 * c - l},
      {"outer loops", "each component has one counter-clockwise boundary loop", n(account.outer_loops), c},
      {"loops", "boundary loops are outer loops, one a component, and holes", l, c + h},
      {"boundary", "the boundary edges that the mesh lists are those with one triangle",
       n(account.listed_boundary_edges), e_bound},
      {"vertices", "every vertex has a triangle, and pinched ones one fan more for each pinch", v,
       n(account.vertices) + n(account.pinches)},
  };
}

}  // namespace

EulerAccount euler_account(const TriangleMesh& mesh, const EdgeStructure& edges) {
  require_edges_within(mesh, edges);
  DisjointSets fans = fans_of(mesh, edges);
  const std::vector<DirectedEdge> directed = directed_boundary(mesh, edges, fans);
  const LoopCount loops = walk_loops(mesh, directed);

  EulerAccount account;
  account.vertices = mesh.vertex_count();
  account.fans = fans.class_count();
  account.pinches = account.fans - vertices_in_use(mesh);
  account.edges = edges.edge_count();
  account.triangles = mesh.triangle_count();
  account.interior_edges = static_cast<std::size_t>(
      std::count_if(edges.sides.begin(), edges.sides.end(), [](const auto& s) { return s[0] && s[1]; }));
  account.boundary_edges = directed.size();
  account.listed_boundary_edges = mesh.boundary.size();
  account.components = component_count(mesh, edges);
  account.boundary_loops = loops.all;
  account.outer_loops = loops.outer;
  account.holes = loops.holes;
  write_formulas(account);
  return account;
}

}  // namespace mesh
}  // namespace leonhard
