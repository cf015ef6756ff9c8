// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/tet_replacement.hpp"

#include <algorithm>
#include <cassert>

namespace leonhard::delaunay {

void TetReplacement::add_face(const TetCorners& corners, unsigned opposite, TetId t, unsigned i,
                              bool is_old) {
  std::array<VertexId, 3> key{corners[(opposite + 1) % 4], corners[(opposite + 2) % 4],
                              corners[(opposite + 3) % 4]};
  if (key[1] < key[0]) std::swap(key[0], key[1]);
  if (key[2] < key[1]) std::swap(key[1], key[2]);
  if (key[1] < key[0]) std::swap(key[0], key[1]);
  faces_.push_back({key, t, i, is_old});
}

void TetReplacement::choose_places(GhostTetrahedralization& in, std::vector<TetId>& spare) {
  made_.assign(old_.begin(),
               old_.begin() + static_cast<std::ptrdiff_t>(std::min(old_.size(), corners_.size())));
  for (std::size_t i = made_.size(); i < old_.size(); ++i) {
    in.corners[old_[i]].fill(GhostTetrahedralization::ghost);
    spare.push_back(old_[i]);
  }
  while (made_.size() < corners_.size()) {
    if (spare.empty()) {
      in.neighbours.push_back({});
      made_.push_back(in.corners.push_back({}));
    } else {
      made_.push_back(spare.back());
      spare.pop_back();
    }
  }
}

/// Faces come in pairs: two of what goes were between them, two of what comes are joined, and one of each is where
/// the new meets the outside.
void TetReplacement::join_faces(GhostTetrahedralization& in) {
  std::sort(faces_.begin(), faces_.end(), [](const Face& f, const Face& g) { return f.key < g.key; });
  assert(faces_.size() % 2 == 0);
  for (std::size_t i = 0; i + 1 < faces_.size(); i += 2) {
    const Face &f = faces_[i], &g = faces_[i + 1];
    assert(f.key == g.key);
    if (f.is_old && g.is_old) continue;
    in.neighbours[f.t][f.i] = g.t;
    in.neighbours[g.t][g.i] = f.t;
  }
}

void TetReplacement::apply(GhostTetrahedralization& in, std::vector<TetId>& spare) {
  faces_.clear();
  for (const TetId t : old_)
    for (unsigned i = 0; i < 4; ++i)
      add_face(in.corners[t], i, *in.neighbours[t][i], mirror_index(in, t, i), true);
  choose_places(in, spare);
  for (std::size_t j = 0; j < made_.size(); ++j) {
    in.corners[made_[j]] = corners_[j];
    for (unsigned i = 0; i < 4; ++i) add_face(corners_[j], i, made_[j], i, false);
  }
  join_faces(in);
}

}  // namespace leonhard::delaunay
