// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "leonhard/kernel/double_double.hpp"
#include "leonhard/mesh/ids_in_range.hpp"

namespace leonhard::mesh {
namespace {

using kernel::DoubleDouble;

constexpr double degrees = 180.0 / std::numbers::pi;

// ---- arithmetic in doubles and in double-doubles alike ----

template <class Number>
struct Vector {
  Number x, y, z;
};

template <class Number>
Vector<Number> operator+(const Vector<Number>& u, const Vector<Number>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <class Number>
Vector<Number> operator*(const Number& s, const Vector<Number>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <class Number>
Number dot(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class Number>
Vector<Number> cross(const Vector<Number>& u, const Vector<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

double rounded(double x) { return x; }
double rounded(DoubleDouble x) { return x.high; }
template <class Number>
Vec3 rounded(const Vector<Number>& v) {
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

// ---- scaled edges ----

/// The corners of a tetrahedron, whose edges are asked for in units of 2^exponent, so that the largest coordinate of an
/// edge is between 1 and 2.
class ScaledTet {
 public:
  explicit ScaledTet(const std::array<Point3, 4>& corners) : p_(corners) {
    // A quarter of each coordinate first where the difference of two may overflow.
    const bool large = std::any_of(p_.begin(), p_.end(), [](const Point3& q) {
      return std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}) >
             0.25 * std::numeric_limits<double>::max();
    });
    if (large) {
      for (Point3& q : p_) q = {0.25 * q.x, 0.25 * q.y, 0.25 * q.z};
    }
    double size = 0;
    for (const auto& [i, j] : tet_edge_corners) {
      const Vec3 edge = p_[j] - p_[i];
      size = std::max({size, std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)});
    }
    const int exponent = size > 0 ? std::ilogb(size) : 0;
    first_ = std::ldexp(1.0, -exponent / 2);  // 2^-exponent may be no double, so it is two factors
    second_ = std::ldexp(1.0, -exponent + exponent / 2);
    exponent_ = exponent + (large ? 2 : 0);
  }
  [[nodiscard]] int exponent() const { return exponent_; }

  template <class Number>
  [[nodiscard]] Vector<Number> edge(std::size_t from, std::size_t to) const {
    return {difference<Number>(p_[to].x, p_[from].x), difference<Number>(p_[to].y, p_[from].y),
            difference<Number>(p_[to].z, p_[from].z)};
  }

 private:
  template <class Number>
  [[nodiscard]] Number difference(double to, double from) const {
    if constexpr (std::is_same_v<Number, double>) {
      return scaled(to - from);
    } else {
      const kernel::TwoTerms exact = kernel::two_difference(to, from);
      return Number{{scaled(exact.high), scaled(exact.low)}};
    }
  }
  [[nodiscard]] double scaled(double x) const { return x * first_ * second_; }

  std::array<Point3, 4> p_;
  double first_, second_;
  int exponent_;
};

double length(const Vec3& v) {
  const double square = dot(v, v);
  return square > 0x1p-900 ? std::sqrt(square) : norm(v);
}

/// What loses its digits where the tetrahedron is flat, of the scaled one.
struct Core {
  double volume6;
  std::array<Vec3, 4> normals;  ///< of the face opposite each corner, outwards, as long as twice its area
  Vec3 to_centre;               ///< from corner 0 to the circumcentre, times 2 volume6
};

template <class Number>
Core core_of(const ScaledTet& tet) {
  const auto u = tet.edge<Number>(0, 1), v = tet.edge<Number>(0, 2), w = tet.edge<Number>(0, 3);
  const auto vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const auto first = cross(tet.edge<Number>(1, 2), tet.edge<Number>(1, 3));
  Core core;
  core.volume6 = std::max(0.0, rounded(dot(u, vw)));
  core.normals = {rounded(first), -rounded(vw), -rounded(wu), -rounded(uv)};
  core.to_centre = rounded(dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv);
  return core;
}

struct Figures {
  TetQuality quality;
  std::array<double, 6> dihedrals_deg;  ///< in the order of tet_edge_corners
};

Figures figures_of(const std::array<Point3, 4>& corners) {
  const ScaledTet tet(corners);
  std::array<double, 6> lengths;
  for (std::size_t e = 0; e < 6; ++e)
    lengths[e] = length(rounded(tet.edge<double>(tet_edge_corners[e][0], tet_edge_corners[e][1])));
  Core core = core_of<double>(tet);
  const bool flat = core.volume6 < 1e-3 * lengths[0] * lengths[1] * lengths[2];
  if (flat) core = core_of<DoubleDouble>(tet);

  Figures figures;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [k, l] = tet_edge_corners[5 - e];  // the edge lies on the faces opposite these
    figures.dihedrals_deg[e] =
        degrees * std::atan2(lengths[e] * core.volume6, -dot(core.normals[k], core.normals[l]));
  }
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  const auto [smallest, largest] =
      std::minmax_element(figures.dihedrals_deg.begin(), figures.dihedrals_deg.end());
  double surface2 = 0;
  for (const Vec3& normal : core.normals) surface2 += length(normal);
  const double circumradius = length(core.to_centre) / (2 * core.volume6);

  TetQuality& q = figures.quality;
  q.min_dihedral_deg = *smallest;
  q.max_dihedral_deg = *largest;
  q.volume = std::ldexp(core.volume6 / 6, 3 * tet.exponent());
  q.shortest_edge = std::ldexp(*shortest, tet.exponent());
  q.longest_edge = std::ldexp(*longest, tet.exponent());
  q.aspect_ratio = circumradius * surface2 / (3 * core.volume6);
  q.radius_edge_ratio = circumradius / *shortest;
  return figures;
}

std::array<Point3, 4> corner_points(const TetMesh& mesh, TetId t) {
  const auto& [a, b, c, d] = mesh.corners[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]};
}

Point3 centroid(const std::array<Point3, 4>& p) {
  const auto mean = [&](double Point3::*x) { return p[0].*x / 4 + p[1].*x / 4 + p[2].*x / 4 + p[3].*x / 4; };
  return {mean(&Point3::x), mean(&Point3::y), mean(&Point3::z)};
}

/// What has to be kept of each tetrahedron until all are seen.
struct Kept {
  double min_dihedral_deg, volume;
};

/// The `count` tetrahedra of smallest angle, the smallest first, ties by id.
std::vector<TetMeshQuality::Named> worst_tets(const TetMesh& mesh, const PerId<TetId, Kept>& kept,
                                              std::size_t count) {
  std::vector<TetId> ids(kept.ids().begin(), kept.ids().end());
  const auto middle = ids.begin() + static_cast<std::ptrdiff_t>(std::min(count, ids.size()));
  std::partial_sort(ids.begin(), middle, ids.end(), [&](TetId s, TetId t) {
    const double a = kept[s].min_dihedral_deg, b = kept[t].min_dihedral_deg;
    return a != b ? a < b : s < t;
  });
  std::vector<TetMeshQuality::Named> worst;
  for (auto at = ids.begin(); at != middle; ++at) {
    const auto corners = corner_points(mesh, *at);
    worst.push_back({*at, centroid(corners), figures_of(corners).quality});
  }
  return worst;
}

/// Largest growth of size across a face, each pair seen once.
void find_growth(const TetMesh& mesh, const PerId<TetId, Kept>& kept, TetMeshQuality& q) {
  double largest = 1;  // ratio of volumes
  for (const TetId t : mesh.neighbours.ids()) {
    for (const MaybeId<TetId> neighbour : mesh.neighbours[t]) {
      if (!neighbour || *neighbour < t) continue;
      const bool t_is_smaller = kept[t].volume <= kept[*neighbour].volume;
      const TetId small = t_is_smaller ? t : *neighbour, large = t_is_smaller ? *neighbour : t;
      const double ratio = kept[large].volume / kept[small].volume;
      if (ratio > largest) {
        largest = ratio;
        q.fastest_growth = {small, large};
      }
    }
  }
  q.max_size_growth = std::cbrt(largest);
}

void take_extremes(TetMeshQuality& q, const TetQuality& f) {
  q.min_dihedral_deg = std::min(q.min_dihedral_deg, f.min_dihedral_deg);
  q.max_dihedral_deg = std::max(q.max_dihedral_deg, f.max_dihedral_deg);
  q.min_volume = std::min(q.min_volume, f.volume);
  q.max_volume = std::max(q.max_volume, f.volume);
  q.shortest_edge = std::min(q.shortest_edge, f.shortest_edge);
  q.longest_edge = std::max(q.longest_edge, f.longest_edge);
  q.max_aspect_ratio = std::max(q.max_aspect_ratio, f.aspect_ratio);
  q.max_radius_edge_ratio = std::max(q.max_radius_edge_ratio, f.radius_edge_ratio);
}

}  // namespace

TetQuality tet_quality(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return figures_of({a, b, c, d}).quality;
}

TetMeshQuality quality(const TetMesh& mesh, std::size_t worst_count) {
  require_ids_in_range(mesh);
  TetMeshQuality q;
  if (mesh.corners.empty()) return q;
  q.min_dihedral_deg = 180;
  q.min_volume = q.shortest_edge = std::numeric_limits<double>::infinity();

  PerId<TetId, Kept> kept(mesh.tet_count());
  for (const TetId t : mesh.corners.ids()) {
    const Figures figures = figures_of(corner_points(mesh, t));
    for (const double angle : figures.dihedrals_deg) {
      ++q.dihedral_histogram[std::min<std::size_t>(static_cast<std::size_t>(angle / 10),
                                                   q.dihedral_histogram.size() - 1)];
    }
    const TetQuality& f = figures.quality;
    kept[t] = {f.min_dihedral_deg, f.volume};
    take_extremes(q, f);
    q.mean_min_dihedral_deg += f.min_dihedral_deg;
    q.total_volume += f.volume;
  }
  const auto count = static_cast<double>(mesh.tet_count());
  q.mean_min_dihedral_deg /= count;
  q.mean_volume = q.total_volume / count;
  find_growth(mesh, kept, q);
  q.worst = worst_tets(mesh, kept, worst_count);
  return q;
}

}  // namespace leonhard::mesh
