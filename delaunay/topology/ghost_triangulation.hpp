// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// A triangle of a GhostTriangulation, real or a ghost. Not a TriangleId: a mesh has real triangles only, with numbers of
/// its own.
using AnyTriangleId = Id<struct AnyTriangleTag>;

/// Side i of triangle t has number 4 t + i, i < 3, and lies opposite corner i.
using SideId = Id<struct TriangulationSideTag>;

/// A triangulation of the sphere as pure combinatorics: no coordinates. One vertex may be the ghost: it stands for
/// all that lies outside, so that every side has a triangle behind it. A ghost triangle (ghost, a, b) lies behind
/// the outer edge b -> a of a real triangle; its corner 0 is the ghost. Where the domain has several boundaries,
/// each of them has its own ring of ghost triangles about the one ghost.
///
/// 24 bytes a triangle: three corners, counter-clockwise, and three twin sides.
class GhostTriangulation {
 public:
  static constexpr VertexId ghost{std::numeric_limits<IdRaw>::max() - 1};

  GhostTriangulation() = default;
  /// That many triangles, yet without corners: for algorithms that know each triangle's number beforehand.
  explicit GhostTriangulation(std::size_t triangles)
      : corners_(large_vector<std::array<VertexId, 3>>(triangles)),
        twins_(large_vector<SideId>(3 * triangles)) {}

  [[nodiscard]] static SideId side(AnyTriangleId t, unsigned i) { return SideId{4 * t.raw + i}; }
  [[nodiscard]] static AnyTriangleId triangle(SideId s) { return AnyTriangleId{s.raw >> 2}; }
  /// Which side of its triangle it is: 0, 1 or 2.
  [[nodiscard]] static unsigned number(SideId s) { return static_cast<unsigned>(s.raw & 3); }
  [[nodiscard]] static SideId next(SideId s) { return SideId{number(s) == 2 ? s.raw - 2 : s.raw + 1}; }
  [[nodiscard]] static SideId previous(SideId s) { return SideId{number(s) == 0 ? s.raw + 2 : s.raw - 1}; }
  /// Its place in an array of three entries a triangle: 3 t + i.
  [[nodiscard]] static std::size_t slot(SideId s) { return s.index() - (s.index() >> 2); }
  /// "side 1 of triangle 7", for messages.
  [[nodiscard]] static std::string name(SideId s);

  [[nodiscard]] std::size_t triangle_count() const { return corners_.size(); }  ///< ghosts included
  [[nodiscard]] IdRange<AnyTriangleId> triangles() const { return IdRange<AnyTriangleId>(triangle_count()); }
  [[nodiscard]] VertexId corner(AnyTriangleId t, unsigned i) const { return corners_[t.index()][i]; }
  /// The corner that the side lies opposite to.
  [[nodiscard]] VertexId apex(SideId s) const { return corners_[triangle(s).index()][number(s)]; }
  /// A side runs from its origin to its destination, its triangle on the left.
  [[nodiscard]] VertexId origin(SideId s) const { return apex(next(s)); }
  [[nodiscard]] VertexId destination(SideId s) const { return apex(previous(s)); }
  /// The same edge seen from the other triangle, running the other way.
  [[nodiscard]] SideId twin(SideId s) const { return twins_[slot(s)]; }
  [[nodiscard]] bool is_ghost(AnyTriangleId t) const { return corners_[t.index()][0] == ghost; }
  /// The next side counter-clockwise about the common origin.
  [[nodiscard]] SideId turn_about_origin(SideId s) const { return twin(previous(s)); }

  void reserve(std::size_t triangles) {
    corners_.reserve(triangles);
    twins_.reserve(3 * triangles);
  }
  /// A new triangle, counter-clockwise, not yet linked. The ghost, if any, must come first.
  AnyTriangleId add(VertexId a, VertexId b, VertexId c) {
    corners_.push_back({a, b, c});
    twins_.resize(3 * corners_.size());
    return AnyTriangleId::from(triangle_count() - 1);
  }
  void set_corners(AnyTriangleId t, VertexId a, VertexId b, VertexId c) { corners_[t.index()] = {a, b, c}; }
  void set_corner(AnyTriangleId t, unsigned i, VertexId v) { corners_[t.index()][i] = v; }
  void link(SideId s, SideId t) {
    twins_[slot(s)] = t;
    twins_[slot(t)] = s;
  }

  /// Take away a triangle to which no side is linked any more. The last triangle takes its number.
  void erase(AnyTriangleId t);

  /// The first triangle, counter-clockwise, with its three ghosts. The triangulation must be empty.
  void start(VertexId a, VertexId b, VertexId c) {
    corners_.resize(4);
    twins_.resize(12);
    set_first_triangle(AnyTriangleId{0}, a, b, c);
  }
  /// The same in the place of t and the three triangles after it.
  void set_first_triangle(AnyTriangleId t, VertexId a, VertexId b, VertexId c);
  /// Vertex v becomes number_of[v]; the ghost stays.
  void renumber_vertices(std::span<const std::uint32_t> number_of);

  /// Replace the diagonal s of a quadrilateral of real triangles by the other one. Afterwards s and its twin are
  /// other sides; the sides around are renumbered as told.
  struct Flipped {
    SideId diagonal;  ///< the new diagonal, one of its two sides
    std::array<std::pair<SideId, SideId>, 4>
        moved;  ///< outer sides of the quadrilateral: old number, new number
  };
  Flipped flip(SideId s);

  /// The corners of all triangles; nothing of the triangulation stays.
  [[nodiscard]] std::vector<std::array<VertexId, 3>> take_corners() && {
    release(twins_);
    return std::move(corners_);
  }

  /// The first broken invariant in words: twins that do not point back or do not share their ends, a repeated
  /// corner, a ghost elsewhere than at corner 0. Cost O(triangles).
  [[nodiscard]] std::optional<std::string> validate() const;

 private:
  std::vector<std::array<VertexId, 3>> corners_;
  std::vector<SideId> twins_;
};

}  // namespace leonhard::delaunay
