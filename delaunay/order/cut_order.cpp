// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/order/cut_order.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/delaunay/support/parallel.hpp"

namespace leonhard::delaunay {
namespace {

struct Item {
  std::uint32_t key, index;
};

/// What one thread does at a time.
constexpr std::size_t slice_size = std::size_t{1} << 15;

/// Bit i moves to bit 2 i.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 8) & 0x00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f;
  x = (x | x << 2) & 0x33333333;
  return (x | x << 1) & 0x55555555;
}

/// A square grid of 2^bits cells a side over points, and the Morton number of a point's cell: the bits of x and y in
/// turn, those of x first. A cell's column does not fall as x grows, whatever is rounded.
class Grid {
 public:
  Grid(Point2 low, Point2 high, unsigned bits) : low_x_(0.5 * low.x), low_y_(0.5 * low.y) {
    // Halves, because the difference of two finite numbers may overflow.
    const double side = std::max(0.5 * high.x - low_x_, 0.5 * high.y - low_y_);
    cells_per_unit_ = (std::ldexp(1.0, static_cast<int>(bits)) - 1) / side;
  }
  /// False where the points lie too close together for doubles to divide the square.
  [[nodiscard]] bool divides() const { return std::isfinite(cells_per_unit_); }
  [[nodiscard]] std::uint32_t key(Point2 p) const {
    const auto column = static_cast<std::uint32_t>((0.5 * p.x - low_x_) * cells_per_unit_);
    const auto row = static_cast<std::uint32_t>((0.5 * p.y - low_y_) * cells_per_unit_);
    return spread(column) << 1 | spread(row);
  }

 private:
  double low_x_, low_y_, cells_per_unit_;
};

/// Counting sort by one digit of the key after the other, the lowest first.
class RadixSort {
 public:
  RadixSort(unsigned key_bits, unsigned threads)
      : digits_((key_bits + most_digit_bits - 1) / most_digit_bits),
        digit_bits_((key_bits + digits_ - 1) / digits_),
        threads_(thread_count(threads)) {}

  /// Stable; `scratch` is as long as `items`. False if a stop was requested.
  bool operator()(std::span<Item> items, std::span<Item> scratch, const Progress& progress) const {
    for (unsigned d = 0; d < digits_; ++d) {
      if (progress.stop_requested()) return false;
      pass(items, scratch, d * digit_bits_);
      std::swap(items, scratch);
    }
    if (digits_ % 2 == 1) std::ranges::copy(items, scratch.begin());
    return true;
  }

 private:
  static constexpr unsigned most_digit_bits = 12;

  /// Each of some blocks of the items counts its digits, then moves its items to places of its own.
  void pass(std::span<const Item> from, std::span<Item> to, unsigned shift) const {
    const std::uint32_t mask = (1U << digit_bits_) - 1;
    const std::size_t blocks = std::clamp<std::size_t>(from.size() / slice_size, 1, threads_);
    const auto block = [&](std::size_t b) {
      const std::size_t begin = from.size() * b / blocks, end = from.size() * (b + 1) / blocks;
      return from.subspan(begin, end - begin);
    };
    std::vector<std::vector<std::uint32_t>> places(blocks, std::vector<std::uint32_t>(mask + 1));
    parallel_for_blocks(blocks, threads_, [&](std::size_t b) {
      for (const Item& item : block(b)) ++places[b][item.key >> shift & mask];
    });
    std::uint32_t begin = 0;
    for (std::uint32_t digit = 0; digit <= mask; ++digit)
      for (auto& counts : places) begin += std::exchange(counts[digit], begin);
    parallel_for_blocks(blocks, threads_, [&](std::size_t b) {
      for (const Item& item : block(b)) to[places[b][item.key >> shift & mask]++] = item;
    });
  }

  unsigned digits_, digit_bits_, threads_;
};

class CutSorter {
 public:
  static constexpr std::uint16_t same_point = std::numeric_limits<std::uint16_t>::max();

  CutSorter(std::span<const Point2> points, unsigned threads, const Progress& progress)
      : points_(points),
        threads_(threads),
        progress_(progress),
        items_(large_vector<Item>(points.size())),
        scratch_(large_vector<Item>(points.size())),
        cut_depth_(points.size()) {
    for (std::size_t i = 0; i < items_.size(); ++i) items_[i].index = static_cast<std::uint32_t>(i);
  }

  bool sort() { return sort(0, items_.size(), 0, 0); }
  [[nodiscard]] CutOrder take();

 private:
  /// Sort items [begin, end) by cuts of depth `depth` (even) and more.
  bool sort(std::size_t begin, std::size_t end, unsigned depth, unsigned nesting);
  bool cut_between_cells(std::size_t begin, std::size_t end, unsigned bits, unsigned depth, unsigned nesting);
  void sort_by_coordinates(std::size_t begin, std::size_t end, unsigned depth);
  void halve(std::span<const std::size_t> starts, unsigned depth);
  [[nodiscard]] std::pair<Point2, Point2> bounding_box(std::size_t begin, std::size_t end) const;

  std::span<const Point2> points_;
  unsigned threads_;
  const Progress& progress_;
  std::vector<Item> items_, scratch_;
  std::vector<std::uint16_t> cut_depth_;
};

std::pair<Point2, Point2> CutSorter::bounding_box(std::size_t begin, std::size_t end) const {
  Point2 low = points_[items_[begin].index], high = low;
  for (std::size_t i = begin; i < end; ++i) {
    const Point2 p = points_[items_[i].index];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low, high};
}

bool CutSorter::sort(std::size_t begin, std::size_t end, unsigned depth, unsigned nesting) {
  constexpr std::size_t few = 64;
  constexpr unsigned deepest_nesting =
      8;  // beyond, points are sorted at a cost that does not depend on where they lie
  const std::size_t n = end - begin;
  if (n <= few || nesting > deepest_nesting) {
    sort_by_coordinates(begin, end, depth);
    return true;
  }
  // Many cells a point, so that few points share one even where they lie along a curve.
  const unsigned bits = std::min(16U, (static_cast<unsigned>(std::bit_width(n)) + 9) / 2);
  const auto [low, high] = bounding_box(begin, end);
  const Grid grid(low, high, bits);
  if (!grid.divides()) {
    sort_by_coordinates(begin, end, depth);
    return true;
  }
  parallel_for_indices(begin, end, threads_,
                       [&](std::size_t i) { items_[i].key = grid.key(points_[items_[i].index]); });
  const std::span items = std::span(items_).subspan(begin, n);
  constexpr std::size_t worth_counting = 4096;
  if (n < worth_counting) {
    std::ranges::sort(items,
                      [](Item a, Item b) { return a.key != b.key ? a.key < b.key : a.index < b.index; });
  } else if (!RadixSort(2 * bits, threads_)(items, std::span(scratch_).subspan(begin, n), progress_)) {
    return false;
  }
  return cut_between_cells(begin, end, bits, depth, nesting);
}

/// Items [begin, end) are sorted by their keys of 2 `bits` bits: put the cuts between different keys, and sort those
/// that share one.
bool CutSorter::cut_between_cells(std::size_t begin, std::size_t end, unsigned bits, unsigned depth,
                                  unsigned nesting) {
  // Slices that begin with a key; what lies before is looked up first, because sorting below overwrites keys.
  struct Slice {
    std::size_t first;
    std::uint32_t key_before;
  };
  std::vector<Slice> slices{{begin, 0}};
  for (std::size_t i = begin + slice_size; i < end; i = slices.back().first + slice_size) {
    while (i < end && items_[i].key == items_[i - 1].key) ++i;
    slices.push_back({i, items_[i - 1].key});
  }
  std::atomic<bool> stopped{false};
  parallel_for_blocks(slices.size(), threads_, [&](std::size_t k) {
    std::uint32_t key_before = slices[k].key_before;
    const std::size_t slice_end = k + 1 < slices.size() ? slices[k + 1].first : end;
    if (progress_.stop_requested()) stopped = true;
    for (std::size_t first = slices[k].first; first < slice_end && !stopped;) {
      const std::uint32_t key = items_[first].key;
      std::size_t last = first + 1;
      while (last < slice_end && items_[last].key == key) ++last;
      if (first > begin) {
        const auto shared_bits = static_cast<unsigned>(std::countl_zero(key ^ key_before)) - (32 - 2 * bits);
        cut_depth_[first] = static_cast<std::uint16_t>(depth + shared_bits);
      }
      if (last - first > 1 && !sort(first, last, depth + 2 * bits, nesting + 1)) stopped = true;
      key_before = key;
      first = last;
    }
  });
  return !stopped;
}

/// Lexicographically, equal points by index; cut in halves by x.
void CutSorter::sort_by_coordinates(std::size_t begin, std::size_t end, unsigned depth) {
  struct Placed {
    Point2 point;
    std::uint32_t index;
  };
  std::vector<Placed> placed;  // side by side, because sorting looks at each many times
  placed.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) placed.push_back({points_[items_[i].index], items_[i].index});
  std::ranges::sort(placed, [](const Placed& p, const Placed& q) {
    return p.point < q.point || (p.point == q.point && p.index < q.index);
  });
  std::vector<std::size_t> starts;  // of each place the first of its points
  for (std::size_t k = 0; k < placed.size(); ++k) {
    items_[begin + k].index = placed[k].index;
    if (k > 0 && placed[k].point == placed[k - 1].point)
      cut_depth_[begin + k] = same_point;
    else
      starts.push_back(begin + k);
  }
  halve(starts, depth);
}

/// Cut before the middle one of items that begin a place, then both halves.
void CutSorter::halve(std::span<const std::size_t> starts, unsigned depth) {
  if (starts.size() < 2) return;
  const std::size_t middle = starts.size() / 2;
  cut_depth_[starts[middle]] = static_cast<std::uint16_t>(depth);
  halve(starts.first(middle), depth + 2);
  halve(starts.subspan(middle), depth + 2);
}

CutOrder CutSorter::take() {
  release(scratch_);
  const std::size_t n = items_.size();
  // Equal points move up to the first of them, which has the lowest index.
  CutOrder order;
  SortedPoints& sorted = order.sorted;
  sorted.sorted_index.resize(n);
  std::size_t distinct = 0;
  if (std::ranges::find(cut_depth_, same_point) == cut_depth_.end()) {
    parallel_for_indices(0, n, threads_, [&](std::size_t i) {
      sorted.sorted_index[items_[i].index] = static_cast<std::uint32_t>(i);
    });
    distinct = n;
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      if (cut_depth_[i] != same_point) {
        cut_depth_[distinct] = cut_depth_[i];
        items_[distinct++].index = items_[i].index;
      }
      sorted.sorted_index[items_[i].index] = static_cast<std::uint32_t>(distinct - 1);
    }
  }
  sorted.points = large_vector<Point2>(distinct);
  sorted.first_input.resize(distinct);
  parallel_for_indices(0, distinct, threads_, [&](std::size_t i) {
    sorted.first_input[i] = items_[i].index;
    sorted.points[i] = points_[items_[i].index];
  });
  cut_depth_.resize(distinct);
  order.cut_depth = std::move(cut_depth_);
  return order;
}

}  // namespace

std::optional<CutOrder> sort_by_cuts(std::span<const Point2> points, unsigned threads,
                                     const Progress& progress) {
  CutSorter sorter(points, threads, progress);
  if (!sorter.sort()) return std::nullopt;
  return sorter.take();
}

}  // namespace leonhard::delaunay
