// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "leonhard/delaunay/location.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// What an insertion did.
struct Inserted {
  VertexId vertex;
  bool is_new;  ///< false: the vertex was there, at the same coordinates (-0 equal to +0)
};

enum class MoveOutcome {
  moved,     ///< the vertex is at the new place, maybe the one where it was
  occupied,  ///< another vertex is there; nothing changed
};
/// The word for it, e.g. "moved".
[[nodiscard]] constexpr std::string_view to_string(MoveOutcome outcome) {
  switch (outcome) {
    case MoveOutcome::moved:
      return "moved";
    case MoveOutcome::occupied:
      return "occupied";
  }
  return "";
}

struct [[nodiscard]] Moved {
  MoveOutcome outcome;
  VertexId vertex;  ///< at the place: the one that moved, or the other one
};

/// The calls that DynamicTriangulation and DynamicTetrahedralization share, one text for both.
///
/// Queries do not change anything, not even unseen, so any number of threads may query at once. A hint is any vertex
/// thought to be near; it changes the time alone, and one that does not live is ignored. A walk that does not arrive
/// soon starts again from the nearest of some vertices drawn at random ("jump and walk": Mücke, Saias and Zhu, SoCG
/// 1996): for n points spread evenly expected O(n^(1/3)) in the plane and O(n^(1/4)) in space, O(1) from a near hint.
/// Without a hint it starts from where something was changed last.
///
/// throws  InputError on a point that is not finite, before anything changed
///
/// Sites      the class derived from this one
/// PointT     what it holds
/// LocationT  its answer to locate
template <class Sites, class PointT, class LocationT>
class DynamicQueries {
 public:
  /// Bring a vertex to another place; it keeps its id.
  ///
  /// throws  InputError for a vertex that does not live and for a place that is not finite, nothing changed
  /// Cost: that of remove, and of an insertion near the place left.
  Moved move(VertexId v, const PointT& to);

  [[nodiscard]] LocationT locate(const PointT& p, MaybeId<VertexId> hint = {}) const;
  /// The vertex nearest to p by exact comparison, of several equally near the lexicographically first; none if there is
  /// no vertex. Cost: that of locate and some vertices' neighbours; O(n) in space while all vertices lie in one plane.
  [[nodiscard]] MaybeId<VertexId> nearest_vertex(const PointT& p, MaybeId<VertexId> hint = {}) const;
  /// The k vertices nearest to p, nearest first, equally near ones in lexicographic order; all vertices if there are no
  /// more than k. Each but the first has a neighbour before it in this order, so a search from the nearest finds them.
  /// Cost: that of nearest_vertex and O(k log k) exact comparisons; O(n log n) in space while all vertices are coplanar.
  [[nodiscard]] std::vector<VertexId> k_nearest_vertices(const PointT& p, std::size_t k,
                                                         MaybeId<VertexId> hint = {}) const;
  /// Sibson's weights: the shares of the Voronoi cell that p would have if it were inserted, by the cells that they are
  /// cut from. On a vertex that vertex alone. On the hull, and on a line, where that cell would have no bound: linear
  /// between the ends of an edge (the limit from within), and in space Sibson's weights by areas within a plane of the hull.
  ///
  /// Method: R. Sibson, "A brief description of natural neighbour interpolation" (1981). Weights are evaluated in floating
  /// point and, where the combination misses p by more than 2^-33 of the distances that it sums, in rational numbers.
  /// Cost: that of insert.
  [[nodiscard]] WeightsAt<LocationT> natural_neighbours(const PointT& p, MaybeId<VertexId> hint = {}) const;
  /// The value at p of the function that is linear on each triangle (tetrahedron; edge of a line in the plane).
  ///
  /// values  one an id, values[v.index()] that of v; InputError if there are fewer than id_bound()
  [[nodiscard]] ValueAt<LocationT> interpolate_linear(const PointT& p, std::span<const double> values,
                                                      MaybeId<VertexId> hint = {}) const;
  /// The sum of the values times natural_neighbours(p).weights: continuous, smooth within the hull but at the
  /// vertices, and exact for linear functions.
  [[nodiscard]] ValueAt<LocationT> interpolate_natural_neighbour(const PointT& p,
                                                                 std::span<const double> values,
                                                                 MaybeId<VertexId> hint = {}) const;

  // ---- Many queries at once ----
  //
  // The answers in the order of the points, equal to those of single queries. Points are visited along a Hilbert curve,
  // each walk starting where the last one ended, in blocks that threads share; threads 0: as many as there are cores.

  [[nodiscard]] std::vector<LocationT> locate(std::span<const PointT> points, unsigned threads = 0) const;
  [[nodiscard]] std::vector<MaybeId<VertexId>> nearest_vertices(std::span<const PointT> points,
                                                                unsigned threads = 0) const;
  [[nodiscard]] std::vector<ValueAt<LocationT>> interpolate_linear(std::span<const PointT> points,
                                                                   std::span<const double> values,
                                                                   unsigned threads = 0) const;
  [[nodiscard]] std::vector<ValueAt<LocationT>> interpolate_natural_neighbour(std::span<const PointT> points,
                                                                              std::span<const double> values,
                                                                              unsigned threads = 0) const;

 protected:
  DynamicQueries() = default;

 private:
  [[nodiscard]] const Sites& sites() const { return static_cast<const Sites&>(*this); }
  void require_values(std::span<const double> values) const;
};

}  // namespace leonhard::delaunay
