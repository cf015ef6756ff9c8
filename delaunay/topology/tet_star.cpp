// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/tet_star.hpp"

namespace leonhard::delaunay {

void TetStar::collect(const GhostTetrahedralization& in, TetId t, VertexId v) {
  known_.clear();
  tets_.assign(1, t);
  known_.insert(t.raw);
  for (std::size_t k = 0; k < tets_.size(); ++k) {
    const TetId here = tets_[k];
    for (unsigned i = 0; i < 4; ++i)
      if (in.corners[here][i] != v && known_.insert((*in.neighbours[here][i]).raw))
        tets_.push_back(*in.neighbours[here][i]);
  }
  known_.clear();
  neighbours_.clear();
  for (const TetId here : tets_)
    for (const VertexId w : in.corners[here])
      if (w != v && known_.insert(w.raw)) neighbours_.push_back(w);
}

}  // namespace leonhard::delaunay
