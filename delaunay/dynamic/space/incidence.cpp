// SPDX-License-Identifier: MIT
// What is where in a DynamicTetrahedralization: counts, neighbours, the tetrahedra at a vertex, the hull.
#include <algorithm>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"

namespace leonhard::delaunay {
/// How many vertices and faces the hull's boundary has; nothing while all vertices are coplanar.
DynamicTetrahedralization::HullSize DynamicTetrahedralization::hull_size() const {
  if (!has_tets()) return {};
  TetStar star;
  star.collect(cells_, ghost_tet_, GhostTetrahedralization::ghost);
  return {star.neighbours().size(), star.tets().size()};
}

std::size_t DynamicTetrahedralization::tet_count() const {
  return cells_.tet_count() - spare_.size() - hull_size().faces;
}

/// Euler's formula of the 3-sphere with v + 1 vertices, the ghost among them, and t tetrahedra: v + 1 + t edges. One to
/// each vertex on the hull is the ghost's.
std::size_t DynamicTetrahedralization::edge_count() const {
  if (!has_tets()) return 0;
  return size() + 1 + cells_.tet_count() - spare_.size() - hull_size().vertices;
}

std::vector<VertexId> DynamicTetrahedralization::neighbours(VertexId v) const {
  require_living(v);
  if (!has_tets()) return {};
  TetStar star;
  star.collect(cells_, tets_[v], v);
  std::vector<VertexId> all(star.neighbours().begin(), star.neighbours().end());
  std::sort(all.begin(), all.end());
  if (all.back() == GhostTetrahedralization::ghost) all.pop_back();  // of the highest number
  return all;
}

/// Those of v; all vertices while they are coplanar and no edges are known.
void DynamicTetrahedralization::collect_neighbours(VertexId v, Search& search,
                                                   std::vector<VertexId>& into) const {
  if (!has_tets()) {
    into.assign(vertices().begin(), vertices().end());
    return;
  }
  search.star.collect(cells_, tets_[v], v);
  into.assign(search.star.neighbours().begin(), search.star.neighbours().end());
  std::erase(into, GhostTetrahedralization::ghost);
}

std::vector<VertexQuadruple> DynamicTetrahedralization::tets_at(VertexId v) const {
  require_living(v);
  std::vector<VertexQuadruple> all;
  if (!has_tets()) return all;
  TetStar star;
  star.collect(cells_, tets_[v], v);
  for (const TetId t : star.tets())
    if (!cells_.is_ghost(t)) all.push_back(cells_.corners[t]);
  return all;
}

bool DynamicTetrahedralization::on_hull(VertexId v) const {
  require_living(v);
  if (!has_tets()) return true;
  TetStar star;
  star.collect(cells_, tets_[v], v);
  return std::any_of(star.tets().begin(), star.tets().end(), [&](TetId t) { return cells_.is_ghost(t); });
}

std::vector<VertexTriple> DynamicTetrahedralization::hull() const {
  std::vector<VertexTriple> faces;
  if (!has_tets()) return faces;
  TetStar star;
  star.collect(cells_, ghost_tet_, GhostTetrahedralization::ghost);
  for (const TetId t : star.tets()) {
    const TetCorners& c = cells_.corners[t];  // seen from outside, c[1], c[2], c[3] run clockwise
    VertexTriple face{c[1], c[3], c[2]};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace leonhard::delaunay
