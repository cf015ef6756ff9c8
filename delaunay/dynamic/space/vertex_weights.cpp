// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic/space/vertex_weights.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "leonhard/delaunay/dynamic/weights_by_shares.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

/// A vector whose coordinates are doubles or rationals.
template <class Number>
struct Vector3 {
  Number x, y, z;
};

template <class Number>
Vector3<Number> difference(const Point3& a, const Point3& b) {
  return {Number(a.x) - Number(b.x), Number(a.y) - Number(b.y), Number(a.z) - Number(b.z)};
}
template <class Number>
Vector3<Number> minus(const Vector3<Number>& u, const Vector3<Number>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <class Number>
Vector3<Number> plus(const Vector3<Number>& u, const Vector3<Number>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <class Number>
Vector3<Number> cross(const Vector3<Number>& u, const Vector3<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
template <class Number>
Number dot(const Vector3<Number>& u, const Vector3<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class Number>
Number volume6(const Vector3<Number>& u, const Vector3<Number>& v, const Vector3<Number>& w) {
  return dot(u, cross(v, w));
}

double magnitude_of(double x) { return std::abs(x); }
mpq_class magnitude_of(const mpq_class& x) { return abs(x); }

/// The circumcentre of 0, u, v and w.
template <class Number>
Vector3<Number> circumcentre(const Vector3<Number>& u, const Vector3<Number>& v, const Vector3<Number>& w) {
  const Vector3<Number> vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Number uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), divisor = 2 * dot(u, vw);
  return {(uu * vw.x + vv * wu.x + ww * uv.x) / divisor, (uu * vw.y + vv * wu.y + ww * uv.y) / divisor,
          (uu * vw.z + vv * wu.z + ww * uv.z) / divisor};
}

/// The circumcentre of 0, u and v in their plane.
template <class Number>
Vector3<Number> circumcentre(const Vector3<Number>& u, const Vector3<Number>& v) {
  const Vector3<Number> normal = cross(u, v);
  const Number uu = dot(u, u), vv = dot(v, v), divisor = 2 * dot(normal, normal);
  const Vector3<Number> across{uu * v.x - vv * u.x, uu * v.y - vv * u.y, uu * v.z - vv * u.z};
  const Vector3<Number> way = cross(across, normal);
  return {way.x / divisor, way.y / divisor, way.z / divisor};
}

/// A vertex's place among weights in rising order.
std::size_t place_of(VertexId v, const std::vector<VertexWeight>& corners) {
  const auto at = std::lower_bound(corners.begin(), corners.end(), v,
                                   [](const VertexWeight& w, VertexId id) { return w.vertex < id; });
  return static_cast<std::size_t>(at - corners.begin());
}

/// Lengths along the axis nearest to the edge's direction: all have one sign, and the sum is not 0.
template <class Number>
std::vector<Number> edge_shares(const Point3& from, const Point3& to, const Point3& p) {
  const Vector3<Number> whole = difference<Number>(to, from), first = difference<Number>(to, p),
                        last = difference<Number>(p, from);
  const Number x = magnitude_of(whole.x), y = magnitude_of(whole.y), z = magnitude_of(whole.z);
  if (x >= y && x >= z) return {first.x, last.x};
  if (y >= z) return {first.y, last.y};
  return {first.z, last.z};
}

/// Areas as seen along the axis nearest to the triangle's normal.
template <class Number>
std::vector<Number> face_shares(const std::array<Point3, 3>& corners, const Point3& p) {
  const Vector3<Number> u = difference<Number>(corners[0], p), v = difference<Number>(corners[1], p),
                        w = difference<Number>(corners[2], p);
  const Vector3<Number> vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Vector3<Number> normal =
      cross(difference<Number>(corners[1], corners[0]), difference<Number>(corners[2], corners[0]));
  const Number x = magnitude_of(normal.x), y = magnitude_of(normal.y), z = magnitude_of(normal.z);
  if (x >= y && x >= z) return {vw.x, wu.x, uv.x};
  if (y >= z) return {vw.y, wu.y, uv.y};
  return {vw.z, wu.z, uv.z};
}

template <class Number>
std::vector<Number> tet_shares(const std::array<Point3, 4>& corners, const Point3& p) {
  std::array<Vector3<Number>, 4> arm;
  for (unsigned i = 0; i < 4; ++i) arm[i] = difference<Number>(corners[i], p);
  std::vector<Number> shares;
  for (const auto& [a, b, c] : tet_face_corners) shares.push_back(volume6(arm[a], arm[b], arm[c]));
  return shares;
}

/// What the corners of the zone lose to p, times twelve; p is the origin.
template <class Number>
class StolenVolumes {
 public:
  StolenVolumes(const GhostTetrahedralization& in, std::span<const Point3> points,
                const TetConflictZone& zone, const std::vector<VertexWeight>& corners, const Point3& p)
      : in_(in), zone_(zone), corners_(corners), volumes_(corners.size(), Number(0)) {
    for (const auto& [v, weight] : corners) arms_.push_back(difference<Number>(points[v.index()], p));
    for (const TetId t : zone.tets()) old_centres_.push_back(old_centre(points, t));
    for (const TetConflictZone::Wall& wall : zone.walls()) {
      const auto [a, b, c] = corners_of(wall.inner, wall.face);
      new_centres_.push_back(circumcentre(arms_[a], arms_[b], arms_[c]));
    }
    add_faces_within();
    add_walls();
    add_edges_of_walls();
  }
  [[nodiscard]] const std::vector<Number>& volumes() const { return volumes_; }

 private:
  [[nodiscard]] std::size_t place(VertexId v) const { return place_of(v, corners_); }
  [[nodiscard]] std::size_t place(TetId t) const {
    const auto tets = zone_.tets();
    return static_cast<std::size_t>(std::lower_bound(tets.begin(), tets.end(), t) - tets.begin());
  }
  /// The places of a face's corners, counter-clockwise as seen from outside of t.
  [[nodiscard]] std::array<std::size_t, 3> corners_of(TetId t, unsigned face) const {
    const auto& [a, b, c] = tet_face_corners[face];
    const auto& corners = in_.corners[t];
    return {place(corners[a]), place(corners[b]), place(corners[c])};
  }
  [[nodiscard]] Vector3<Number> old_centre(std::span<const Point3> points, TetId t) const {
    const auto& c = in_.corners[t];
    const Point3& o = points[c[0].index()];
    const auto arm = [&](unsigned i) { return difference<Number>(points[c[i].index()], o); };
    return plus(arms_[place(c[0])], circumcentre(arm(1), arm(2), arm(3)));
  }

  /// Add the cone from v over the triangle (from, to, m), counter-clockwise as seen from outside of what v loses, where m
  /// is the middle between v and w (maybe p): half as large as that with w itself.
  void add(std::size_t v, const Vector3<Number>& w, const Vector3<Number>& from, const Vector3<Number>& to) {
    const Vector3<Number>& apex = arms_[v];
    volumes_[v] += volume6(minus(from, apex), minus(to, apex), minus(w, apex));
  }

  /// A face a, b, c is crossed outwards on the way counter-clockwise about a -> b, as seen from b, and also about b -> c
  /// and c -> a: that is the way about the face between the cells of a and b in which a sees it from within.
  void add_crossing(const std::array<std::size_t, 3>& face, const Vector3<Number>& from,
                    const Vector3<Number>& to) {
    for (unsigned i = 0; i < 3; ++i) {
      const std::size_t a = face[i], b = face[(i + 1) % 3];
      add(a, arms_[b], from, to);
    }
  }
  void add_faces_within() {
    const auto tets = zone_.tets();
    auto wall = zone_.walls().begin();
    for (std::size_t k = 0; k < tets.size(); ++k)
      for (unsigned i = 0; i < 4; ++i) {
        if (wall != zone_.walls().end() && wall->inner == tets[k] && wall->face == i) {
          ++wall;
          continue;
        }
        const std::size_t behind = place(*in_.neighbours[tets[k]][i]);
        add_crossing(corners_of(tets[k], i), old_centres_[k], old_centres_[behind]);
      }
  }
  /// Out of the zone through a wall, and in again: the same face from the other side.
  void add_walls() {
    for (std::size_t k = 0; k < zone_.walls().size(); ++k) {
      const TetConflictZone::Wall& wall = zone_.walls()[k];
      const auto [a, b, c] = corners_of(wall.inner, wall.face);
      const Vector3<Number>&inner = old_centres_[place(wall.inner)], &outer = new_centres_[k];
      add_crossing({a, b, c}, inner, outer);
      add_crossing({a, c, b}, outer, inner);
    }
  }
  /// From the cone over one wall to that over the next, and back on the bisector with p.
  void add_edges_of_walls() {
    struct Edge {
      std::array<std::size_t, 2> ends;
      std::size_t wall;
      bool reversed;
    };
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < zone_.walls().size(); ++k) {
      const auto face = corners_of(zone_.walls()[k].inner, zone_.walls()[k].face);
      for (unsigned i = 0; i < 3; ++i) {
        const std::size_t a = face[i], b = face[(i + 1) % 3];
        edges.push_back({{std::min(a, b), std::max(a, b)}, k, a > b});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) {
      return e.ends != f.ends ? e.ends < f.ends : e.reversed < f.reversed;
    });
    const Vector3<Number> origin{Number(0), Number(0), Number(0)};
    for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
      const auto [a, b] =
          edges[k].ends;  // edges[k] runs from a to b about its wall, the other one from b to a
      const Vector3<Number>&leave = new_centres_[edges[k].wall], &enter = new_centres_[edges[k + 1].wall];
      add(a, arms_[b], leave, enter);
      add(a, origin, enter, leave);
      add(b, arms_[a], enter, leave);
      add(b, origin, leave, enter);
    }
  }

  const GhostTetrahedralization& in_;
  const TetConflictZone& zone_;
  const std::vector<VertexWeight>& corners_;  // vertices in rising order
  std::vector<Vector3<Number>> arms_, old_centres_, new_centres_;
  std::vector<Number> volumes_;
};

/// What the corners of the zone's ghosts lose to p in the plane of these, times two as seen along an axis; p is the origin.
template <class Number>
class StolenAreasOnHull {
 public:
  StolenAreasOnHull(const GhostTetrahedralization& in, std::span<const Point3> points,
                    const TetConflictZone& zone, const std::vector<VertexWeight>& corners, const Point3& p)
      : areas_(corners.size(), Number(0)), into_(corners.size()), out_of_(corners.size()) {
    for (const auto& [v, weight] : corners) arms_.push_back(difference<Number>(points[v.index()], p));
    const auto tets = zone.tets();
    std::vector<TetId> ghosts;
    for (const TetId t : tets)
      if (in.is_ghost(t)) ghosts.push_back(t);
    std::vector<Vector3<Number>> old_centres;
    for (const TetId t : ghosts) {
      const auto& c = in.corners[t];
      const Point3& o = points[c[1].index()];
      const Vector3<Number> u = difference<Number>(points[c[2].index()], o),
                            v = difference<Number>(points[c[3].index()], o);
      if (old_centres.empty()) choose_axis(cross(u, v));
      old_centres.push_back(plus(arms_[place_of(c[1], corners)], circumcentre(u, v)));
    }
    for (std::size_t k = 0; k < ghosts.size(); ++k) {
      // Corners of the ghost other than the ghost, counter-clockwise as seen from outside.
      constexpr std::array<unsigned, 3> around{1, 3, 2};
      const auto& c = in.corners[ghosts[k]];
      for (unsigned i = 0; i < 3; ++i) {
        const std::size_t a = place_of(c[around[i]], corners), b = place_of(c[around[(i + 1) % 3]], corners);
        const TetId behind = *in.neighbours[ghosts[k]][around[(i + 2) % 3]];
        const auto other = std::lower_bound(ghosts.begin(), ghosts.end(), behind);
        if (other != ghosts.end() && *other == behind) {
          add(a, old_centres[static_cast<std::size_t>(other - ghosts.begin())], old_centres[k]);
          continue;
        }
        const Vector3<Number> new_centre = circumcentre(arms_[a], arms_[b]);
        add(a, new_centre, old_centres[k]);
        add(b, old_centres[k], new_centre);
        out_of_[a] = into_[b] = new_centre;
      }
    }
    for (std::size_t v = 0; v < corners.size(); ++v) add(v, into_[v], out_of_[v]);
  }
  [[nodiscard]] const std::vector<Number>& areas() const { return areas_; }

 private:
  void choose_axis(const Vector3<Number>& normal) {
    const Number x = magnitude_of(normal.x), y = magnitude_of(normal.y), z = magnitude_of(normal.z);
    axis_ = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }
  /// A side of what v loses, counter-clockwise.
  void add(std::size_t v, const Vector3<Number>& from, const Vector3<Number>& to) {
    const Vector3<Number> area = cross(minus(from, arms_[v]), minus(to, arms_[v]));
    areas_[v] += axis_ == 0 ? area.x : axis_ == 1 ? area.y : area.z;
  }

  std::vector<Vector3<Number>> arms_;  // one a corner, as all that follow
  std::vector<Number> areas_;
  std::vector<Vector3<Number>> into_,
      out_of_;  // of the border's edge that ends in a corner, and of that which starts there
  unsigned axis_ = 0;
};

/// One weight a vertex, in rising order of these.
void make_distinct(std::vector<VertexWeight>& weights) {
  const auto before = [](const VertexWeight& a, const VertexWeight& b) { return a.vertex < b.vertex; };
  std::sort(weights.begin(), weights.end(), before);
  weights.erase(std::unique(weights.begin(), weights.end()), weights.end());
}

}  // namespace

void barycentric_weights(std::span<const Point3> points, const TetLocation& at, const Point3& p,
                         std::vector<VertexWeight>& weights) {
  weights.clear();
  for (const MaybeId<VertexId> v : at.vertices)
    if (v) weights.push_back({*v, 0});
  const auto corner = [&](std::size_t i) -> const Point3& { return points[weights[i].vertex.index()]; };
  switch (at.kind) {
    case TetLocationKind::on_vertex:
      weights.front().weight = 1;
      return;
    case TetLocationKind::on_edge:
      return weigh_by_shares(
          points, p, [&]<class Number>(Number) { return edge_shares<Number>(corner(0), corner(1), p); },
          weights);
    case TetLocationKind::on_face:
      return weigh_by_shares(
          points, p,
          [&]<class Number>(Number) {
            return face_shares<Number>({corner(0), corner(1), corner(2)}, p);
          },
          weights);
    case TetLocationKind::in_tetrahedron:
      return weigh_by_shares(
          points, p,
          [&]<class Number>(Number) {
            return tet_shares<Number>({corner(0), corner(1), corner(2), corner(3)}, p);
          },
          weights);
    case TetLocationKind::in_span:
    case TetLocationKind::outside:
      return;
  }
}

void sibson_weights(const GhostTetrahedralization& in, std::span<const Point3> points,
                    const TetConflictZone& zone, const Point3& p, std::vector<VertexWeight>& weights) {
  weights.clear();
  for (const TetId t : zone.tets())
    for (const VertexId v : in.corners[t]) weights.push_back({v, 0});
  make_distinct(weights);
  const auto volumes = [&]<class Number>(Number) {
    return StolenVolumes<Number>(in, points, zone, weights, p).volumes();
  };
  weigh_by_shares(points, p, volumes, weights);
}

void sibson_weights_on_hull(const GhostTetrahedralization& in, std::span<const Point3> points,
                            const TetConflictZone& zone, const Point3& p,
                            std::vector<VertexWeight>& weights) {
  weights.clear();
  for (const TetId t : zone.tets())
    for (unsigned i = 1; in.is_ghost(t) && i < 4; ++i) weights.push_back({in.corners[t][i], 0});
  make_distinct(weights);
  const auto areas = [&]<class Number>(Number) {
    return StolenAreasOnHull<Number>(in, points, zone, weights, p).areas();
  };
  weigh_by_shares(points, p, areas, weights);
}

}  // namespace leonhard::delaunay
