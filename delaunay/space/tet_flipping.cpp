// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/tet_flipping.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include "leonhard/delaunay/space/first_tetrahedron.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/delaunay/topology/tet_replacement.hpp"
#include "leonhard/kernel/insertion_order.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// Why flipping does not get stuck, in degenerate positions too.
///
/// The tetrahedra that the new point v has taken over so far fill a region that is star-shaped about v; its tetrahedra
/// are cones from v over the region's faces. Behind such a face lies a tetrahedron t that the old points made. If v is
/// in its sphere, t is to join the region, and can as soon as all its faces turned towards v are the region's: one
/// face is a flip of 2 tetrahedra to 3, two are one of 3 to 2. (Three would leave their common corner inside the
/// convex hull of the others, all in one closed ball whose boundary that corner is on.) If v lies in the plane of a
/// face, the tetrahedron behind that face has v in its sphere at the same height of v on its way down to the paraboloid
/// and joins along with t: 4 to 4. Of all tetrahedra yet to join, the one whose hyperplane v passes first on that way
/// has its faces turned towards v on the region already, so there is always one that can be flipped.
///
/// Ghosts that v lies strictly beyond come before all others, in any order in which their faces of the hull make up
/// a disc at any time; a disc so begun can be completed, whatever the order (Danaraj and Klee 1978).
class Flipper {
 public:
  explicit Flipper(std::span<const Point3> points) : points_(points) {}

  void start(const std::array<VertexId, 4>& corners);
  void insert(VertexId v);
  [[nodiscard]] GhostTetrahedralization finish();

 private:
  [[nodiscard]] bool has(TetId t, VertexId v) const { return has_corner(in_.corners[t], v); }
  [[nodiscard]] TetId behind(TetId t, unsigned i) const { return *in_.neighbours[t][i]; }

  void split(VertexId v, TetId t);
  void settle(VertexId v);
  bool try_flip(VertexId v, TetId t);
  bool try_flip_beyond(VertexId v, TetId t);
  bool try_flip_about_edge(VertexId v, TetId t, unsigned turned, unsigned coplanar);
  void join(VertexId v);
  void join_one(VertexId v, TetId t);

  std::span<const Point3> points_;
  GhostTetrahedralization in_;
  std::vector<TetId> spare_;  // out of use
  std::vector<TetId>
      joining_;  // what v takes over next: one tetrahedron, or all that have carrier_ in common
  std::vector<VertexId> carrier_;
  std::vector<TetId> suspects_;  // with v: the face opposite to it may not be Delaunay
  TetReplacement replacement_;
  TetId last_{};
};

void Flipper::start(const std::array<VertexId, 4>& corners) {
  replacement_.start();
  replacement_.put(corners);
  for (const auto& [a, b, c] : tet_face_corners)
    replacement_.put({ghost, corners[a], corners[c], corners[b]});
  replacement_.apply(in_, spare_);
}

void Flipper::insert(VertexId v) {
  split(v, walk(in_, points_, last_, points_[v.index()]));
  settle(v);
}

/// t  holds v, or is a ghost that v lies beyond
void Flipper::split(VertexId v, TetId t) {
  carrier_.clear();
  joining_.assign(1, t);
  for (unsigned i = 0; i < 4; ++i) {
    if (in_.is_ghost(t) || side_of_face(in_, points_, t, i, points_[v.index()]) != Sign::zero)
      carrier_.push_back(in_.corners[t][i]);
    else
      joining_.push_back(behind(t, i));
  }
  if (carrier_.size() == 2) {
    joining_.clear();
    turn_about_edge(in_, t, carrier_[0], carrier_[1], [&](TetId about) {
      joining_.push_back(about);
      return true;
    });
  }
  join(v);
}

/// Cones from v over the outer faces of joining_ take the place of these and of the cones over the faces that they
/// share with v's region.
void Flipper::join(VertexId v) {
  replacement_.start();
  for (const TetId t : joining_) {
    replacement_.take(t);
    for (unsigned i = 0; i < 4; ++i) {
      if (std::find(carrier_.begin(), carrier_.end(), in_.corners[t][i]) == carrier_.end()) continue;
      const TetId outer = behind(t, i);
      if (has(outer, v))
        replacement_.take(outer);
      else
        replacement_.put(with_corner(in_.corners[t], i, v));
    }
  }
  replacement_.apply(in_, spare_);
  suspects_.insert(suspects_.end(), replacement_.made().begin(), replacement_.made().end());
  last_ = replacement_.made().front();
}

void Flipper::settle(VertexId v) {
  while (!suspects_.empty()) {
    const TetId suspect = suspects_.back();
    suspects_.pop_back();
    const unsigned i = corner_index(in_.corners[suspect], v);
    if (i == 4) continue;  // flipped away since
    const TetId t = behind(suspect, i);
    if (in_conflict(in_, points_, t, points_[v.index()])) try_flip(v, t);
  }
}

void Flipper::join_one(VertexId v, TetId t) {
  joining_.assign(1, t);
  carrier_.assign(in_.corners[t].begin(), in_.corners[t].end());
  join(v);
}

/// t  next to v's region and with v in its sphere; if it cannot join yet, a face of it is a suspect's once it can
bool Flipper::try_flip(VertexId v, TetId t) {
  const Point3& p = points_[v.index()];
  if (in_.is_ghost(t)) {
    if (side_of_face(in_, points_, t, 0, p) == Sign::positive) return try_flip_beyond(v, t);
    t = behind(t, 0);  // in the plane of the hull's face: the two go together
  }
  unsigned turned = 4, coplanar = 4;
  for (unsigned i = 0; i < 4; ++i) {
    const Sign side = side_of_face(in_, points_, t, i, p);
    if (side == Sign::zero) coplanar = i;
    if (side != Sign::negative) continue;
    if (!has(behind(t, i), v)) return false;
    turned = i;
  }
  if (coplanar < 4) return try_flip_about_edge(v, t, turned, coplanar);
  join_one(v, t);  // 2 to 3, or 3 to 2
  return true;
}

/// The flip of 4 to 4: a segment from v crosses the edge that two faces of t have in common.
///
/// turned, coplanar  the face turned towards v, and the one that has v in its plane: corners opposite to them
bool Flipper::try_flip_about_edge(VertexId v, TetId t, unsigned turned, unsigned coplanar) {
  const TetId other = behind(t, coplanar);
  const TetId before = behind(other, corner_index(in_.corners[other], in_.corners[t][turned]));
  if (!has(before, v)) return false;
  joining_.assign({t, other});
  carrier_.clear();
  for (unsigned i = 0; i < 4; ++i)
    if (i != coplanar) carrier_.push_back(in_.corners[t][i]);
  join(v);
  return true;
}

/// t  a ghost that v lies strictly beyond
bool Flipper::try_flip_beyond(VertexId v, TetId t) {
  unsigned shared = 0, last = 0;
  for (unsigned i = 1; i < 4; ++i) {
    if (!has(behind(t, i), v)) continue;
    ++shared;
    last = i;
  }
  // With one edge in common, the corner opposite to it must not be on the disc's rim already.
  const VertexId opposite = in_.corners[t][last];
  if (shared == 1 &&
      !turn_about_edge(in_, behind(t, last), ghost, v, [&](TetId about) { return !has(about, opposite); }))
    return false;
  join_one(v, t);
  return true;
}

GhostTetrahedralization Flipper::finish() {
  in_.erase(std::move(spare_));
  return std::move(in_);
}

TetrahedralizeOutcome flat_outcome(std::size_t points, Extent extent) {
  if (points < 4) return TetrahedralizeOutcome::too_few_points;
  return extent == Extent::plane ? TetrahedralizeOutcome::all_coplanar : TetrahedralizeOutcome::all_collinear;
}

}  // namespace

PointTetrahedralization tetrahedralize_flipping(std::span<const Point3> points,
                                                const TetAlgorithmOptions& options) {
  constexpr std::size_t poll = 1024;
  const std::vector<std::uint32_t> order = kernel::brio_order(points, options.seed);
  const FirstTetrahedron first = first_tetrahedron(points, order);
  if (first.extent != Extent::space) return {flat_outcome(points.size(), first.extent), {}};
  const auto& [a, b, c, d] = first.points;
  Flipper flipper(points);
  flipper.start({VertexId::from(a), VertexId::from(b), VertexId::from(c), VertexId::from(d)});
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % poll == 0) {
      options.progress("tetrahedralize", static_cast<double>(k) / static_cast<double>(order.size()));
      if (options.progress.stop_requested()) return {TetrahedralizeOutcome::stopped, {}};
    }
    const std::size_t next = order[k];
    if (std::find(first.points.begin(), first.points.end(), next) == first.points.end())
      flipper.insert(VertexId::from(next));
  }
  return {TetrahedralizeOutcome::done, flipper.finish()};
}

}  // namespace leonhard::delaunay
