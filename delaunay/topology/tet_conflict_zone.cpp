// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/tet_conflict_zone.hpp"

#include <algorithm>

#include "leonhard/delaunay/topology/tet_conflict.hpp"

namespace leonhard::delaunay {

void TetConflictZone::collect(const GhostTetrahedralization& in, std::span<const Point3> points, TetId t,
                              const Point3& p) {
  destroyed_.clear();
  kept_.clear();
  walls_.clear();
  has_ghost_ = false;
  tets_.assign(1, t);
  destroyed_.insert(t.raw);
  for (std::size_t k = 0; k < tets_.size(); ++k) {
    has_ghost_ = has_ghost_ || in.is_ghost(tets_[k]);
    for (const MaybeId<TetId> behind : in.neighbours[tets_[k]]) {
      const TetId u = *behind;
      if (destroyed_.contains(u.raw) || kept_.contains(u.raw)) continue;
      if (in_conflict(in, points, u, p)) {
        destroyed_.insert(u.raw);
        tets_.push_back(u);
      } else {
        kept_.insert(u.raw);
      }
    }
  }
  std::sort(tets_.begin(), tets_.end());
  for (const TetId inner : tets_)
    for (unsigned i = 0; i < 4; ++i)
      if (!destroyed_.contains((*in.neighbours[inner][i]).raw)) walls_.push_back({inner, i});
}

}  // namespace leonhard::delaunay
