// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

/// Words for the first vertex whose triangles overlap about it. The ray from v in direction +x lies in the triangle
/// v, p, q if and only if the edge p -> q rises past it; the sector is less than half a turn, so it cannot rise on
/// the other side. No rounding: three comparisons.
std::optional<std::string> overwound_vertex(const TriangleMesh& mesh) {
  PerId<VertexId, unsigned> count(mesh.vertex_count(), 0);
  for (const auto& corners : mesh.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double y = mesh.points[corners[i]].y;
      if (mesh.points[corners[(i + 1) % 3]].y <= y && y < mesh.points[corners[(i + 2) % 3]].y)
        ++count[corners[i]];
    }
  }
  for (const VertexId v : count.ids()) {
    if (count[v] > 1) {
      return "the triangles about " + words(mesh, v) + " overlap: " + std::to_string(count[v]) +
             " of them cover the same direction from it";
    }
  }
  return std::nullopt;
}

/// A boundary edge as the sweep sees it. Sites are the boundary's places in lexicographic order, each once.
struct Segment {
  std::size_t left, right;  ///< sites, left < right
  bool mesh_above;          ///< else below; "above" is to the left of left -> right
  VertexId from, to;        ///< the mesh to the left
  TriangleId triangle;
};

/// A sweep from the lexicographically least site to the greatest over the boundary edges.
class BoundarySweep {
 public:
  explicit BoundarySweep(const TriangleMesh& mesh) : mesh_(mesh) { collect(); }

  [[nodiscard]] std::optional<std::string> first_overlap();

 private:
  using SegmentIndex = std::size_t;

  /// The order of segments across the sweep line, and of points against segments. Valid for segments that do not
  /// cross, and points that lie on none.
  struct Below {
    using is_transparent = void;
    const BoundarySweep* sweep;
    bool operator()(SegmentIndex s, SegmentIndex t) const { return sweep->is_below(s, t); }
    bool operator()(SegmentIndex s, Point2 p) const { return sweep->turn(s, p) == Sign::positive; }
  };
  using Status = std::set<SegmentIndex, Below>;

  void collect();
  [[nodiscard]] std::optional<std::string> cancel_slits();
  [[nodiscard]] std::optional<std::string> pass_site(std::size_t site, Status& status);
  [[nodiscard]] std::optional<std::string> start_segments(Status& status, Status::iterator above,
                                                          std::vector<SegmentIndex> starting);

  [[nodiscard]] Sign turn(SegmentIndex s, Point2 p) const {
    return kernel::orient2d(sites_[segments_[s].left], sites_[segments_[s].right], p);
  }
  [[nodiscard]] bool is_below(SegmentIndex s, SegmentIndex t) const;
  [[nodiscard]] bool cross_properly(SegmentIndex s, SegmentIndex t) const;
  [[nodiscard]] std::string segment_words(SegmentIndex s) const;
  [[nodiscard]] std::optional<std::string> crossing(SegmentIndex s, SegmentIndex t) const;

  const TriangleMesh& mesh_;
  std::vector<Point2> sites_;
  std::vector<Segment> segments_;                ///< sorted by (left, right)
  std::vector<std::vector<SegmentIndex>> ends_;  ///< per site, the segments that end there
  std::vector<int> cover_above_;                 ///< per segment, how many triangles lie just above it
};

void BoundarySweep::collect() {
  const BoundaryFacets<2> boundary(mesh_);
  for (const auto& edge : boundary.facets()) sites_.push_back(mesh_.points[edge.sorted.directed()[0]]);
  std::sort(sites_.begin(), sites_.end(), [](Point2 a, Point2 b) { return a < b; });
  sites_.erase(std::unique(sites_.begin(), sites_.end()), sites_.end());
  const auto site_of = [&](VertexId v) {
    return static_cast<std::size_t>(std::lower_bound(sites_.begin(), sites_.end(), mesh_.points[v],
                                                     [](Point2 a, Point2 b) { return a < b; }) -
                                    sites_.begin());
  };
  for (const auto& edge : boundary.facets()) {
    const auto [from, to] = edge.sorted.directed();
    const std::size_t start = site_of(from), end = site_of(to);
    segments_.push_back({std::min(start, end), std::max(start, end), start < end, from, to, edge.cell});
  }
  std::sort(segments_.begin(), segments_.end(), [](const Segment& s, const Segment& t) {
    return std::tie(s.left, s.right, s.mesh_above) < std::tie(t.left, t.right, t.mesh_above);
  });
}

std::string BoundarySweep::segment_words(SegmentIndex s) const {
  const Segment& edge = segments_[s];
  return "boundary " + words(mesh_, edge.from, edge.to) + " of triangle " + std::to_string(edge.triangle.raw);
}

/// Two edges between the same places with the mesh on either side add nothing to the winding number: they go.
std::optional<std::string> BoundarySweep::cancel_slits() {
  std::vector<Segment> kept;
  const auto same_place = [&](std::size_t i, std::size_t j) {
    return segments_[i].left == segments_[j].left && segments_[i].right == segments_[j].right;
  };
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (i + 1 == segments_.size() || !same_place(i, i + 1)) {
      kept.push_back(segments_[i]);
      continue;
    }
    const bool third = i + 2 < segments_.size() && same_place(i, i + 2);
    if (third || segments_[i].mesh_above == segments_[i + 1].mesh_above) {
      return segment_words(i) + " and " + segment_words(third ? i + 2 : i + 1) +
             " are the same place, so triangles overlap there";
    }
    ++i;
  }
  segments_ = std::move(kept);
  return std::nullopt;
}

bool BoundarySweep::is_below(SegmentIndex s, SegmentIndex t) const {
  const Segment &a = segments_[s], &b = segments_[t];
  if (a.left == b.left) return turn(s, sites_[b.right]) == Sign::positive;
  if (a.left < b.left) return turn(s, sites_[b.left]) == Sign::positive;
  return turn(t, sites_[a.left]) == Sign::negative;
}

bool BoundarySweep::cross_properly(SegmentIndex s, SegmentIndex t) const {
  const Segment &a = segments_[s], &b = segments_[t];
  return turn(s, sites_[b.left]) * turn(s, sites_[b.right]) == Sign::negative &&
         turn(t, sites_[a.left]) * turn(t, sites_[a.right]) == Sign::negative;
}

std::optional<std::string> BoundarySweep::crossing(SegmentIndex s, SegmentIndex t) const {
  if (!cross_properly(s, t)) return std::nullopt;
  return segment_words(s) + " crosses " + segment_words(t) + ", so triangles overlap there";
}

/// Insert the segments that start at one site below `above`, with the cover between them.
std::optional<std::string> BoundarySweep::start_segments(Status& status, Status::iterator above,
                                                         std::vector<SegmentIndex> starting) {
  std::sort(starting.begin(), starting.end(), [&](SegmentIndex s, SegmentIndex t) { return is_below(s, t); });
  int cover = above == status.begin() ? 0 : cover_above_[*std::prev(above)];
  for (std::size_t i = 0; i < starting.size(); ++i) {
    const SegmentIndex s = starting[i];
    if (i > 0 && turn(starting[i - 1], sites_[segments_[s].right]) == Sign::zero) {
      return segment_words(starting[i - 1]) + " and " + segment_words(s) +
             " lie on one another: a vertex of one is missing in the other, or triangles overlap";
    }
    cover += segments_[s].mesh_above ? 1 : -1;
    if (cover < 0 || cover > 1) {
      return "triangles overlap at " + segment_words(s) +
             ": other triangles of the mesh lie on both sides of it";
    }
    cover_above_[s] = cover;
    status.insert(above, s);
  }
  return std::nullopt;
}

std::optional<std::string> BoundarySweep::pass_site(std::size_t site, Status& status) {
  for (const SegmentIndex s : ends_[site]) status.erase(s);
  const Point2 p = sites_[site];
  const auto above = status.lower_bound(p);
  if (above != status.end() && turn(*above, p) == Sign::zero) {
    return "a boundary vertex at " + words(p) + " lies inside " + segment_words(*above) +
           ", which does not end there";
  }
  std::vector<SegmentIndex> starting;
  const auto first = std::partition_point(segments_.begin(), segments_.end(),
                                          [&](const Segment& s) { return s.left < site; });
  for (auto s = first; s != segments_.end() && s->left == site; ++s) {
    starting.push_back(static_cast<SegmentIndex>(s - segments_.begin()));
  }
  const auto below = above == status.begin() ? status.end() : std::prev(above);
  if (auto problem = start_segments(status, above, std::move(starting))) return problem;

  // New neighbours across the sweep line: all pairs next to each other from `below` to `above`.
  auto at = below == status.end() ? status.begin() : below;
  for (; at != above; ++at) {
    const auto next = std::next(at);
    if (next == status.end()) break;
    if (auto problem = crossing(*at, *next)) return problem;
  }
  return std::nullopt;
}

std::optional<std::string> BoundarySweep::first_overlap() {
  if (auto problem = cancel_slits()) return problem;
  ends_.assign(sites_.size(), {});
  for (SegmentIndex s = 0; s < segments_.size(); ++s) ends_[segments_[s].right].push_back(s);
  cover_above_.assign(segments_.size(), 0);
  Status status(Below{this});
  for (std::size_t site = 0; site < sites_.size(); ++site) {
    if (auto problem = pass_site(site, status)) return problem;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> validate_embedding(const TriangleMesh& mesh) {
  if (auto problem = overwound_vertex(mesh)) return problem;
  return BoundarySweep(mesh).first_overlap();
}

}  // namespace leonhard::mesh
