// SPDX-License-Identifier: MIT
#include "leonhard/kernel/hilbert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
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

// ---- points to cells ----

/// The bounding square, kept halved where its side would overflow.
struct Square {
  double left, bottom, side, scale;
};

Square bounding_square(std::span<const Point2> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 low{infinity, infinity}, high{-infinity, -infinity};
  for (const Point2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double scale = std::isfinite(high.x - low.x) && std::isfinite(high.y - low.y) ? 1.0 : 0.5;
  const double width = scale * high.x - scale * low.x, height = scale * high.y - scale * low.y;
  return {scale * low.x, scale * low.y, std::max(width, height), scale};
}

std::uint32_t cell_of(double coordinate, double low, const Square& square) {
  if (!(square.side > 0)) return 0;
  return static_cast<std::uint32_t>((square.scale * coordinate - low) / square.side * 0x7fffffffp0);
}

void check(std::span<const Point2> points) {
  if (points.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError("points", std::to_string(points.size()) + " points do not fit 32-bit indices",
                     "order them in parts");
  const auto bad = std::find_if_not(points.begin(), points.end(), [](Point2 p) { return is_finite(p); });
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

void order_within_cells(std::vector<Keyed>& items, std::span<const Point2> points) {
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

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Point2> points) {
  check(points);
  if (points.empty()) return {};
  const Square square = bounding_square(points);
  std::vector<Keyed> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t x = cell_of(points[i].x, square.left, square);
    const std::uint32_t y = cell_of(points[i].y, square.bottom, square);
    items[i] = {distance_along_curve(x, y), static_cast<std::uint32_t>(i)};
  }
  sort_by_key(items);
  order_within_cells(items, points);
  std::vector<std::uint32_t> order(points.size());
  std::ranges::transform(items, order.begin(), &Keyed::index);
  return order;
}

}  // namespace leonhard::kernel
