// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/kernel/insertion_order.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// The Delaunay tetrahedralisation of a few points that span space, numbers out of use among it, ghosts all over.
class SmallTetrahedralization {
 public:
  SmallTetrahedralization(std::span<const Point3> points, const FirstTetrahedron& first) : points_(points) {
    start(first);
    for (const std::uint32_t i : order())
      if (std::find(first.points.begin(), first.points.end(), i) == first.points.end()) insert(VertexId{i});
  }
  [[nodiscard]] const GhostTetrahedralization& cells() const { return cells_; }

 private:
  /// Many points at random, lest there be far too many tetrahedra on the way.
  [[nodiscard]] std::vector<std::uint32_t> order() const {
    constexpr std::size_t few = 64;
    if (points_.size() > few) return kernel::brio_order(points_, 1);
    std::vector<std::uint32_t> all(points_.size());
    std::iota(all.begin(), all.end(), std::uint32_t{0});
    return all;
  }
  void start(const FirstTetrahedron& first) {
    TetCorners corners;
    for (unsigned i = 0; i < 4; ++i) corners[i] = VertexId::from(first.points[i]);
    TetReplacement replacement;
    replacement.put(corners);
    for (const auto& [a, b, c] : tet_face_corners)
      replacement.put({ghost, corners[a], corners[c], corners[b]});
    replacement.apply(cells_, spare_);
  }
  void insert(VertexId v) {
    cavity_.insert(cells_, points_, v, walk(cells_, points_, last_, points_[v.index()]), spare_);
    last_ = cavity_.made().front();
  }

  std::span<const Point3> points_;
  GhostTetrahedralization cells_;
  std::vector<TetId> spare_;
  TetCavity cavity_;
  TetId last_{};
};

}  // namespace

void DynamicTetrahedralization::remove(VertexId v) {
  require_living(v);
  if (!has_tets()) {
    flat_.erase(points_[v]);
    kill(v);
    return;
  }
  star_.collect(cells_, tets_[v], v);
  std::vector<VertexId> link;
  std::vector<Point3> link_points;
  for (const VertexId w : star_.neighbours()) {
    if (w == ghost) continue;
    link.push_back(w);
    link_points.push_back(points_[w]);
  }
  const FirstTetrahedron first = first_tetrahedron(link_points);
  // If all others are coplanar, every tetrahedron has v, so they are its neighbours, and the only ones.
  if (first.extent != Extent::space && link.size() == size() - 1) {
    fall_flat(v);
    return;
  }
  replacement_.start();
  for (const TetId t : star_.tets()) replacement_.take(t);
  if (first.extent == Extent::space)
    fill_with_tets(v, link, SmallTetrahedralization(link_points, first).cells());
  else
    fill_with_ghosts(v);
  replacement_.apply(cells_, spare_);
  for (const TetId t : replacement_.made()) set_tets_of(t);
  last_ = link.front();
  kill(v);
}

/// The tetrahedra that v would destroy in the Delaunay tetrahedralisation without it are Delaunay for v's neighbours alone,
/// which are their corners; and as with v there are the same tetrahedra about v among all points and among these, v
/// destroys no others in the tetrahedralisation of its neighbours.
///
/// without_v  that of v's neighbours; corner i is link[i]
void DynamicTetrahedralization::fill_with_tets(VertexId v, std::span<const VertexId> link,
                                               const GhostTetrahedralization& without_v) {
  std::vector<Point3> link_points;
  for (const VertexId w : link) link_points.push_back(points_[w]);
  for (const TetId t : without_v.corners.ids()) {
    TetCorners corners = without_v.corners[t];
    if (corners[1] == ghost || !in_conflict(without_v, link_points, t, points_[v])) continue;
    for (VertexId& w : corners)
      if (w != ghost) w = link[w.index()];
    replacement_.put(corners);
  }
}

/// v's neighbours are coplanar, others are not: v is a tip upon a face of the hull that remains.
void DynamicTetrahedralization::fill_with_ghosts(VertexId v) {
  for (const TetId t : star_.tets()) {
    const TetCorners& corners = cells_.corners[t];
    if (!cells_.is_ghost(t))
      replacement_.put(with_ghost_first(with_corner(corners, corner_index(corners, v), ghost)));
  }
}

void DynamicTetrahedralization::kill(VertexId v) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  points_[v] = {nan, nan, nan};
  free_.push_back(v);
}

void DynamicTetrahedralization::fall_flat(VertexId removed) {
  kill(removed);
  cells_ = {};
  spare_.clear();
  for (const VertexId v : vertices()) flat_.insert(points_[v], v);
}

}  // namespace leonhard::delaunay
