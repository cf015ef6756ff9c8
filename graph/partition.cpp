// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using Indices = std::span<std::uint32_t>;

/// Parts [first, first + count) and how many vertices they take together. Part k of n vertices among `all`
/// parts takes floor(n / all) of them, the first n mod all parts one more.
struct PartRange {
  std::uint32_t first, count;
  std::uint32_t all;
  std::size_t n;

  [[nodiscard]] std::size_t vertices() const {
    const std::size_t extra = n % all;
    const std::size_t begin = std::min<std::size_t>(first, extra);
    const std::size_t end = std::min<std::size_t>(first + std::size_t{count}, extra);
    return n / all * count + (end - begin);
  }
  [[nodiscard]] PartRange lower() const { return {first, count / 2, all, n}; }
  [[nodiscard]] PartRange upper() const { return {first + count / 2, count - count / 2, all, n}; }
};

/// Splits recursively. `arrange(vertices, k)` puts in front the k vertices that the lower parts shall get.
template <class Arrange>
void bisect(Indices vertices, PartRange range, std::vector<std::uint32_t>& part_of, const Arrange& arrange) {
  if (vertices.empty()) return;
  if (range.count == 1) {
    for (const std::uint32_t v : vertices) part_of[v] = range.first;
    return;
  }
  const std::size_t in_front = range.lower().vertices();
  if (in_front > 0 && in_front < vertices.size()) arrange(vertices, in_front);
  bisect(vertices.first(in_front), range.lower(), part_of, arrange);
  bisect(vertices.subspan(in_front), range.upper(), part_of, arrange);
}

template <class Arrange>
Partition recursive_bisection(std::size_t n, std::uint32_t parts, const Arrange& arrange) {
  Partition result;
  result.parts = parts;
  result.part_of.resize(n);
  if (parts > n) result.outcome = PartitionOutcome::empty_parts;
  std::vector<std::uint32_t> vertices(n);
  std::iota(vertices.begin(), vertices.end(), 0U);
  bisect(Indices(vertices), PartRange{0, parts, parts, n}, result.part_of, arrange);
  return result;
}

void check_parts(std::uint32_t parts) {
  if (parts == 0) throw InputError("parts", "a partition into 0 parts", "ask for at least 1");
}

/// Splits vertices of one graph by Fiedler vectors of the pieces.
class SpectralArrangement {
 public:
  SpectralArrangement(const CsrGraph& graph, std::uint64_t seed, const Progress& progress,
                      std::uint32_t parts)
      : extract_(graph), seed_(seed), progress_(progress), splits_(std::min(parts, vertex_count(graph))) {}

  void operator()(Indices vertices, std::size_t in_front) {
    progress_("spectral bisection", static_cast<double>(done_++) / splits_);
    if (progress_.stop_requested()) stopped_ = true;
    if (stopped_) return;         // the vertices stay as they lie: a valid split, not a good one
    std::ranges::sort(vertices);  // the piece, not the way to it, decides
    const CsrGraph piece = extract_(vertices);
    const Components pieces = components(piece);
    if (pieces.count() == 1)
      order_by_fiedler(piece, vertices);
    else
      deal_components(pieces, vertices, in_front);
  }

  [[nodiscard]] bool was_stopped() const { return stopped_; }

 private:
  void order_by_fiedler(const CsrGraph& piece, Indices vertices) {
    FiedlerOptions options;
    options.tolerance = 1e-4;  // on meshes 1e-7 yields the same cuts
    options.seed = seed_;
    options.stop = progress_.stop;
    const Fiedler pair = fiedler(piece, options);
    if (pair.outcome == FiedlerOutcome::stopped) stopped_ = true;
    std::vector<std::pair<double, std::uint32_t>> keyed;
    keyed.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) keyed.emplace_back(pair.vector[i], vertices[i]);
    std::ranges::sort(keyed);
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = keyed[i].second;
  }

  /// Largest component first, each whole to the side that has room; one that fits neither side fills up the
  /// front.
  void deal_components(const Components& pieces, Indices vertices, std::size_t in_front) {
    std::vector<std::vector<std::uint32_t>> members(pieces.count());
    for (std::size_t i = 0; i < vertices.size(); ++i) members[pieces.component_of[i]].push_back(vertices[i]);
    std::ranges::stable_sort(members, std::ranges::greater{}, &std::vector<std::uint32_t>::size);
    std::vector<std::uint32_t> front, back;
    for (std::vector<std::uint32_t>& component : members) {
      std::size_t to_front = 0;
      if (front.size() + component.size() <= in_front)
        to_front = component.size();
      else if (back.size() + component.size() > vertices.size() - in_front) {
        to_front = in_front - front.size();
        order_by_fiedler(extract_(component), component);
      }
      const auto cut = component.begin() + static_cast<std::ptrdiff_t>(to_front);
      front.insert(front.end(), component.begin(), cut);
      back.insert(back.end(), cut, component.end());
    }
    std::ranges::copy(back, std::ranges::copy(front, vertices.begin()).out);
  }

  SubgraphExtractor extract_;
  std::uint64_t seed_;
  const Progress& progress_;
  std::uint32_t splits_;
  std::uint32_t done_ = 0;
  bool stopped_ = false;
};

}  // namespace

Partition recursive_coordinate_bisection(std::span<const Point2> points, std::uint32_t parts) {
  check_parts(parts);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InputError("points",
                       "point " + std::to_string(i) + " is (" + std::to_string(points[i].x) + ", " +
                           std::to_string(points[i].y) + ")",
                       "give finite coordinates");
  return recursive_bisection(points.size(), parts, [&](Indices vertices, std::size_t in_front) {
    Point2 low = points[vertices[0]], high = low;
    for (const std::uint32_t v : vertices) {
      low = {std::min(low.x, points[v].x), std::min(low.y, points[v].y)};
      high = {std::max(high.x, points[v].x), std::max(high.y, points[v].y)};
    }
    // Halved, so that no finite box overflows.
    const bool along_x = high.x / 2 - low.x / 2 >= high.y / 2 - low.y / 2;
    const auto key = [&](std::uint32_t v) {
      const Point2 p = points[v];
      return along_x ? std::tuple(p.x, p.y, v) : std::tuple(p.y, p.x, v);
    };
    std::ranges::nth_element(vertices, vertices.begin() + static_cast<std::ptrdiff_t>(in_front), {}, key);
  });
}

Partition recursive_spectral_bisection(const CsrGraph& graph, std::uint32_t parts, std::uint64_t seed,
                                       const Progress& progress) {
  check_parts(parts);
  SpectralArrangement arrangement(graph, seed, progress, parts);
  Partition result =
      recursive_bisection(vertex_count(graph), parts,
                          [&](Indices vertices, std::size_t in_front) { arrangement(vertices, in_front); });
  if (arrangement.was_stopped()) result.outcome = PartitionOutcome::stopped;
  return result;
}

}  // namespace leonhard::graph
