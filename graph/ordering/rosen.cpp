// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "leonhard/graph/ordering.hpp"

namespace leonhard::graph {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Edges by width, which is how far apart their ends are numbered. An edge whose width changed is filed again; the old
/// entry stays and is passed over when it is met.
class EdgesByWidth {
 public:
  explicit EdgesByWidth(std::uint32_t vertices) : filed_(vertices) {}

  void file(Edge edge, std::uint32_t width) { filed_[width].push_back(edge); }

  /// A widest edge, or none if there are no edges. width_of(Edge) is its present width.
  template <class WidthOf>
  std::optional<Edge> widest(const WidthOf& width_of) {
    for (; !filed_.empty(); filed_.pop_back())
      while (!filed_.back().empty()) {
        const Edge edge = filed_.back().back();
        if (width_of(edge) + std::size_t{1} == filed_.size()) return edge;
        filed_.back().pop_back();
      }
    return std::nullopt;
  }

 private:
  std::vector<std::vector<Edge>> filed_;  ///< by width; no edge is wider than the last
};

class Rosen {
 public:
  Rosen(const CsrGraph& graph, std::span<const std::uint32_t> start)
      : graph_(graph),
        order_(start.begin(), start.end()),
        number_(invert(start)),
        edges_(vertex_count(graph)) {}

  [[nodiscard]] RosenResult run(const Progress& progress) {
    RosenResult result;
    bool stopped = false;
    const auto stop = [&] { return stopped = stopped || progress.stop_requested(); };
    for (std::uint32_t v = 0; v < vertex_count(graph_) && !stop(); ++v) file_edges_of(v);
    while (!stop()) {
      const auto critical = edges_.widest([&](const Edge& e) { return width(e); });
      if (!critical || !improve(*critical)) break;
      ++result.exchanges;
    }
    if (stopped) result.outcome = OrderOutcome::stopped;
    result.order = std::move(order_);
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t width(const Edge& e) const {
    const std::uint32_t a = number_[e[0]], b = number_[e[1]];
    return a < b ? b - a : a - b;
  }

  void file_edges_of(std::uint32_t v) {
    for (const std::uint32_t w : neighbours(graph_, v))
      if (const Edge e{v, w}; number_[v] < number_[w])
        edges_.file(e, width(e));
      else
        edges_.file({w, v}, width(e));
  }

  /// Steps 2 and 3 of the notes: exchange one end of the critical edge so that it becomes narrower and nothing wider
  /// than `allowed` appears.
  bool improve(const Edge& critical) {
    Edge ends = critical;
    if (number_[ends[0]] > number_[ends[1]]) std::swap(ends[0], ends[1]);
    const std::uint32_t bandwidth = width(ends);
    for (const std::uint32_t allowed : {bandwidth - 1, bandwidth})
      for (const std::uint32_t end : ends)
        if (const auto partner = find_partner(end, ends, allowed, allowed == bandwidth)) {
          exchange(end, *partner);
          return true;
        }
    return false;
  }

  /// Whom to exchange with: somebody numbered between the ends, the furthest first.
  [[nodiscard]] std::optional<std::uint32_t> find_partner(std::uint32_t end, const Edge& ends,
                                                          std::uint32_t allowed, bool must_narrow) const {
    const bool rises = end == ends[0];
    const std::uint32_t low = number_[ends[0]], high = number_[ends[1]];
    for (std::uint32_t step = 1; step < high - low; ++step) {
      const std::uint32_t to = rises ? low + step : high - step;
      if (!fits(end, to, order_[to], allowed)) continue;
      if (!fits(order_[to], number_[end], end, allowed)) continue;
      if (!must_narrow || narrows(end, order_[to])) return order_[to];
    }
    return std::nullopt;
  }

  /// Whether no edge of v would be wider than allowed with v numbered `to` and `other` numbered as v is now.
  [[nodiscard]] bool fits(std::uint32_t v, std::uint32_t to, std::uint32_t other,
                          std::uint32_t allowed) const {
    return std::ranges::all_of(neighbours(graph_, v), [&](std::uint32_t w) {
      const std::uint32_t at = w == other ? number_[v] : number_[w];
      return (at < to ? to - at : at - to) <= allowed;
    });
  }

  /// Whether the squares of all widths would have a smaller sum: exchanges that keep the bandwidth must end.
  [[nodiscard]] bool narrows(std::uint32_t a, std::uint32_t b) const {
    const auto change = [&](std::uint32_t v, std::uint32_t to, std::uint32_t other) {
      double sum = 0;
      for (const std::uint32_t w : neighbours(graph_, v)) {
        if (w == other) continue;  // their own edge keeps its width
        const auto at = static_cast<double>(number_[w]);
        const double before = at - number_[v], after = at - to;
        sum += after * after - before * before;
      }
      return sum;
    };
    return change(a, number_[b], b) + change(b, number_[a], a) < 0;
  }

  void exchange(std::uint32_t a, std::uint32_t b) {
    std::swap(number_[a], number_[b]);
    order_[number_[a]] = a;
    order_[number_[b]] = b;
    file_edges_of(a);
    file_edges_of(b);
  }

  const CsrGraph& graph_;
  std::vector<std::uint32_t> order_, number_;
  EdgesByWidth edges_;
};

}  // namespace

RosenResult rosen(const CsrGraph& graph, std::span<const std::uint32_t> start, const Progress& progress) {
  detail::check_order(graph, start);
  return Rosen(graph, start).run(progress);
}

}  // namespace leonhard::graph
