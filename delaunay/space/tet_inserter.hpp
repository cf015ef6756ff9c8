// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "leonhard/delaunay/support/scratch_stack.hpp"
#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/delaunay/topology/tet_arena.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// Vertices begin <= v < end; points being sorted along a curve, these are points near one another.
struct VertexRange {
  IdRaw begin = 0, end = 0;
  [[nodiscard]] bool contains(VertexId v) const { return v.raw - begin < end - begin; }
};

/// Inserts points into a Delaunay tetrahedralisation, one cavity after another (Bowyer, Watson 1981): the tetrahedra whose
/// circumspheres hold the point, ties broken by kernel::insphere_perturbed, make room for those that join the point to
/// the cavity's walls. The circumsphere of a ghost tetrahedron is the open half space beyond its hull face, and the
/// inside of the face's circumcircle.
///
/// Several inserters may work at once on one arena if their ranges are disjoint. An inserter reads and deletes
/// tetrahedra with four vertices of its own alone (the ghost counts as everybody's), reads their neighbours, which
/// nobody else can delete since they have three vertices of its own, and writes the link back and marks into these. A
/// point for which that is not enough is left to be inserted later. (The filter loads a node as a whole, notes that
/// another inserter may be writing included, and throws the notes away.)
class TetInserter {
 public:
  /// owned  all vertices, or a part of them for one of several inserters at a time
  /// hint   a real tetrahedron of owned vertices, for the first walk to start from
  TetInserter(TetArena& arena, VertexRange owned, TetId hint);

  /// Numbers first to last - 1, dead, are this inserter's to use. Without any the arena grows, which only one inserter at
  /// a time may let it do.
  void give_numbers(TetId first, TetId last);

  /// Insert a point that is not yet a vertex. False, and nothing changed: its cavity or the walk to it leaves what the
  /// inserter owns, or the numbers given are used up.
  [[nodiscard]] bool insert(VertexId v);

  /// Go to the tetrahedron that holds a point, whoever owns what lies between. For hints.
  void walk_to(const Point3& p);

  /// A real tetrahedron at the point inserted last, from which the next walk starts.
  [[nodiscard]] TetId hint() const { return hint_; }
  /// Start the next walk from t, an earlier hint of this inserter, if there still is a real tetrahedron of that number.
  void go_to(TetId t);
  /// Give all unused numbers back to the arena.
  void return_numbers();

  [[nodiscard]] bool is_owned(TetId t) const;

 private:
  /// A face between a tetrahedron of the cavity and one that was asked, and with that a wall unless it dies as well.
  struct Face {
    TetId outside;
    std::uint32_t place;  ///< 4 i + j: face j of the cavity's tetrahedron i
  };
  /// A face between the cavity and a tetrahedron that stays.
  struct Wall {
    std::array<VertexId, 4> corners;     ///< of the tetrahedron to come: the face, then the point
    std::array<std::uint32_t, 3> local;  ///< numbers of the face's corners on the boundary
    TetId made;                          ///< the tetrahedron to come
    TetId outside;
    std::uint32_t twin_face;  ///< which face of the one outside
  };

  template <bool restricted>
  [[nodiscard]] MaybeId<TetId> walk(const Point3& p);
  [[nodiscard]] bool in_conflict(TetId t, const Point3& p) const;
  template <bool restricted>
  [[nodiscard]] bool open_cavity(TetId t, VertexId v);
  void list_faces(std::size_t begin);
  void ask(std::size_t begin, const Point3& p);
  template <bool restricted>
  [[nodiscard]] bool doom(std::size_t begin, const Point3& p);
  void list_walls(VertexId v);
  void close_again();
  [[nodiscard]] bool find_numbers();
  void fill();
  void number_walls();
  void link_by_table(std::size_t vertices);
  void link_by_sorting();

  TetArena& arena_;
  const kernel::SpheresFilter spheres_;
  VertexRange owned_;
  bool restricted_;
  TetId hint_;
  IdRaw next_number_ = 0, end_of_numbers_ = 0;
  std::vector<TetId> free_numbers_;
  ScratchStack<TetId> cavity_;
  ScratchStack<Face> faces_;
  ScratchStack<Wall> walls_;
  ScratchStack<TetId> asked_;                 ///< whether they are in conflict, doomed ones and others
  std::vector<std::uint32_t> asked_corners_;  ///< four each of a layer's
  std::vector<Sign> answers_;
  std::vector<TetId> table_;  ///< of pairs of numbers on the boundary
  Coin coin_;
};

}  // namespace leonhard::delaunay
