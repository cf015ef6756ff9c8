// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tet_inserter.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

using Mark = TetArena::Mark;
constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// Which face of a tetrahedron lies next to `other`, which is one of its neighbours.
unsigned face_towards(const std::array<MaybeId<TetId>, 4>& neighbours, TetId other) {
  const MaybeId<TetId> behind(other);
  return neighbours[1] == behind ? 1U : neighbours[2] == behind ? 2U : neighbours[3] == behind ? 3U : 0U;
}

/// On walls of up to 4^4 vertices new tetrahedra find one another through a table of all pairs of vertices.
constexpr std::size_t largest_table = 256;

}  // namespace

TetInserter::TetInserter(TetArena& arena, VertexRange owned, TetId hint)
    : arena_(arena), owned_(owned), restricted_(owned.end - owned.begin < arena.nodes.size()), hint_(hint) {
  if (!restricted_) free_numbers_ = std::exchange(arena.free_numbers, {});
}

void TetInserter::give_numbers(TetId first, TetId last) {
  next_number_ = first.raw;
  end_of_numbers_ = last.raw;
}

void TetInserter::return_numbers() {
  auto& free = arena_.free_numbers;
  free.insert(free.end(), free_numbers_.begin(), free_numbers_.end());
  free_numbers_.clear();
  while (next_number_ < end_of_numbers_) free.push_back(TetId{next_number_++});
}

bool TetInserter::is_owned(TetId t) const {
  const auto& c = arena_.cells.corners[t];
  return owned_.contains(c[1]) && owned_.contains(c[2]) && owned_.contains(c[3]) &&
         (c[0] == ghost || owned_.contains(c[0]));
}

// ---- the walk ----

/// A remembering visibility walk (Devillers, Pion and Teillaud 2002): to the tetrahedron that holds p, or to a ghost
/// whose hull face has p strictly beyond it. In a Delaunay tetrahedralisation it never goes round in a circle.
template <bool restricted>
MaybeId<TetId> TetInserter::walk(const Point3& p) {
  const auto& cells = arena_.cells;
  TetId t = hint_;
  if (restricted && !is_owned(t)) return {};
  unsigned entered = 4;
  while (true) {
    const auto& c = cells.corners[t];
    std::array<const Point3*, 4> corners;
    for (unsigned i = 0; i < 4; ++i) corners[i] = &arena_.nodes[c[i].index()].point;
    unsigned face = 0;
    for (; face < 4; ++face) {
      if (face == entered) continue;
      std::array<const Point3*, 4> q = corners;
      q[face] = &p;
      if (kernel::orient3d(*q[0], *q[1], *q[2], *q[3]) == Sign::negative) break;
    }
    if (face == 4) return t;
    const TetId next = *cells.neighbours[t][face];
    if (restricted && !is_owned(next)) return {};
    entered = face_towards(cells.neighbours[next], t);
    t = next;
    if (cells.is_ghost(t)) return t;
  }
}

void TetInserter::walk_to(const Point3& p) {
  const TetId t = *walk<false>(p);
  hint_ = arena_.cells.is_ghost(t) ? *arena_.cells.neighbours[t][0] : t;
}

void TetInserter::go_to(TetId t) {
  if (arena_.marks[t.index()] != Mark::dead && !arena_.cells.is_ghost(t)) hint_ = t;
}

// ---- the cavity ----

bool TetInserter::in_conflict(TetId t, const Point3& p) const {
  const auto& cells = arena_.cells;
  const auto point = [&](VertexId v) -> const Point3& { return arena_.nodes[v.index()].point; };
  const auto& c = cells.corners[t];
  if (c[0] != ghost) [[likely]]
    return kernel::insphere_perturbed(point(c[0]), point(c[1]), point(c[2]), point(c[3]), p) == Sign::positive;
  const Sign side = kernel::orient3d(p, point(c[1]), point(c[2]), point(c[3]));
  if (side != Sign::zero) return side == Sign::positive;
  const TetId inside = *cells.neighbours[t][0];
  const Mark mark = arena_.marks[inside.index()];
  return mark == Mark::doomed || (mark == Mark::none && in_conflict(inside, p));
}

/// Mark and list the tetrahedra in conflict with v from t on, and the walls about them. False if they are not all owned.
template <bool restricted>
bool TetInserter::open_cavity(TetId t, VertexId v) {
  const Point3 p = arena_.nodes[v.index()].point;
  const auto* const all_corners = arena_.cells.corners.flat().data();
  const auto* const all_neighbours = arena_.cells.neighbours.flat().data();
  Mark* const marks = arena_.marks.data();
  cavity_.clear();
  walls_.clear();
  cavity_.push_back(t);
  marks[t.index()] = Mark::doomed;
  for (std::size_t i = 0; i < cavity_.size(); ++i) {
    const TetId inside = cavity_[i];
    for (unsigned face = 0; face < 4; ++face) {
      const TetId behind = *all_neighbours[inside.index()][face];
      Mark& mark = marks[behind.index()];
      if (mark == Mark::doomed) continue;
      if (mark == Mark::none) {
        if (in_conflict(behind, p)) {
          if (restricted && !is_owned(behind)) return false;
          mark = Mark::doomed;
          cavity_.push_back(behind);
          continue;
        }
        mark = Mark::outside;
      }
      Wall& wall = walls_.emplace_back();
      wall.corners = all_corners[inside.index()];
      wall.corners[face] = v;
      wall.outside = behind;
      wall.face = static_cast<std::uint8_t>(face);
      wall.twin_face = static_cast<std::uint8_t>(face_towards(all_neighbours[behind.index()], inside));
    }
  }
  return true;
}

void TetInserter::close_again() {
  for (const TetId t : cavity_) arena_.marks[t.index()] = Mark::none;
  for (const Wall& wall : walls_) arena_.marks[wall.outside.index()] = Mark::none;
}

/// Numbers for the tetrahedra that the cavity is too small to give its own to.
bool TetInserter::find_numbers() {
  while (cavity_.size() + free_numbers_.size() < walls_.size()) {
    if (next_number_ == end_of_numbers_) {
      if (restricted_) return false;
      constexpr std::size_t at_once = std::size_t{1} << 14;
      const std::size_t first = arena_.marks.size();
      arena_.grow(at_once);
      give_numbers(TetId::from(first), TetId::from(first + at_once));
    }
    free_numbers_.push_back(TetId{next_number_++});
  }
  return true;
}

/// Give each vertex of the walls a number of its own, counting from 0; the point that they are joined to has none.
/// The walls are a sphere, so there are half as many vertices as walls, and two more.
void TetInserter::number_walls() {
  const std::uint32_t cavity = walls_.front().corners[walls_.front().face].raw + 1;
  TetNode* const nodes = arena_.nodes.data();
  std::uint32_t count = 0;
  TetNode for_ghost;
  for (Wall& wall : walls_) {
    for (unsigned i = 0; i < 4; ++i) {
      if (i == wall.face) continue;
      TetNode& node = wall.corners[i] == ghost ? for_ghost : nodes[wall.corners[i].index()];
      if (node.cavity != cavity) {
        node.cavity = cavity;
        node.local = count++;
      }
      wall.local[i] = node.local;
    }
  }
  assert(count == walls_.size() / 2 + 2);
}

/// Each edge of the walls joins the new tetrahedra over the two walls beside it, which run along it in opposite
/// directions.
void TetInserter::link_by_table(std::size_t vertices) {
  const unsigned shift = static_cast<unsigned>(std::bit_width(std::max<std::size_t>(vertices, 32) - 1));
  if (table_.size() < std::size_t{1} << (2 * shift)) table_.resize(std::size_t{1} << (2 * shift));
  TetId* const table = table_.data();
  for (const Wall& wall : walls_) {
    const auto [i, j, k] = tet_face_corners[wall.face];
    const std::uint32_t a = wall.local[i], b = wall.local[j], c = wall.local[k];
    table[a << shift | b] = table[b << shift | c] = table[c << shift | a] = wall.made;
  }
  auto* const all_neighbours = arena_.cells.neighbours.flat().data();
  for (const Wall& wall : walls_) {
    const auto [i, j, k] = tet_face_corners[wall.face];
    const std::uint32_t a = wall.local[i], b = wall.local[j], c = wall.local[k];
    auto& neighbours = all_neighbours[wall.made.index()];
    neighbours[k] = table[b << shift | a];
    neighbours[i] = table[c << shift | b];
    neighbours[j] = table[a << shift | c];
  }
}

/// The same for cavities with so many vertices that a table of all pairs would be too large.
void TetInserter::link_by_sorting() {
  struct Edge {
    std::uint64_t ends;
    TetId tet;
    unsigned opposite;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * walls_.size());
  for (const Wall& wall : walls_) {
    const auto& around = tet_face_corners[wall.face];
    for (unsigned n = 0; n < 3; ++n) {
      const std::uint32_t a = wall.local[around[n]], b = wall.local[around[(n + 1) % 3]];
      edges.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), wall.made, around[(n + 2) % 3]});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.ends < f.ends; });
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    const Edge &one = edges[e], &other = edges[e + 1];
    assert(one.ends == other.ends);
    arena_.cells.neighbours[one.tet][one.opposite] = other.tet;
    arena_.cells.neighbours[other.tet][other.opposite] = one.tet;
  }
}

/// Put the new tetrahedra in the cavity's place.
void TetInserter::fill() {
  number_walls();
  auto& cells = arena_.cells;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    Wall& wall = walls_[w];
    if (w < cavity_.size()) {
      wall.made = cavity_[w];
    } else {
      wall.made = free_numbers_.back();
      free_numbers_.pop_back();
    }
    cells.corners[wall.made] = wall.corners;
    cells.neighbours[wall.made][wall.face] = wall.outside;
    cells.neighbours[wall.outside][wall.twin_face] = wall.made;
    arena_.marks[wall.made.index()] = Mark::none;
    arena_.marks[wall.outside.index()] = Mark::none;
  }
  for (std::size_t c = walls_.size(); c < cavity_.size(); ++c) {
    arena_.marks[cavity_[c].index()] = Mark::dead;
    free_numbers_.push_back(cavity_[c]);
  }
  const std::size_t vertices = walls_.size() / 2 + 2;
  if (vertices <= largest_table)
    link_by_table(vertices);
  else
    link_by_sorting();
  std::size_t real = 0;
  while (walls_[real].corners[0] == ghost) ++real;
  hint_ = walls_[real].made;
}

bool TetInserter::insert(VertexId v) {
  const Point3 p = arena_.nodes[v.index()].point;
  const MaybeId<TetId> t = restricted_ ? walk<true>(p) : walk<false>(p);
  if (!t) return false;
  const bool opened = restricted_ ? open_cavity<true>(*t, v) : open_cavity<false>(*t, v);
  if (!opened || !find_numbers()) {
    close_again();
    return false;
  }
  fill();
  return true;
}

}  // namespace leonhard::delaunay
