// SPDX-License-Identifier: MIT
#include "leonhard/kernel/hilbert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::kernel {
namespace {

// ---- the curve on a grid of the plane ----

/// The curve fills a square in one of four attitudes: as given, mirrored at either diagonal, turned by 180
/// degrees. In attitude s the quadrant (x bit, y bit) is the rank-th that the curve visits, and the curve
/// inside has attitude child: the production rules of Hilbert's curve.
struct Rule {
  std::uint8_t rank, child;
};
constexpr std::array<std::array<Rule, 4>, 4> rules{{
    // quadrant      (0,0)   (0,1)   (1,0)   (1,1)
    /* 0: open below         */ {{{0, 1}, {1, 0}, {3, 2}, {2, 0}}},
    /* 1: mirrored at x = y  */ {{{0, 0}, {3, 3}, {1, 1}, {2, 1}}},
    /* 2: mirrored at x = -y */ {{{2, 2}, {1, 2}, {3, 0}, {0, 3}}},
    /* 3: turned by 180      */ {{{2, 3}, {3, 1}, {1, 3}, {0, 2}}},
}};

constexpr unsigned bits_per_step = 4;
constexpr unsigned steps = 8;  // 32 bits, the top one of which is zero

/// The rules applied bits_per_step times: the ranks reached, and the attitude of the small square.
struct Jump {
  std::uint8_t ranks, child;
};

constexpr auto jumps = [] {
  constexpr std::size_t side = std::size_t{1} << bits_per_step;
  std::array<std::array<Jump, side * side>, 4> table{};
  for (unsigned start = 0; start < 4; ++start)
    for (unsigned x = 0; x < side; ++x)
      for (unsigned y = 0; y < side; ++y) {
        unsigned attitude = start, ranks = 0;
        for (unsigned bit = bits_per_step; bit-- > 0;) {
          const Rule rule = rules[attitude][((x >> bit) & 1U) * 2 + ((y >> bit) & 1U)];
          ranks = ranks * 4 + rule.rank;
          attitude = rule.child;
        }
        table[start][x * side + y] = {static_cast<std::uint8_t>(ranks), static_cast<std::uint8_t>(attitude)};
      }
  return table;
}();

/// How far along the curve the cell (x, y) lies.
std::uint64_t distance_along_curve(std::uint32_t x, std::uint32_t y) {
  constexpr std::uint32_t mask = (1U << bits_per_step) - 1;
  std::uint64_t distance = 0;
  unsigned attitude =
      1;  // the top bit is zero and passes through one more rule: attitude 0 at the first real bit
  for (unsigned step = steps; step-- > 0;) {
    const unsigned shift = step * bits_per_step;
    const Jump jump = jumps[attitude][((x >> shift) & mask) << bits_per_step | ((y >> shift) & mask)];
    distance = distance << (2 * bits_per_step) | jump.ranks;
    attitude = jump.child;
  }
  return distance;
}

// ---- the curve on a grid of space ----

/// Hamilton's rules ("Compact Hilbert indices", Dalhousie University CS-2006-07, sections 2.1 to 2.3) for three
/// dimensions: the curve enters a cube at the corner `entry` and leaves it along the axis `axis`. Corners and octants
/// are numbers of three bits.
struct Attitude {
  unsigned entry, axis;
};

constexpr unsigned rotated_left(unsigned octant, unsigned by) {
  return ((octant << by % 3) | (octant >> (3 - by % 3))) & 7U;
}
constexpr unsigned gray_code(unsigned rank) { return rank ^ (rank >> 1); }

struct RankAndAttitude {
  unsigned rank;
  Attitude inside;
};

/// When the curve visits an octant of a cube, and its attitude inside.
constexpr RankAndAttitude visit(Attitude cube, unsigned octant) {
  const unsigned turned =
      rotated_left(octant ^ cube.entry, 2 - cube.axis);          // a rotation to the right by axis + 1
  const unsigned rank = turned ^ (turned >> 1) ^ (turned >> 2);  // the inverse of gray_code
  const unsigned entry = rank == 0 ? 0 : gray_code((rank - 1) & ~1U);
  const unsigned axis = rank == 0 ? 0 : static_cast<unsigned>(std::countr_one(rank - 1 + rank % 2)) % 3;
  return {rank, {cube.entry ^ rotated_left(entry, cube.axis + 1), (cube.axis + axis + 1) % 3}};
}

constexpr unsigned space_bits_per_step = 3;
constexpr unsigned space_steps = 7;  // 21 bits

/// The bits of an octant three places apart: a step's index is made of three bits each of x, y, z.
constexpr unsigned spread(unsigned octant) { return (octant & 4U) << 4 | (octant & 2U) << 2 | (octant & 1U); }

/// The rules applied space_bits_per_step times, for 8 entries times 3 axes: the ranks reached times 32, plus the
/// attitude of the small cube, which is 3 entry + axis.
constexpr auto space_jumps = [] {
  std::array<std::array<std::uint16_t, 512>, 24> table{};
  for (unsigned start = 0; start < table.size(); ++start)
    for (unsigned first = 0; first < 8; ++first) {
      const RankAndAttitude one = visit({start / 3, start % 3}, first);
      for (unsigned second = 0; second < 8; ++second) {
        const RankAndAttitude two = visit(one.inside, second);
        for (unsigned third = 0; third < 8; ++third) {
          const RankAndAttitude last = visit(two.inside, third);
          const unsigned index = spread(first) << 2 | spread(second) << 1 | spread(third);
          const unsigned ranks = one.rank << 6 | two.rank << 3 | last.rank;
          table[start][index] =
              static_cast<std::uint16_t>(ranks << 5 | (3 * last.inside.entry + last.inside.axis));
        }
      }
    }
  return table;
}();

/// How far along the curve the cell (x, y, z) lies, for coordinates of 21 bits.
std::uint64_t distance_along_curve(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::uint64_t distance = 0;
  unsigned attitude = 2;  // enters at the origin, leaves along x
  for (unsigned step = space_steps; step-- > 0;) {
    const unsigned shift = step * space_bits_per_step;
    const std::uint16_t jump =
        space_jumps[attitude][((x >> shift) & 7U) << 6 | ((y >> shift) & 7U) << 3 | ((z >> shift) & 7U)];
    distance = distance << 9 | (jump >> 5);
    attitude = jump & 31U;
  }
  return distance;
}

// ---- points to cells ----

std::array<double, 2> coordinates(const Point2& p) { return {p.x, p.y}; }
std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// The bounding square or cube, kept halved where its side would overflow.
template <std::size_t Dimension>
struct Cube {
  std::array<double, Dimension> low;
  double side, scale;
};

template <class Point>
auto bounding_cube(std::span<const Point> points) {
  constexpr std::size_t dimension = std::tuple_size_v<decltype(coordinates(Point{}))>;
  std::array<double, dimension> low = coordinates(points[0]), high = low;
  for (const Point& p : points) {
    const auto position = coordinates(p);
    for (std::size_t i = 0; i < dimension; ++i) {
      low[i] = std::min(low[i], position[i]);
      high[i] = std::max(high[i], position[i]);
    }
  }
  Cube<dimension> cube{low, 0, 1};
  for (std::size_t i = 0; i < dimension; ++i)
    if (!std::isfinite(high[i] - low[i])) cube.scale = 0.5;
  for (std::size_t i = 0; i < dimension; ++i) {
    cube.low[i] *= cube.scale;
    cube.side = std::max(cube.side, cube.scale * high[i] - cube.low[i]);
  }
  return cube;
}

/// The cell of a point on a grid of largest + 1 cells a side.
template <class Point, std::size_t Dimension>
std::array<std::uint32_t, Dimension> cell_of(const Point& p, const Cube<Dimension>& cube, double largest) {
  std::array<std::uint32_t, Dimension> cell{};
  if (!(cube.side > 0)) return cell;
  const auto position = coordinates(p);
  for (std::size_t i = 0; i < Dimension; ++i)
    cell[i] = static_cast<std::uint32_t>((cube.scale * position[i] - cube.low[i]) / cube.side * largest);
  return cell;
}

std::uint64_t key_of(const Point2& p, const Cube<2>& square) {
  const auto [x, y] = cell_of(p, square, 0x7fffffffp0);
  return distance_along_curve(x, y);
}
std::uint64_t key_of(const Point3& p, const Cube<3>& cube) {
  const auto [x, y, z] = cell_of(p, cube, 0x1fffffp0);
  return distance_along_curve(x, y, z);
}

template <class Point>
void check(std::span<const Point> points) {
  if (points.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("points", std::to_string(points.size()) + " points do not fit 32-bit indices",
                     "order them in parts");
  const auto bad =
      std::find_if_not(points.begin(), points.end(), [](const Point& p) { return is_finite(p); });
  if (bad != points.end())
    throw InputError("points", "point " + std::to_string(bad - points.begin()) + " is not finite",
                     "remove NaN and infinite coordinates");
}

// ---- sorting ----

struct Keyed {
  std::uint64_t key;
  std::uint32_t index;
};

/// Stable radix sort by key, least significant digit first; a digit that all keys share costs no pass.
void sort_by_key(std::vector<Keyed>& items) {
  constexpr unsigned digit_bits = 11, digits = 6;
  constexpr std::uint64_t mask = (1U << digit_bits) - 1;
  std::vector<std::array<std::uint32_t, mask + 1>> counts(digits);
  for (const Keyed& item : items)
    for (unsigned d = 0; d < digits; ++d) ++counts[d][item.key >> (d * digit_bits) & mask];
  std::vector<Keyed> sorted(items.size());
  for (unsigned d = 0; d < digits; ++d) {
    if (std::ranges::count(counts[d], 0U) == static_cast<std::ptrdiff_t>(mask)) continue;
    std::uint32_t begin = 0;
    for (std::uint32_t& count : counts[d]) begin += std::exchange(count, begin);
    for (const Keyed& item : items) sorted[counts[d][item.key >> (d * digit_bits) & mask]++] = item;
    items.swap(sorted);
  }
}

template <class Point>
void order_within_cells(std::vector<Keyed>& items, std::span<const Point> points) {
  const auto before = [points](const Keyed& a, const Keyed& b) {
    if (points[a.index] < points[b.index]) return true;
    return points[a.index] == points[b.index] && a.index < b.index;
  };
  for (auto first = items.begin(); first != items.end();) {
    auto last = first + 1;
    while (last != items.end() && last->key == first->key) ++last;
    if (last - first > 1) std::sort(first, last, before);
    first = last;
  }
}

template <class Point>
std::vector<std::uint32_t> order_along_curve(std::span<const Point> points) {
  check(points);
  if (points.empty()) return {};
  const auto cube = bounding_cube(points);
  std::vector<Keyed> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    items[i] = {key_of(points[i], cube), static_cast<std::uint32_t>(i)};
  sort_by_key(items);
  order_within_cells(items, points);
  std::vector<std::uint32_t> order(points.size());
  std::ranges::transform(items, order.begin(), &Keyed::index);
  return order;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Point2> points) { return order_along_curve(points); }
std::vector<std::uint32_t> hilbert_order(std::span<const Point3> points) { return order_along_curve(points); }

}  // namespace leonhard::kernel
