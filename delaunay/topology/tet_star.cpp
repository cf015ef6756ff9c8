// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/tet_star.hpp"

#include <utility>

namespace leonhard::delaunay {
namespace {

constexpr IdRaw none = std::numeric_limits<IdRaw>::max();
constexpr std::size_t first_slots = 128;

}  // namespace

void IdSet::clear() {
  slots_.assign(first_slots, none);
  size_ = 0;
}

bool IdSet::insert(IdRaw id) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = ((id * 0x9e3779b1U) >> 7) & mask;
  while (slots_[at] != none) {
    if (slots_[at] == id) return false;
    at = (at + 1) & mask;
  }
  slots_[at] = id;
  if (2 * ++size_ > slots_.size()) grow();
  return true;
}

void IdSet::grow() {
  std::vector<IdRaw> old = std::exchange(slots_, std::vector<IdRaw>(4 * slots_.size(), none));
  size_ = 0;
  for (const IdRaw id : old)
    if (id != none) insert(id);
}

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
