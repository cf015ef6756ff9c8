// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

#include "leonhard/delaunay/constrained/constrained_triangulation.hpp"
#include "leonhard/delaunay/constrained/input_angles.hpp"
#include "leonhard/delaunay/plane/triangle_bounds.hpp"
#include "leonhard/delaunay/refine_options.hpp"
#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// Delaunay refinement of a carved constrained Delaunay triangulation, in place.
///
/// Two queues: pieces of segments to split (encroached or too long), longest first, and triangles that miss a
/// bound, those with the shortest edges first (as Üngör advises: fewest vertices); pieces take precedence. All ties are broken by coordinates, so that the numbering of
/// vertices and triangles does not enter.
class Refiner {
 public:
  /// region_areas  area bound of each region, not positive: none
  Refiner(ConstrainedTriangulation& cells, const RefineOptions& options, std::vector<double> region_areas);

  /// Refine until nothing is left to do, the budget is spent or a stop is requested; then fill the report, all but
  /// its repairs.
  void run(RefineReport& report);

 private:
  /// Why a triangle that misses a bound, or a piece that should be split, stays.
  enum class Excuse : std::uint8_t { none, small_input_angle, min_edge, rounding };

  struct PieceTask {
    double length2;
    Point2 low, high;  // its ends, for ties
    PieceId piece;
    VertexId from, to;  // still its ends, or the task is out of date
    bool operator<(const PieceTask& other) const;
  };
  struct TriangleTask {
    double shortest2;  // squared length of its shortest edge
    TriangleBounds::Miss miss;
    AnyTriangleId triangle;
    std::array<VertexId, 3> corners;  // still its corners, or the task is out of date
  };
  struct TriangleTaskOrder {
    const ConstrainedTriangulation* cells;
    bool operator()(const TriangleTask& a, const TriangleTask& b) const;
  };
  /// Where a vertex is wanted: in a triangle, on a side, at a vertex, or behind a piece.
  struct Site {
    enum class Kind { in_triangle, on_side, taken, blocked } kind;
    SideId side;  ///< of that triangle, that side, or that piece
  };
  /// A piece as it came: between input vertices.
  struct Chain {
    VertexId from, to;
  };

  [[nodiscard]] CornerPoints corners_of(AnyTriangleId t) const;
  [[nodiscard]] double region_area(AnyTriangleId t) const;
  [[nodiscard]] bool is_real(SideId s) const { return !topology_.is_ghost(topology_.triangle(s)); }

  void enqueue_all();
  void enqueue(AnyTriangleId t);
  void enqueue(PieceId p);
  void enqueue_if_needed(PieceId p);
  [[nodiscard]] bool encroaches(Point2 v, const Piece& piece) const;
  [[nodiscard]] bool too_long(const Piece& piece) const;

  void treat(const TriangleTask& task);
  [[nodiscard]] Excuse try_to_remove(const TriangleTask& task);
  [[nodiscard]] bool spans_equal_shells(AnyTriangleId t, const CornerPoints& corners,
                                        const Shape& shape) const;
  [[nodiscard]] double reach(const CornerPoints& t, const Shape& shape,
                             const TriangleBounds::Miss& miss) const;
  [[nodiscard]] Site find_site(AnyTriangleId from, Point2 p) const;
  [[nodiscard]] bool lexicographically_first(SideId s, SideId t) const;
  void grow_cavity(Point2 p);
  [[nodiscard]] bool too_close(Point2 p) const;

  void split(const PieceTask& task);
  [[nodiscard]] Point2 split_site(const Piece& piece) const;
  [[nodiscard]] bool can_split_at(const Piece& piece, Point2 m) const;

  void enqueue_fan(VertexId v);
  void account(RefineReport& report) const;

  ConstrainedTriangulation& cells_;
  const GhostTriangulation& topology_;
  const RefineOptions& options_;
  TriangleBounds bounds_;
  InputAngles angles_;
  std::vector<double> region_areas_;
  double angle_reach_;   // off_centre_reach of the angle bound; infinite without
  double lens_cosine2_;  // squared cosine of the angle over a piece at the rim of its lens

  static constexpr std::uint32_t no_chain = 0xffffffff;
  std::vector<Chain> chains_;
  PerId<PieceId, std::uint32_t> chain_of_piece_;
  PerId<VertexId, std::uint32_t> chain_of_vertex_;  // of vertices added on a segment; no_chain for others

  std::priority_queue<PieceTask> piece_tasks_;
  std::priority_queue<TriangleTask, std::vector<TriangleTask>, TriangleTaskOrder> triangle_tasks_;
  PerId<PieceId, Excuse> piece_excuse_;
  std::vector<Excuse> triangle_excuse_;  // by triangle; grows with them
  std::size_t vertex_count_ = 0;
  std::size_t inserted_ = 0, segment_splits_ = 0, rounded_splits_ = 0;
  Cavity cavity_;
};

}  // namespace leonhard::delaunay
