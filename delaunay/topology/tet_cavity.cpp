// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/tet_cavity.hpp"

#include <algorithm>
#include <cassert>

#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {

void TetCavity::open(const GhostTetrahedralization& in, std::span<const Point3> points, VertexId v, TetId t) {
  cavity_.assign(1, t);
  walls_.clear();
  marks_[t.index()] = Mark::destroyed;
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const TetId inner = cavity_[k];
    for (unsigned i = 0; i < 4; ++i) {
      const TetId outer = *in.neighbours[inner][i];
      Mark& mark = marks_[outer.index()];
      if (mark == Mark::none) {
        mark = in_conflict(in, points, outer, points[v.index()]) ? Mark::destroyed : Mark::kept;
        if (mark == Mark::destroyed) {
          cavity_.push_back(outer);
          continue;
        }
      }
      if (mark == Mark::kept)
        walls_.push_back({with_corner(in.corners[inner], i, v), i, outer, mirror_index(in, inner, i)});
    }
  }
  for (const TetId destroyed : cavity_) marks_[destroyed.index()] = Mark::none;
  for (const Wall& wall : walls_) marks_[wall.outer.index()] = Mark::none;
}

void TetCavity::choose_places(GhostTetrahedralization& in, std::vector<TetId>& spare) {
  const std::size_t kept = std::min(cavity_.size(), walls_.size());
  made_.assign(cavity_.begin(), cavity_.begin() + static_cast<std::ptrdiff_t>(kept));
  for (std::size_t k = kept; k < cavity_.size(); ++k) {
    in.corners[cavity_[k]].fill(GhostTetrahedralization::ghost);
    spare.push_back(cavity_[k]);
  }
  for (std::size_t k = kept; k < walls_.size(); ++k) {
    if (spare.empty()) {
      in.neighbours.push_back({});
      made_.push_back(in.corners.push_back({}));
    } else {
      made_.push_back(spare.back());
      spare.pop_back();
    }
  }
}

/// Cones over walls with a common edge are neighbours.
void TetCavity::fill(GhostTetrahedralization& in) {
  edges_.clear();
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const Wall& wall = walls_[k];
    const TetId t = made_[k];
    in.corners[t] = wall.corners;
    in.neighbours[t][wall.face] = wall.outer;
    in.neighbours[wall.outer][wall.outer_face] = t;
    const auto& around = tet_face_corners[wall.face];
    for (unsigned n = 0; n < 3; ++n) {
      const VertexId a = wall.corners[around[n]], b = wall.corners[around[(n + 1) % 3]];
      edges_.push_back({{std::min(a, b), std::max(a, b)}, t, around[(n + 2) % 3]});
    }
  }
  std::sort(edges_.begin(), edges_.end(), [](const Edge& e, const Edge& f) { return e.ends < f.ends; });
  for (std::size_t k = 0; k + 1 < edges_.size(); k += 2) {
    const Edge &e = edges_[k], &f = edges_[k + 1];
    assert(e.ends == f.ends);
    in.neighbours[e.t][e.opposite] = f.t;
    in.neighbours[f.t][f.opposite] = e.t;
  }
}

void TetCavity::insert(GhostTetrahedralization& in, std::span<const Point3> points, VertexId v, TetId t,
                       std::vector<TetId>& spare) {
  if (marks_.size() < in.tet_count()) marks_.resize(2 * in.tet_count(), Mark::none);
  open(in, points, v, t);
  choose_places(in, spare);
  fill(in);
}

}  // namespace leonhard::delaunay
