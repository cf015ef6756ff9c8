// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/space/tet_circumcentre.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"

namespace leonhard::delaunay {
namespace {

/// Puts the cell of a vertex together from the tetrahedra about it: each real one gives a corner, each ghost a ray, each
/// edge a face; what exact predicates say is the same is made one before.
class CellBuilder {
 public:
  CellBuilder(const GhostTetrahedralization& in, std::span<const Point3> points, const TetStar& star,
              VertexId v)
      : in_(in), points_(points), v_(v), tets_(star.tets().begin(), star.tets().end()), same_(tets_.size()) {
    std::sort(tets_.begin(), tets_.end());
    join_what_is_the_same();
    number_corners_and_rays();
    std::vector<VertexId> neighbours(star.neighbours().begin(), star.neighbours().end());
    std::sort(neighbours.begin(), neighbours.end());
    for (const VertexId w : neighbours)
      if (w != GhostTetrahedralization::ghost) add_face(w);
  }
  [[nodiscard]] TetVoronoiCell take() && { return std::move(cell_); }

 private:
  [[nodiscard]] std::size_t place(TetId t) const {
    return static_cast<std::size_t>(std::lower_bound(tets_.begin(), tets_.end(), t) - tets_.begin());
  }
  [[nodiscard]] const Point3& at(VertexId v) const { return points_[v.index()]; }
  [[nodiscard]] TetId behind(TetId ghost_tet) const { return *in_.neighbours[ghost_tet][0]; }

  /// Neighbours about v: real ones with one sphere; ghosts with one plane and one sphere behind it.
  void join_what_is_the_same() {
    const auto for_pairs = [&](bool ghosts, const auto& is_same) {
      for (const TetId t : tets_) {
        if (in_.is_ghost(t) != ghosts) continue;
        for (unsigned i = 0; i < 4; ++i) {
          const TetId u = *in_.neighbours[t][i];
          if (in_.corners[t][i] == v_ || in_.is_ghost(u) != ghosts || u < t) continue;
          if (is_same(t, in_.corners[u][mirror_index(in_, t, i)])) same_.join(place(t), place(u));
        }
      }
    };
    for_pairs(false, [&](TetId t, VertexId beyond) {
      const TetCorners& c = in_.corners[t];
      return kernel::insphere(at(c[0]), at(c[1]), at(c[2]), at(c[3]), at(beyond)) == Sign::zero;
    });
    for_pairs(true, [&](TetId t, VertexId beyond) {
      if (side_of_face(in_, points_, t, 0, at(beyond)) != Sign::zero) return false;
      const TetCorners& c = in_.corners[behind(t)];
      return kernel::insphere(at(c[0]), at(c[1]), at(c[2]), at(c[3]), at(beyond)) == Sign::zero;
    });
  }

  void number_corners_and_rays() {
    number_.resize(tets_.size());
    std::vector<std::optional<std::size_t>> of_class(tets_.size());
    for (std::size_t k = 0; k < tets_.size(); ++k) {  // corners first: rays refer to them
      if (in_.is_ghost(tets_[k])) continue;
      const TetCorners& c = in_.corners[tets_[k]];
      const VoronoiCorner<Point3> centre = rounded_circumcentre({at(c[0]), at(c[1]), at(c[2]), at(c[3])});
      std::optional<std::size_t>& number = of_class[same_.find(k)];
      if (!number) {
        number = cell_.corners.size();
        cell_.corners.push_back(centre);
      }
      if (centre.error < cell_.corners[*number].error) cell_.corners[*number] = centre;
      number_[k] = *number;
    }
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (!in_.is_ghost(tets_[k])) continue;
      std::optional<std::size_t>& number = of_class[same_.find(k)];
      if (!number) {
        const TetCorners& c = in_.corners[tets_[k]];
        number = cell_.rays.size();
        cell_.rays.push_back({number_[place(behind(tets_[k]))], unit_normal(at(c[1]), at(c[3]), at(c[2]))});
      }
      number_[k] = *number;
    }
  }

  /// The next tetrahedron about the edge from v to w, counter-clockwise as seen from w: behind the face on which the edge
  /// runs counter-clockwise as seen from outside.
  [[nodiscard]] TetId turn(TetId t, VertexId w) const {
    const TetCorners& c = in_.corners[t];
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned k = 0; k < 3; ++k)
        if (c[tet_face_corners[i][k]] == v_ && c[tet_face_corners[i][(k + 1) % 3]] == w)
          return *in_.neighbours[t][i];
    assert(false);
    return t;
  }

  void add_face(VertexId w) {
    TetId first =
        *std::find_if(tets_.begin(), tets_.end(), [&](TetId t) { return has_corner(in_.corners[t], w); });
    std::vector<TetId> ring;
    for (TetId t = first; ring.empty() || t != first; t = turn(t, w)) ring.push_back(t);
    // On the hull two ghosts follow each other: one of them to the end, the other one to the begin.
    const auto is_ghost = [&](TetId t) { return in_.is_ghost(t); };
    const bool is_unbounded = std::any_of(ring.begin(), ring.end(), is_ghost);
    while (is_unbounded && !(is_ghost(ring.front()) && is_ghost(ring.back())))
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());

    TetVoronoiCell::Face face{w, {}, {}};
    for (const TetId t : ring) {
      const std::size_t number = number_[place(t)];
      if (!is_ghost(t) && (face.corners.empty() || face.corners.back() != number))
        face.corners.push_back(number);
    }
    if (is_unbounded) {
      face.rays = {number_[place(ring.front())], number_[place(ring.back())]};
      if (face.rays[0] == face.rays[1]) return;  // the two cells share a ray only
    } else {
      if (face.corners.front() == face.corners.back()) face.corners.pop_back();
      if (face.corners.size() < 3) return;  // the two cells share an edge or a corner only
    }
    cell_.faces.push_back(std::move(face));
  }

  const GhostTetrahedralization& in_;
  std::span<const Point3> points_;
  VertexId v_;
  std::vector<TetId> tets_;          // about v, in rising order
  mesh::DisjointSets same_;          // of these
  std::vector<std::size_t> number_;  // one a tetrahedron: of its corner, or of its ray
  TetVoronoiCell cell_;
};

}  // namespace

TetVoronoiCell DynamicTetrahedralization::voronoi_cell(VertexId v) const {
  require_living(v);
  if (!has_tets()) return {};
  TetStar star;
  star.collect(cells_, tets_[v], v);
  return CellBuilder(cells_, points_.flat(), star, v).take();
}

}  // namespace leonhard::delaunay
