// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/tet_insertion.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "leonhard/delaunay/order/insertion_order.hpp"
#include "leonhard/delaunay/space/first_tetrahedron.hpp"
#include "leonhard/delaunay/space/tet_inserter.hpp"
#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/delaunay/support/parallel.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

class Insertion {
 public:
  Insertion(TetArena& arena, const TetAlgorithmOptions& options)
      : arena_(arena), options_(options), threads_(thread_count(options.threads)) {}

  /// False: stopped.
  bool run(std::array<std::size_t, 4> first) {
    start(first);
    std::ranges::sort(first);
    const Rounds rounds = rounds_of(arena_.nodes.size(), options_.seed);
    for (std::size_t r = 0; r < rounds.count(); ++r) {
      std::vector<std::uint32_t> left(rounds.round(r).begin(), rounds.round(r).end());
      std::erase_if(left, [&](std::uint32_t v) { return std::ranges::binary_search(first, std::size_t{v}); });
      if (!insert(std::move(left))) return false;
    }
    return true;
  }

 private:
  /// The first tetrahedron and the four ghosts about it.
  void start(const std::array<std::size_t, 4>& corners) {
    const std::size_t expected = 27 * arena_.nodes.size() / 4 + arena_.nodes.size() / 8 + 1024;
    arena_.cells.corners.reserve(expected);
    arena_.cells.neighbours.reserve(expected);
    const std::size_t bytes = expected * sizeof(std::array<VertexId, 4>);
    prefer_large_pages(arena_.cells.corners.flat().data(), bytes);
    prefer_large_pages(arena_.cells.neighbours.flat().data(), bytes);
    if (threads_ > 1) {
      touch_pages(arena_.cells.corners.flat().data(), bytes, threads_);
      touch_pages(arena_.cells.neighbours.flat().data(), bytes, threads_);
    }
    arena_.grow(5);
    auto& cells = arena_.cells;
    const TetId inside{0};
    for (unsigned i = 0; i < 4; ++i) cells.corners[inside][i] = VertexId::from(corners[i]);
    for (unsigned i = 0; i < 4; ++i) {
      // A ghost sees the face from the other side.
      const TetId outside{i + 1};
      const auto [a, b, c] = tet_face_corners[i];
      cells.corners[outside] = {ghost, VertexId::from(corners[a]), VertexId::from(corners[c]),
                                VertexId::from(corners[b])};
      cells.neighbours[outside] = {inside, TetId{a + 1}, TetId{c + 1}, TetId{b + 1}};
      cells.neighbours[inside][i] = outside;
    }
    hint_ = inside;
  }

  bool insert(std::vector<std::uint32_t> left) {
    constexpr std::size_t worth_threads = 20'000;
    // What two pieces leave lies at their one seam, which a single piece would take in the second pass.
    const unsigned passes = threads_ > 2 ? 3 : threads_ - 1;
    for (unsigned pass = 0; pass < passes && left.size() > worth_threads; ++pass) {
      left = insert_by_threads(left, pass);
      if (options_.progress.stop_requested()) return false;
    }
    return insert_one_by_one(left);
  }

  bool insert_one_by_one(std::span<const std::uint32_t> vertices) {
    constexpr std::size_t poll = 2048;
    TetInserter inserter(arena_, {0, static_cast<IdRaw>(arena_.nodes.size())}, hint_);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i % poll == 0) {
        report(inserted_ + i);
        if (options_.progress.stop_requested()) return false;
      }
      [[maybe_unused]] const bool inserted = inserter.insert(VertexId{vertices[i]});
      assert(inserted);
    }
    inserted_ += vertices.size();
    hint_ = inserter.hint();
    inserter.return_numbers();
    return true;
  }

  /// Insert what threads can insert without meeting; returns the others, in order.
  std::vector<std::uint32_t> insert_by_threads(std::span<const std::uint32_t> vertices, unsigned pass) {
    std::vector<Piece> pieces = cut(vertices, pass);
    for (Piece& piece : pieces) find_hint(piece);
    const std::size_t first = arena_.cells.tet_count();
    std::size_t numbers = 0;
    for (Piece& piece : pieces) {
      constexpr std::size_t numbers_a_point = 7, spare = 4096;
      piece.first = TetId::from(first + numbers);
      numbers += numbers_a_point * piece.vertices.size() + spare;
      piece.last = TetId::from(first + numbers);
    }
    arena_.grow(numbers);
    parallel_for_blocks(pieces.size(), threads_, [&](std::size_t i) { insert_piece(pieces[i]); });
    std::vector<std::uint32_t> left;
    for (Piece& piece : pieces) {
      left.insert(left.end(), piece.left.begin(), piece.left.end());
      piece.inserter->return_numbers();
      // Of a piece that inserted nothing the hint may be gone.
      if (piece.left.size() < piece.vertices.size()) hint_ = piece.inserter->hint();
    }
    inserted_ += vertices.size() - left.size();
    report(inserted_);
    std::ranges::sort(left);
    return left;
  }

  /// A part of the curve for one thread.
  struct Piece {
    VertexRange owned;
    std::span<const std::uint32_t> vertices;
    TetId first, last;
    std::optional<TetInserter> inserter;
    bool can_start = false;  ///< the inserter owns its hint
    std::vector<std::uint32_t> left;
  };

  /// Pieces of equal length, as many as threads; in every second pass shifted by half of one, so that the seams lie
  /// elsewhere.
  std::vector<Piece> cut(std::span<const std::uint32_t> vertices, unsigned pass) const {
    const std::size_t n = arena_.nodes.size(), shift = pass % 2;
    std::vector<Piece> pieces(threads_ + shift);
    const auto seam = [&](std::size_t i) {
      const std::size_t twice = std::min(std::size_t{2} * threads_, std::max(2 * i, shift) - shift);
      return static_cast<IdRaw>(n * twice / (2 * threads_));
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      pieces[i].owned = {seam(i), seam(i + 1)};
      const auto begin = std::ranges::lower_bound(vertices, pieces[i].owned.begin),
                 end = std::ranges::lower_bound(vertices, pieces[i].owned.end);
      pieces[i].vertices = std::span(begin, end);
    }
    return pieces;
  }

  /// The middle of a piece is farthest from its seams.
  void find_hint(Piece& piece) {
    TetInserter scout(arena_, {0, static_cast<IdRaw>(arena_.nodes.size())}, hint_);
    if (!piece.vertices.empty()) scout.walk_to(arena_.nodes[piece.vertices[piece.vertices.size() / 2]].point);
    hint_ = scout.hint();
    scout.return_numbers();
    piece.inserter.emplace(arena_, piece.owned, hint_);
    piece.can_start = piece.inserter->is_owned(hint_);
  }

  /// From the middle to the end, then from the middle to the beginning.
  void insert_piece(Piece& piece) const {
    TetInserter& inserter = *piece.inserter;
    inserter.give_numbers(piece.first, piece.last);
    if (!piece.can_start) {
      piece.left.assign(piece.vertices.begin(), piece.vertices.end());
      return;
    }
    const std::size_t count = piece.vertices.size(), middle = count / 2;
    const auto insert = [&](std::size_t i) {
      constexpr std::size_t poll = 1024;
      if (i % poll == 0 && options_.progress.stop_requested()) return false;
      if (!inserter.insert(VertexId{piece.vertices[i]})) piece.left.push_back(piece.vertices[i]);
      return true;
    };
    TetId in_the_middle = inserter.hint();
    for (std::size_t i = middle; i < count; ++i) {
      if (!insert(i)) return;
      if (i == middle) in_the_middle = inserter.hint();
    }
    inserter.go_to(in_the_middle);
    for (std::size_t i = middle; i-- > 0;)
      if (!insert(i)) return;
  }

  void report(std::size_t inserted) const {
    options_.progress("tetrahedralize",
                      static_cast<double>(inserted) / static_cast<double>(arena_.nodes.size()));
  }

  TetArena& arena_;
  const TetAlgorithmOptions& options_;
  unsigned threads_;
  TetId hint_{};
  std::size_t inserted_ = 4;
};

TetrahedralizeOutcome outcome_of(const FirstTetrahedron& first, std::size_t points) {
  using Outcome = TetrahedralizeOutcome;
  if (first.extent == Extent::space) return Outcome::done;
  if (points < 4) return Outcome::too_few_points;
  return first.extent == Extent::plane ? Outcome::all_coplanar : Outcome::all_collinear;
}

}  // namespace

InsertedNodes insert_nodes(std::vector<TetNode> nodes, const TetAlgorithmOptions& options) {
  const FirstTetrahedron first = first_tetrahedron(std::span<const TetNode>(nodes));
  const TetrahedralizeOutcome outcome = outcome_of(first, nodes.size());
  if (outcome != TetrahedralizeOutcome::done) return {outcome, {}, {}};
  TetArena arena;
  arena.nodes = std::move(nodes);
  if (!Insertion(arena, options).run(first.points)) return {TetrahedralizeOutcome::stopped, {}, {}};
  return {TetrahedralizeOutcome::done, std::move(arena.cells), std::move(arena.free_numbers)};
}

PointTetrahedralization tetrahedralize_insertion(std::span<const Point3> points,
                                                 const TetAlgorithmOptions& options) {
  std::vector<TetNode> nodes(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) nodes[i].point = points[i];
  InsertedNodes made = insert_nodes(std::move(nodes), options);
  made.cells.erase(std::move(made.dead));
  return {made.outcome, std::move(made.cells)};
}

}  // namespace leonhard::delaunay
