// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/arrange.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "leonhard/delaunay/constrained/domain.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/implicit_point.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/box_tree.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

using Points = std::vector<Point2>;
using Segments = std::vector<Pslg::Segment>;

bool have_opposite_signs(Sign a, Sign b) {
  return (a == Sign::positive && b == Sign::negative) || (a == Sign::negative && b == Sign::positive);
}

/// Whether the open segments ab and cd have one point in common and are not on one line.
bool do_cross(Point2 a, Point2 b, Point2 c, Point2 d) {
  return have_opposite_signs(kernel::orient2d(a, b, c), kernel::orient2d(a, b, d)) &&
         have_opposite_signs(kernel::orient2d(c, d, a), kernel::orient2d(c, d, b));
}

mesh::Box2 box_of(const Points& points, const Pslg::Segment& s) {
  mesh::Box2 box;
  box.include(points[s.from]);
  box.include(points[s.to]);
  return box;
}

/// Near segments next to each other.
std::vector<std::uint32_t> order_in_space(const Points& points, const Segments& segments) {
  std::vector<Point2> middles;
  middles.reserve(segments.size());
  for (const Pslg::Segment& s : segments) {
    const Point2 a = points[s.from], b = points[s.to];
    middles.push_back({0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y});
  }
  return kernel::hilbert_order(middles);
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// The pairs of segments that cross, the smaller index first, ascending; not all of them if there are more than `most`.
/// is_new  one entry a segment: only pairs with a new one are looked for; all where it is empty
std::vector<Pair> crossing_pairs(const Points& points, const Segments& segments, const std::vector<bool>& is_new,
                                 std::size_t most, const Progress& progress) {
  const std::vector<std::uint32_t> order = order_in_space(points, segments);
  std::vector<mesh::Box2> boxes;
  boxes.reserve(segments.size());
  for (const std::uint32_t i : order) boxes.push_back(box_of(points, segments[i]));
  const mesh::BoxTree<Point2> tree(boxes);
  std::vector<Pair> pairs;
  const auto look_at = [&](std::uint32_t i, std::uint32_t j) {
    const Pslg::Segment &s = segments[i], &t = segments[j];
    if (s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to) return;
    if (do_cross(points[s.from], points[s.to], points[t.from], points[t.to])) pairs.emplace_back(std::min(i, j), std::max(i, j));
  };
  if (is_new.empty()) {
    tree.for_each_meeting_pair_until([&](std::size_t i, std::size_t j) {
      look_at(order[i], order[j]);
      return pairs.size() > most || progress.stop_requested();
    });
  } else {
    for (std::size_t i = 0; i < order.size() && pairs.size() <= most && !progress.stop_requested(); ++i) {
      if (!is_new[order[i]]) continue;
      tree.for_each_meeting(boxes[i], [&](std::size_t j) {
        if (j != i && (j > i || !is_new[order[j]])) look_at(order[i], order[j]);
      });
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

kernel::LineCrossing crossing_of(const Points& points, const Pslg::Segment& s, const Pslg::Segment& t) {
  return {points[s.from], points[s.to], points[t.from], points[t.to]};
}

/// Where a segment is to be cut: by which other one, at which of the new points.
struct Cut {
  std::uint32_t segment, by;
  std::size_t point;
};

/// The cuts of one segment from its first point to its last.
void sort_along(const Points& points, const Segments& segments, std::span<Cut> cuts) {
  if (cuts.size() < 2) return;
  const Pslg::Segment& s = segments[cuts[0].segment];
  std::vector<kernel::LineCrossing> exact;
  exact.reserve(cuts.size());
  for (const Cut& cut : cuts) exact.push_back(crossing_of(points, s, segments[cut.by]));
  std::vector<std::size_t> order(cuts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const Sign ahead = points[s.from] < points[s.to] ? Sign::negative : Sign::positive;
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return kernel::compare_xy(exact[i], exact[j]) == ahead; });
  std::vector<Cut> sorted;
  for (const std::size_t i : order) sorted.push_back(cuts[i]);
  std::ranges::copy(sorted, cuts.begin());
}

/// One round: all crossings of `pairs` become points, and the segments are cut in them.
class Splitter {
 public:
  explicit Splitter(Arrangement& arrangement) : a_(arrangement), points_(a_.graph.points), segments_(a_.graph.segments) {}

  /// One entry a segment of the new graph: whether it is a piece of one that was cut.
  std::vector<bool> split(const std::vector<Pair>& pairs) {
    add_points(pairs);
    std::vector<Cut> cuts;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      cuts.push_back({pairs[k].first, pairs[k].second, point_of_[k]});
      cuts.push_back({pairs[k].second, pairs[k].first, point_of_[k]});
    }
    std::ranges::stable_sort(cuts, {}, &Cut::segment);
    Segments pieces;
    std::vector<SegmentId> segment_of;
    std::vector<bool> is_new;
    auto cut = cuts.begin();
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      const auto first = cut;
      while (cut != cuts.end() && cut->segment == i) ++cut;
      sort_along(points_, segments_, {first, cut});
      std::size_t from = segments_[i].from;
      const auto add = [&](std::size_t to) {
        if (points_[from] == points_[to] && first != cut) return;
        pieces.push_back({from, to, segments_[i].marker});
        segment_of.push_back(a_.segment_of[i]);
        is_new.push_back(first != cut);
        from = to;
      };
      for (auto c = first; c != cut; ++c) add(c->point);
      add(segments_[i].to);
    }
    segments_ = std::move(pieces);
    a_.segment_of = std::move(segment_of);
    return is_new;
  }

 private:
  /// Each place once, in lexicographic order.
  void add_points(const std::vector<Pair>& pairs) {
    const std::size_t first = points_.size();
    std::vector<Point2> places;
    for (const auto& [i, j] : pairs) {
      const kernel::RoundedPoint2 p = kernel::rounded(crossing_of(points_, segments_[i], segments_[j]));
      places.push_back(p.point);
      const std::size_t one = a_.segment_of[i].index(), other = a_.segment_of[j].index();
      a_.crossings.push_back({std::min(one, other), std::max(one, other), p.point, p.error});
    }
    std::vector<Point2> sorted = places;
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    point_of_.clear();
    for (const Point2 p : places)
      point_of_.push_back(first + static_cast<std::size_t>(std::ranges::lower_bound(sorted, p) - sorted.begin()));
    points_.insert(points_.end(), sorted.begin(), sorted.end());
    if (a_.graph.point_markers.empty()) return;
    a_.graph.point_markers.resize(points_.size(), 0);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      for (const std::uint32_t i : {pairs[k].first, pairs[k].second})
        if (a_.graph.point_markers[point_of_[k]] == 0) a_.graph.point_markers[point_of_[k]] = segments_[i].marker;
  }

  Arrangement& a_;
  Points& points_;
  Segments& segments_;
  std::vector<std::size_t> point_of_;  // one a pair
};

Arrangement as_it_is(const Pslg& pslg) {
  Arrangement arrangement{.graph = pslg, .segment_of = {}, .crossings = {}, .skipped = {}};
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) arrangement.segment_of.push_back(SegmentId::from(i));
  return arrangement;
}

Crossing crossing_at(const Pslg& pslg, std::size_t one, std::size_t other) {
  const kernel::RoundedPoint2 p = kernel::rounded(crossing_of(pslg.points, pslg.segments[one], pslg.segments[other]));
  return {one, other, p.point, p.error};
}

std::string words_of(const Crossing& c) {
  return "segments " + std::to_string(c.one) + " and " + std::to_string(c.other) + " cross at " + mesh::words(c.point);
}

/// With the ends of both.
std::string words_of(const Pslg& pslg, const Crossing& c) {
  const auto name = [&](std::size_t i) {
    const Pslg::Segment& s = pslg.segments[i];
    return "segment " + std::to_string(i) + " (point " + std::to_string(s.from) + " at " + mesh::words(pslg.points[s.from]) +
           " to point " + std::to_string(s.to) + " at " + mesh::words(pslg.points[s.to]) + ")";
  };
  return name(c.one) + " and " + name(c.other) + " cross at " + mesh::words(c.point);
}

}  // namespace

std::vector<Crossing> find_crossings(const Pslg& pslg, const Progress& progress) {
  check(pslg);
  std::vector<Crossing> crossings;
  for (const auto& [i, j] : crossing_pairs(pslg.points, pslg.segments, {}, any_number, progress))
    crossings.push_back(crossing_at(pslg, i, j));
  return crossings;
}

Arrangement split_crossings(const Pslg& pslg, const Progress& progress) {
  constexpr int most_rounds = 64;
  constexpr std::size_t most_split = 5'000'000;
  Arrangement arrangement = as_it_is(pslg);
  std::vector<bool> is_new;
  for (int round = 0; round < most_rounds; ++round) {
    progress("cross", 0);
    const std::vector<Pair> pairs =
        crossing_pairs(arrangement.graph.points, arrangement.graph.segments, is_new, most_split, progress);
    if (pairs.size() > most_split)
      throw InputError(pslg.source, "segments cross more than " + std::to_string(most_split) + " times",
                       "these are no outlines: look whether the points are in order");
    if (pairs.empty() || progress.stop_requested()) {
      std::ranges::sort(arrangement.crossings, {}, [](const Crossing& c) { return std::tuple(c.one, c.other, c.point); });
      return arrangement;
    }
    is_new = Splitter(arrangement).split(pairs);
  }
  throw InputError(pslg.source, words_of(arrangement.crossings.back()) + ", and their rounded crossings do not come to an end",
                   "add the crossing as a point that both segments end in (counted from 0)");
}

Arrangement skip_crossings(const Pslg& pslg, const Progress& progress) {
  const Arrangement whole = as_it_is(pslg);
  Arrangement arrangement = whole;
  arrangement.graph.segments.clear();
  arrangement.segment_of.clear();
  std::vector<bool> is_left_out(pslg.segments.size(), false);
  std::vector<Pair> later_first;
  for (const auto& [i, j] : crossing_pairs(pslg.points, pslg.segments, {}, any_number, progress)) later_first.emplace_back(j, i);
  std::ranges::sort(later_first);
  for (const auto& [later, earlier] : later_first)
    if (!is_left_out[earlier]) is_left_out[later] = true;
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const SegmentId id = SegmentId::from(i);
    if (is_left_out[i]) {
      arrangement.skipped.push_back(id);
      continue;
    }
    arrangement.graph.segments.push_back(pslg.segments[i]);
    arrangement.segment_of.push_back(id);
  }
  return arrangement;
}

void refuse_crossings(const Pslg& pslg, const Progress& progress) {
  constexpr std::size_t named = 100, counted = 100'000;
  const std::vector<Pair> pairs = crossing_pairs(pslg.points, pslg.segments, {}, counted, progress);
  std::string problem;
  for (std::size_t k = 0; k < std::min(named, pairs.size()); ++k)
    problem += (k == 0 ? "" : ", ") + words_of(pslg, crossing_at(pslg, pairs[k].first, pairs[k].second));
  if (pairs.size() > named)
    problem += ", and " + std::string(pairs.size() > counted ? "more than " : "") +
               std::to_string(std::min(pairs.size(), counted) - named) + " more do";
  if (pairs.empty()) problem = "segments cross";  // a stop was requested while they were looked for
  throw InputError(pslg.source, problem,
                   "make the outlines disjoint, add each crossing as a point that both segments end in, or have them split "
                   "(counted from 0)");
}

void note_crossings(const Arrangement& arrangement, std::vector<std::string>& repairs) {
  constexpr std::size_t named = 10;
  const std::vector<Crossing>& crossings = arrangement.crossings;
  for (std::size_t i = 0; i < std::min(named, crossings.size()); ++i)
    repairs.push_back(words_of(crossings[i]) + ": a point was added there (counted from 0)");
  if (crossings.size() > named) {
    const double error = std::ranges::max(crossings, {}, &Crossing::error).error;
    repairs.push_back(std::to_string(crossings.size() - named) +
                      " more crossings became points, all within " + mesh::words(error) + " of the exact ones");
  }
  for (std::size_t i = 0; i < std::min(named, arrangement.skipped.size()); ++i)
    repairs.push_back("segment " + std::to_string(arrangement.skipped[i].index()) +
                      " left out: it crosses an earlier one (counted from 0)");
  if (arrangement.skipped.size() > named)
    repairs.push_back(std::to_string(arrangement.skipped.size() - named) + " more segments left out");
}

}  // namespace leonhard::delaunay
