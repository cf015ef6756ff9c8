// SPDX-License-Identifier: MIT
// The nearest neighbour property of properties.hpp.
#include <algorithm>
#include <vector>

#include "leonhard/delaunay/properties.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// For each vertex the nearest of those that an edge joins to it.
PerId<VertexId, MaybeId<VertexId>> nearest_joined(const TriangleMesh& mesh, const EdgeStructure& edges) {
  PerId<VertexId, MaybeId<VertexId>> nearest(mesh.vertex_count());
  const auto offer = [&](VertexId v, VertexId candidate) {
    if (!nearest[v] || kernel::compare_distance(mesh.points[v], mesh.points[candidate],
                                                mesh.points[*nearest[v]]) == Sign::negative)
      nearest[v] = candidate;
  };
  for (const auto& [a, b] : edges.ends) {
    offer(a, b);
    offer(b, a);
  }
  return nearest;
}

/// Vertices along the axis in which the points reach farther.
class Strip {
 public:
  explicit Strip(const TriangleMesh& mesh) : mesh_(mesh) {
    for (const VertexId v : mesh.points.ids()) order_.push_back(v);
    const auto [west, east] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                                  [](Point2 p, Point2 q) { return p.x < q.x; });
    const auto [south, north] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                                    [](Point2 p, Point2 q) { return p.y < q.y; });
    along_x_ = order_.empty() || east->x / 2 - west->x / 2 >= north->y / 2 - south->y / 2;
    std::sort(order_.begin(), order_.end(),
              [&](VertexId v, VertexId w) { return coordinate(v) < coordinate(w); });
  }
  [[nodiscard]] const std::vector<VertexId>& order() const { return order_; }
  /// The point of the line through v along the axis that is abreast of w: no farther from v than w.
  [[nodiscard]] Point2 abreast(VertexId v, VertexId w) const {
    const Point2 p = mesh_.points[v], q = mesh_.points[w];
    return along_x_ ? Point2{q.x, p.y} : Point2{p.x, q.y};
  }

 private:
  [[nodiscard]] double coordinate(VertexId v) const {
    return along_x_ ? mesh_.points[v].x : mesh_.points[v].y;
  }
  const TriangleMesh& mesh_;
  std::vector<VertexId> order_;
  bool along_x_ = true;
};

}  // namespace

std::optional<std::string> validate_nearest_neighbours(const TriangleMesh& mesh) {
  const EdgeStructure edges = mesh::build_edges(mesh);
  const auto nearest = nearest_joined(mesh, edges);
  const Strip strip(mesh);
  const auto& order = strip.order();
  std::optional<std::string> problem;
  // Whether w is too far along the axis for any vertex behind it to be as near to v as the nearest joined
  // one.
  const auto passes = [&](VertexId v, VertexId w) {
    const Point2 p = mesh.points[v], near = mesh.points[*nearest[v]];
    if (kernel::compare_distance(p, strip.abreast(v, w), near) == Sign::positive) return false;
    if (kernel::compare_distance(p, mesh.points[w], near) == Sign::positive || edges.find(v, w)) return true;
    problem = mesh::words(mesh, w) + " is as near to " + mesh::words(mesh, v) + " as " +
              mesh::words(mesh, *nearest[v]) + " or nearer, but no edge joins the two";
    return false;
  };
  for (std::size_t i = 0; i < order.size() && !problem; ++i) {
    for (std::size_t j = i + 1; j < order.size() && passes(order[i], order[j]);) ++j;
    for (std::size_t j = i; j-- > 0 && !problem && passes(order[i], order[j]);) continue;
  }
  return problem;
}

}  // namespace leonhard::delaunay
