// SPDX-License-Identifier: MIT
#include "leonhard/kernel/hilbert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::kernel {
namespace {

// ---- the curve on a grid ----

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

/// How far along the curve the cell x lies, in space, for coordinates of 21 bits. J. Skilling, "Programming the
/// Hilbert curve", AIP Conference Proceedings 707 (2004), without branches: masks stand for his tests of a bit.
std::uint64_t distance_along_curve(std::array<std::uint32_t, 3> x) {
  constexpr unsigned bits = 21;
  for (unsigned bit = bits; bit-- > 1;) {
    const std::uint32_t below = (1U << bit) - 1;
    for (std::uint32_t& axis : x) {
      const std::uint32_t is_set = 0U - ((axis >> bit) & 1U);
      const std::uint32_t exchanged = (x[0] ^ axis) & below & ~is_set;
      x[0] ^= below & is_set;
      x[0] ^= exchanged;
      axis ^= exchanged;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flips = 0;
  for (unsigned bit = bits; bit-- > 1;) flips ^= (0U - ((x[2] >> bit) & 1U)) & ((1U << bit) - 1);
  std::uint64_t distance = 0;
  for (unsigned bit = bits; bit-- > 0;)
    for (const std::uint32_t axis : x) distance = distance << 1 | (((axis ^ flips) >> bit) & 1U);
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
  return distance_along_curve(cell_of(p, cube, 0x1fffffp0));
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
