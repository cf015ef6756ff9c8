// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/tet_inserter.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "leonhard/kernel/predicates3.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// Which face of a tetrahedron lies next to `other`, which is one of its neighbours. Without branches, which nothing
/// could foretell.
unsigned face_towards(const std::array<MaybeId<TetId>, 4>& neighbours, TetId other) {
  const MaybeId<TetId> behind(other);
  return static_cast<unsigned>(neighbours[1] == behind) |
         static_cast<unsigned>(neighbours[2] == behind) << 1 |
         static_cast<unsigned>(neighbours[3] == behind) * 3;
}

/// tet_face_corners the other way round: counter-clockwise as seen from inside. Corner 0, which may be the ghost, stays
/// the first, and corner 3, which carries the mark, does not become it.
constexpr std::array<std::array<std::uint8_t, 3>, 4> face_corners_inwards{
    {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

/// With so many vertices on the walls at most, new tetrahedra find one another through a table of all pairs of them.
constexpr std::size_t largest_table = 256;

}  // namespace

TetInserter::TetInserter(TetArena& arena, VertexRange owned, TetId hint)
    : arena_(arena),
      spheres_(kernel::spheres_filter()),
      owned_(owned),
      restricted_(owned.end - owned.begin < arena.nodes.size()),
      hint_(hint) {
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
  return owned_.contains(c[1]) && owned_.contains(c[2]) && owned_.contains(unmarked(c[3])) &&
         (c[0] == ghost || owned_.contains(c[0]));
}

// ---- the walk ----

/// A remembering visibility walk (Devillers, Pion and Teillaud 2002): to the tetrahedron that holds p, or to a ghost
/// whose hull face has p strictly beyond it. In a Delaunay tetrahedralisation it never goes round in a circle.
template <bool restricted>
MaybeId<TetId> TetInserter::walk(const Point3& p) {
  const auto& cells = arena_.cells;
  TetId t = hint_;
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
  if (!arena_.cells.is_ghost(t)) hint_ = t;
}

// ---- the cavity ----

/// For tetrahedra of which the filter makes nothing.
bool TetInserter::in_conflict(TetId t, const Point3& p) const {
  const auto& cells = arena_.cells;
  const auto point = [&](VertexId v) -> const Point3& { return arena_.nodes[v.index()].point; };
  const auto& c = cells.corners[t];
  const Point3 &c_1 = point(c[1]), &c_2 = point(c[2]), &c_3 = point(unmarked(c[3]));
  if (c[0] != ghost) {
    const Sign side = kernel::insphere_exact(point(c[0]), c_1, c_2, c_3, p);
    return (side != Sign::zero ? side : kernel::insphere_tie(point(c[0]), c_1, c_2, c_3, p)) ==
           Sign::positive;
  }
  const Sign side = kernel::orient3d(p, c_1, c_2, c_3);
  if (side != Sign::zero) return side == Sign::positive;
  // In the face's plane, where the sphere of the tetrahedron inside cuts out the face's circle.
  const auto& r = cells.corners[*cells.neighbours[t][0]];
  return kernel::insphere_perturbed(point(r[0]), point(r[1]), point(r[2]), point(unmarked(r[3])), p) ==
         Sign::positive;
}

/// Mark and list the tetrahedra in conflict with v from t on, and the faces between them and others. False if they are
/// not all owned.
///
/// All tetrahedra about the ones found last are asked at once: the answers are as good as random, so that a processor
/// could not go ahead of them one by one. For the same reason the lists are made without branches.
template <bool restricted>
bool TetInserter::open_cavity(TetId t, VertexId v) {
  const Point3 p = arena_.nodes[v.index()].point;
  cavity_.clear();
  faces_.clear();
  asked_.clear();
  cavity_.push(t);
  set_mark(arena_.cells.corners[t], TetMark::doomed);
  for (std::size_t begin = 0, end = 1; begin < end; begin = end, end = cavity_.size()) {
    const std::size_t asked = asked_.size();
    list_faces(begin);
    ask(asked, p);
    if (!doom<restricted>(asked, p)) return false;
  }
  return true;
}

/// List the faces, but for those towards doomed tetrahedra, of the cavity from `begin` on, and the tetrahedra behind them
/// that have not been asked.
void TetInserter::list_faces(std::size_t begin) {
  const std::size_t room = 4 * (cavity_.size() - begin);
  Face* face = faces_.room(room);
  TetId* asked = asked_.room(room);
  auto* const all_corners = arena_.cells.corners.flat().data();
  const auto* const neighbours = arena_.cells.neighbours.flat().data();
  for (std::size_t inside = begin; inside < cavity_.size(); ++inside)
    for (const MaybeId<TetId> behind : neighbours[cavity_[inside].index()])
      __builtin_prefetch(&all_corners[(*behind).index()], 1);
  for (std::size_t inside = begin; inside < cavity_.size(); ++inside) {
    const std::array<MaybeId<TetId>, 4> around = neighbours[cavity_[inside].index()];
    for (std::uint32_t i = 0; i < 4; ++i) {
      const TetId behind = *around[i];
      __builtin_prefetch(&neighbours[behind.index()], 1);
      auto& corners = all_corners[behind.index()];
      const TetMark mark = mark_of(corners);
      face->outside = behind;
      face->place = static_cast<std::uint32_t>(4 * inside + i);
      face += mark != TetMark::doomed;
      *asked = behind;
      asked += mark == TetMark::none;
      mark_if_unasked(corners);
    }
  }
  faces_.end_at(face);
  asked_.end_at(asked);
}

/// Filter the answers of those asked from `begin` on.
void TetInserter::ask(std::size_t begin, const Point3& p) {
  const std::size_t count = asked_.size() - begin;
  if (answers_.size() < count) {
    answers_.resize(2 * count);
    asked_corners_.resize(8 * count);
  }
  const auto* const all_corners = arena_.cells.corners.flat().data();
  const TetId* const asked = asked_.begin() + begin;
  std::uint32_t* ids = asked_corners_.data();
  for (std::size_t k = 0; k < count; ++k, ids += 4) {
    const std::array<VertexId, 4> c = all_corners[asked[k].index()];
    // A ghost has one corner twice, and of that the filter makes nothing.
    ids[0] = static_cast<std::uint32_t>(c[0] == ghost ? c[1].raw : c[0].raw);
    ids[1] = static_cast<std::uint32_t>(c[1].raw);
    ids[2] = static_cast<std::uint32_t>(c[2].raw);
    ids[3] = static_cast<std::uint32_t>(unmarked(c[3]).raw);
  }
  spheres_(p, arena_.nodes.data(), asked_corners_.data(), count, answers_.data());
}

/// Those asked from `begin` on that are in conflict join the cavity.
template <bool restricted>
bool TetInserter::doom(std::size_t begin, const Point3& p) {
  const std::size_t count = asked_.size() - begin;
  TetId* doomed = cavity_.room(count);
  const TetId* const asked = asked_.begin() + begin;
  const Sign* const answers = answers_.data();
  auto* const corners = arena_.cells.corners.flat().data();
  bool all_owned = true;
  for (std::size_t k = 0; k < count; ++k) {
    const TetId t = asked[k];
    Sign answer = answers[k];
    if (answer == Sign::zero) [[unlikely]]
      answer = in_conflict(t, p) ? Sign::positive : Sign::negative;
    const bool dies = answer == Sign::positive;
    *doomed = t;
    doomed += dies;
    set_mark(corners[t.index()], dies ? TetMark::doomed : TetMark::outside);
    if (restricted && dies) all_owned &= is_owned(t);
  }
  cavity_.end_at(doomed);
  return all_owned;
}

void TetInserter::list_walls(VertexId v) {
  const auto* const all_corners = arena_.cells.corners.flat().data();
  Face* kept = faces_.begin();
  for (const Face face : faces_) {
    *kept = face;
    kept += mark_of(all_corners[face.outside.index()]) != TetMark::doomed;
  }
  faces_.end_at(kept);
  walls_.clear();
  Wall* wall = walls_.room(faces_.size());
  for (const Face face : faces_) {
    const TetId inside = cavity_[face.place / 4];
    const auto& corners = all_corners[inside.index()];
    const auto& inwards = face_corners_inwards[face.place % 4];
    wall->corners[0] = corners[inwards[0]];
    wall->corners[1] = unmarked(corners[inwards[1]]);
    wall->corners[2] = unmarked(corners[inwards[2]]);
    wall->corners[3] = v;
    wall->outside = face.outside;
    wall->twin_face = face_towards(arena_.cells.neighbours[face.outside], inside);
    ++wall;
  }
  walls_.end_at(wall);
}

void TetInserter::close_again() {
  for (const TetId t : cavity_) set_mark(arena_.cells.corners[t], TetMark::none);
  for (const TetId t : asked_) set_mark(arena_.cells.corners[t], TetMark::none);
}

/// Numbers for the tetrahedra that the cavity is too small to give its own to.
bool TetInserter::find_numbers() {
  while (cavity_.size() + free_numbers_.size() < walls_.size()) {
    if (next_number_ == end_of_numbers_) {
      if (restricted_) return false;
      constexpr std::size_t at_once = std::size_t{1} << 14;
      const std::size_t first = arena_.cells.tet_count();
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
  const auto cavity = static_cast<std::uint32_t>(walls_[0].corners[3].raw + 1);
  TetNode* const nodes = arena_.nodes.data();
  std::uint32_t count = 0;
  TetNode for_ghost{};
  const auto number_of = [&](VertexId v) {
    TetNode& node = v == ghost ? for_ghost : nodes[v.index()];
    const bool is_new = node.notes[0] != cavity;
    const std::uint32_t number = is_new ? count : node.notes[1];
    node.notes[0] = cavity;
    node.notes[1] = number;
    count += is_new;
    return number;
  };
  for (Wall& wall : walls_)
    wall.local = {number_of(wall.corners[0]), number_of(wall.corners[1]), number_of(wall.corners[2])};
  assert(count == walls_.size() / 2 + 2);
}

/// Each edge of the walls joins the new tetrahedra over the two walls beside it, which run along it in opposite
/// directions.
void TetInserter::link_by_table(std::size_t vertices) {
  const unsigned shift = static_cast<unsigned>(std::bit_width(std::max<std::size_t>(vertices, 32) - 1));
  if (table_.size() < std::size_t{1} << (2 * shift)) table_.resize(std::size_t{1} << (2 * shift));
  TetId* const table = table_.data();
  for (const Wall& wall : walls_) {
    const auto [a, b, c] = wall.local;
    table[a << shift | b] = table[b << shift | c] = table[c << shift | a] = wall.made;
  }
  auto* const neighbours = arena_.cells.neighbours.flat().data();
  for (const Wall& wall : walls_) {
    const auto [a, b, c] = wall.local;
    neighbours[wall.made.index()] = {table[c << shift | b], table[a << shift | c], table[b << shift | a],
                                     wall.outside};
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
    arena_.cells.neighbours[wall.made][3] = wall.outside;
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t a = wall.local[(i + 1) % 3], b = wall.local[(i + 2) % 3];
      edges.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), wall.made, i});
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
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (w < cavity_.size()) {
      walls_[w].made = cavity_[w];
    } else {
      walls_[w].made = free_numbers_.back();
      free_numbers_.pop_back();
    }
  }
  auto* const corners = arena_.cells.corners.flat().data();
  auto* const neighbours = arena_.cells.neighbours.flat().data();
  for (const Wall& wall : walls_) {
    corners[wall.made.index()] = wall.corners;
    neighbours[wall.outside.index()][wall.twin_face] = wall.made;
    set_mark(corners[wall.outside.index()], TetMark::none);
  }
  for (std::size_t c = walls_.size(); c < cavity_.size(); ++c) {
    arena_.kill(cavity_[c]);
    free_numbers_.push_back(cavity_[c]);
  }
  number_walls();
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
  if (opened) list_walls(v);
  if (!opened || !find_numbers()) {
    close_again();
    return false;
  }
  fill();
  return true;
}

}  // namespace leonhard::delaunay
