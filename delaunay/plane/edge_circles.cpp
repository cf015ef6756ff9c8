// SPDX-License-Identifier: MIT
// The edge circle properties of properties.hpp.
#include <vector>

#include "leonhard/delaunay/constrained/visibility.hpp"
#include "leonhard/delaunay/properties.hpp"
#include "leonhard/delaunay/topology/interior_edges.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

using mesh::words;

/// The circles through the ends a, b of an edge that have no vertex inside.
class Pencil {
 public:
  Pencil(const TriangleMesh& mesh, VertexId a, VertexId b)
      : mesh_(mesh), a_(a), b_(b), a_at_(mesh.points[a]), b_at_(mesh.points[b]) {}

  /// Take out the circles with v inside, if counts(v): asked only where there are any.
  template <class Counts>
  void exclude(VertexId v, const Counts& counts) {
    if (v == a_ || v == b_) return;
    const Point2 p = mesh_.points[v];
    switch (kernel::orient2d(a_at_, b_at_, p)) {
      case Sign::positive:
        if (is_first(left_, a_at_, b_at_, p) && counts(v)) left_ = v;
        return;
      case Sign::negative:
        if (is_first(right_, b_at_, a_at_, p) && counts(v)) right_ = v;
        return;
      case Sign::zero:
        if ((a_at_ < p) == (p < b_at_) && a_at_ != p && p != b_at_) on_edge_ = v;
    }
  }

  /// Words if no circle is left.
  [[nodiscard]] std::optional<std::string> broken() const {
    const std::string edge = words(mesh_, a_, b_);
    if (on_edge_) return words(mesh_, *on_edge_) + " lies on " + edge;
    if (!left_ || !right_) return std::nullopt;
    const Point2 left = mesh_.points[*left_], right = mesh_.points[*right_];
    if (kernel::incircle(a_at_, b_at_, left, right) != Sign::positive) return std::nullopt;
    return "every circle through the ends of " + edge + " has " + words(mesh_, *left_) + " or " +
           words(mesh_, *right_) + " inside";
  }

 private:
  /// With p on the left of uv: does the circle that grows to the left meet p before the first one so far?
  [[nodiscard]] bool is_first(MaybeId<VertexId> so_far, const Point2& u, const Point2& v,
                              const Point2& p) const {
    return !so_far || kernel::incircle(u, v, mesh_.points[*so_far], p) == Sign::positive;
  }
  const TriangleMesh& mesh_;
  VertexId a_, b_;
  Point2 a_at_, b_at_;
  MaybeId<VertexId> left_, right_, on_edge_;
};

std::vector<Wall> walls(const TriangleMesh& mesh) {
  std::vector<Wall> all;
  for (const auto* edges : {&mesh.boundary, &mesh.constraints})
    for (const MarkedEdge& edge : *edges) all.push_back({mesh.points[edge.from], mesh.points[edge.to]});
  return all;
}

}  // namespace

std::optional<std::string> validate_edge_circles(const TriangleMesh& mesh) {
  for (const auto& [a, b] : mesh::build_edges(mesh).ends) {
    Pencil pencil(mesh, a, b);
    for (const VertexId v : mesh.points.ids()) pencil.exclude(v, [](VertexId) { return true; });
    if (auto problem = pencil.broken()) return problem;
  }
  return std::nullopt;
}

std::optional<std::string> validate_constrained_edge_circles(const TriangleMesh& mesh) {
  const std::vector<Wall> all_walls = walls(mesh);
  return first_of_interior_edges(mesh, [&](const TrianglePair& pair) {
    Pencil pencil(mesh, pair.from, pair.to);
    for (const VertexId v : mesh.points.ids()) {
      pencil.exclude(v, [&](VertexId seen) {
        return sees_edge(mesh.points[seen], mesh.points[pair.from], mesh.points[pair.to], all_walls);
      });
    }
    return pencil.broken();
  });
}

}  // namespace leonhard::delaunay
