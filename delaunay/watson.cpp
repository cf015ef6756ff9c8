// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/watson.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "leonhard/delaunay/cavity.hpp"
#include "leonhard/delaunay/locate.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {
namespace {

/// A well mixed hash of a position: what makes the rounds random without a seed.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// Positions 0..n-1 in rounds: an eighth of the points comes before the last round, an eighth of these before the
/// round before it, down to some hundreds; within a round positions rise.
std::vector<std::uint32_t> rounds(std::size_t n) {
  constexpr std::size_t first_round = 500;
  constexpr unsigned bits_a_round = 3;
  unsigned last = 0;
  for (std::size_t left = n; left > first_round; left >>= bits_a_round) ++last;
  const auto round_of = [&](std::size_t i) {
    const auto zeros = static_cast<unsigned>(std::countr_zero(mixed(i)));
    return last - std::min(last, zeros / bits_a_round);
  };
  std::vector<std::size_t> begin(last + 2, 0);
  for (std::size_t i = 0; i < n; ++i) ++begin[round_of(i) + 1];
  for (unsigned r = 0; r <= last; ++r) begin[r + 1] += begin[r];
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[begin[round_of(i)]++] = static_cast<std::uint32_t>(i);
  return order;
}

/// Bring three points that span a triangle to the front of the order, counter-clockwise; false if there are none.
bool span_triangle(std::span<const Point2> points, std::vector<std::uint32_t>& order) {
  for (std::size_t k = 2; k < order.size(); ++k) {
    const Sign turn = kernel::orient2d(points[order[0]], points[order[1]], points[order[k]]);
    if (turn == Sign::zero) continue;
    // The points skipped keep their order, so that each next one stays close to the one before.
    std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(k),
                order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    if (turn == Sign::negative) std::swap(order[0], order[1]);
    return true;
  }
  return false;
}

/// Whether the point p, if inserted, destroys the triangle t.
class Conflict {
 public:
  Conflict(const GhostTriangulation& in, std::span<const Point2> points, Point2 p)
      : in_(in), points_(points), p_(p) {}

  bool operator()(TriangleId t) const {
    const Point2 b = at(in_.corner(t, 1)), c = at(in_.corner(t, 2));
    if (!in_.is_ghost(t)) [[likely]]
      return kernel::incircle_perturbed(at(in_.corner(t, 0)), b, c, p_) == Sign::positive;
    // A ghost's circle is the open half plane outside its edge, and the open edge itself.
    const Sign turn = kernel::orient2d(b, c, p_);
    return turn == Sign::positive || (turn == Sign::zero && (b < c ? b < p_ && p_ < c : c < p_ && p_ < b));
  }

 private:
  [[nodiscard]] Point2 at(VertexId v) const { return points_[v.index()]; }
  const GhostTriangulation& in_;
  std::span<const Point2> points_;
  Point2 p_;
};

}  // namespace

PointTriangulation triangulate_watson(std::span<const Point2> points, const AlgorithmOptions& options) {
  using Outcome = TriangulateOutcome;
  PointTriangulation result;
  if (points.size() < 3) return {Outcome::too_few_points, {}};
  std::vector<std::uint32_t> order = rounds(points.size());
  if (!span_triangle(points, order)) return {Outcome::all_collinear, {}};

  GhostTriangulation& in = result.triangulation;
  in.reserve(2 * points.size() + 4);
  in.start(VertexId{order[0]}, VertexId{order[1]}, VertexId{order[2]});
  TriangleId last{0};  // the walk's start: real
  Cavity cavity;
  Coin coin;
  constexpr std::size_t poll = 4096;
  for (std::size_t k = 3; k < order.size(); ++k) {
    if (k % poll == 0) {
      if (options.progress.stop_requested()) return {Outcome::stopped, {}};
      options.progress("triangulate", static_cast<double>(k) / static_cast<double>(order.size()));
    }
    const Point2 p = points[order[k]];
    cavity.start(in, walk(in, points, last, p, coin));
    const Conflict conflict(in, points, p);
    cavity.grow(in, [&](SideId inner) { return conflict(in.triangle(in.twin(inner))); });
    cavity.fill(in, VertexId{order[k]});
    last = cavity.triangles()[0];
    for (std::size_t i = 1; in.is_ghost(last); ++i) last = cavity.triangles()[i];
  }
  return result;
}

}  // namespace leonhard::delaunay
