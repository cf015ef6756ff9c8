// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/connected_parts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace leonhard::graph::detail {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The connected pieces of all parts.
struct Pieces {
  std::vector<std::uint32_t> piece_of;  ///< per vertex
  std::vector<std::int64_t> weight;     ///< per piece
  std::vector<std::uint32_t> part;      ///< per piece
};

Pieces pieces_of(const KwayGraph& graph, const std::vector<std::uint32_t>& part_of) {
  Pieces result{std::vector<std::uint32_t>(graph.size(), none), {}, {}};
  std::vector<std::uint32_t> stack;
  for (std::uint32_t root = 0; root < graph.size(); ++root) {
    if (result.piece_of[root] != none) continue;
    const auto piece = static_cast<std::uint32_t>(result.part.size());
    result.part.push_back(part_of[root]);
    result.weight.push_back(0);
    result.piece_of[root] = piece;
    stack.push_back(root);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      result.weight[piece] += graph.vertex_weight[v];
      for (const Arc& arc : graph.row(v))
        if (result.piece_of[arc.to] == none && part_of[arc.to] == part_of[v]) {
          result.piece_of[arc.to] = piece;
          stack.push_back(arc.to);
        }
    }
  }
  return result;
}

class Connector {
 public:
  Connector(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
            std::vector<std::uint32_t>& part_of, const std::stop_token& stop)
      : graph_(graph), parts_(parts), limit_(limit), part_of_(part_of), stop_(stop), seen_(graph.size(), 0) {}

  bool operator()() {
    if (!join_loose_pieces()) return false;
    weight_ = part_weights(graph_, part_of_, parts_);
    for (std::uint32_t part = 0; part < parts_; ++part)
      while (weight_[part] > limit_)
        if (stop_.stop_requested() || !relieve(part)) return false;
    return true;
  }

 private:
  /// returns  false if a piece touches no part's main piece, whatever is joined first
  bool join_loose_pieces() {
    const Pieces pieces = pieces_of(graph_, part_of_);
    std::vector<std::uint32_t> main(parts_, none);  // per part its heaviest piece
    for (std::uint32_t i = 0; i < pieces.part.size(); ++i) {
      std::uint32_t& heaviest = main[pieces.part[i]];
      if (heaviest == none || pieces.weight[i] > pieces.weight[heaviest]) heaviest = i;
    }
    std::vector<std::vector<std::uint32_t>> loose;  // their vertices
    std::vector<std::uint32_t> place(pieces.part.size(), none);
    for (std::uint32_t v = 0; v < graph_.size(); ++v) {
      const std::uint32_t piece = pieces.piece_of[v];
      if (main[part_of_[v]] == piece) continue;
      if (place[piece] == none) {
        place[piece] = static_cast<std::uint32_t>(loose.size());
        loose.emplace_back();
      }
      loose[place[piece]].push_back(v);
    }
    for (const auto& piece : loose)
      for (const std::uint32_t v : piece) part_of_[v] = none;
    while (!loose.empty()) {
      const std::size_t before = loose.size();
      std::erase_if(loose, [&](const auto& piece) { return join(piece); });
      if (loose.size() == before) return false;
    }
    return true;
  }

  bool join(const std::vector<std::uint32_t>& piece) {
    std::vector<std::pair<std::uint32_t, std::int64_t>> edges_to;  // part, weight
    for (const std::uint32_t v : piece)
      for (const Arc& arc : graph_.row(v))
        if (part_of_[arc.to] != none) edges_to.emplace_back(part_of_[arc.to], arc.weight);
    if (edges_to.empty()) return false;
    std::ranges::sort(edges_to);
    std::pair<std::int64_t, std::uint32_t> best{0, none};
    for (std::size_t i = 0; i < edges_to.size();) {
      const std::uint32_t part = edges_to[i].first;
      std::int64_t sum = 0;
      for (; i < edges_to.size() && edges_to[i].first == part; ++i) sum += edges_to[i].second;
      if (sum > best.first) best = {sum, part};
    }
    for (const std::uint32_t v : piece) part_of_[v] = best.second;
    return true;
  }

  /// Hands one vertex on from a part that is too heavy, and one from each part on the way to one with room.
  bool relieve(std::uint32_t heavy) {
    const std::vector<std::vector<std::uint32_t>> beside = parts_beside();
    std::vector<std::uint32_t> from(parts_, none), queue{heavy};
    from[heavy] = heavy;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const std::uint32_t part = queue[i];
      if (weight_[part] < limit_ && hand_on(from, heavy, part)) return true;
      for (const std::uint32_t next : beside[part])
        if (from[next] == none) {
          from[next] = part;
          queue.push_back(next);
        }
    }
    return false;
  }

  [[nodiscard]] std::vector<std::vector<std::uint32_t>> parts_beside() const {
    std::vector<std::vector<std::uint32_t>> beside(parts_);
    for (std::uint32_t v = 0; v < graph_.size(); ++v)
      for (const Arc& arc : graph_.row(v))
        if (part_of_[arc.to] != part_of_[v]) beside[part_of_[v]].push_back(part_of_[arc.to]);
    for (auto& list : beside) {
      std::ranges::sort(list);
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return beside;
  }

  /// Along the way found, from its end: each part takes a vertex of the one before. Undone if some part cannot.
  bool hand_on(const std::vector<std::uint32_t>& from, std::uint32_t heavy, std::uint32_t last) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> done;  // vertex, its part before
    const std::int64_t excess = weight_[heavy];
    for (std::uint32_t to = last; to != heavy; to = from[to]) {
      const std::uint32_t v = vertex_to_give(from[to], to);
      if (v == none) break;
      done.emplace_back(v, from[to]);
      move(v, to);
    }
    bool better = weight_[heavy] < excess;
    for (std::uint32_t to = last; to != heavy; to = from[to]) better = better && weight_[to] <= limit_;
    if (!better)
      for (auto step = done.rbegin(); step != done.rend(); ++step) move(step->first, step->second);
    return better;
  }

  void move(std::uint32_t v, std::uint32_t to) {
    weight_[part_of_[v]] -= graph_.vertex_weight[v];
    weight_[to] += graph_.vertex_weight[v];
    part_of_[v] = to;
  }

  /// The vertex of a part with the best gain in going to another, without which the part stays connected.
  std::uint32_t vertex_to_give(std::uint32_t part, std::uint32_t to) {
    std::vector<std::pair<std::int64_t, std::uint32_t>> candidates;  // minus gain, vertex
    for (std::uint32_t v = 0; v < graph_.size(); ++v) {
      if (part_of_[v] != part) continue;
      std::int64_t out = 0, in = 0;
      for (const Arc& arc : graph_.row(v)) {
        out += part_of_[arc.to] == to ? arc.weight : 0;
        in += part_of_[arc.to] == part ? arc.weight : 0;
      }
      if (out > 0) candidates.emplace_back(in - out, v);
    }
    std::ranges::sort(candidates);
    for (const auto& [loss, v] : candidates)
      if (can_leave(v)) return v;
    return none;
  }

  /// Whether the other vertices of v's part, of which there are some, hold together without v.
  bool can_leave(std::uint32_t v) {
    ++search_;
    std::size_t to_reach = 0;
    std::vector<std::uint32_t> queue;
    for (const Arc& arc : graph_.row(v))
      if (part_of_[arc.to] == part_of_[v]) {
        ++to_reach;
        if (queue.empty()) queue.push_back(arc.to);
      }
    if (queue.empty()) return false;
    seen_[v] = seen_[queue[0]] = search_;
    const auto is_beside_v = [&](std::uint32_t u) {
      return std::ranges::any_of(graph_.row(u), [&](const Arc& arc) { return arc.to == v; });
    };
    --to_reach;
    for (std::size_t i = 0; i < queue.size() && to_reach > 0; ++i)
      for (const Arc& arc : graph_.row(queue[i])) {
        if (seen_[arc.to] == search_ || part_of_[arc.to] != part_of_[v]) continue;
        seen_[arc.to] = search_;
        queue.push_back(arc.to);
        if (is_beside_v(arc.to)) --to_reach;
      }
    return to_reach == 0;
  }

  const KwayGraph& graph_;
  std::uint32_t parts_;
  std::int64_t limit_;
  std::vector<std::uint32_t>& part_of_;
  const std::stop_token& stop_;
  std::vector<std::int64_t> weight_;
  std::vector<std::uint32_t> seen_;  ///< per vertex: the last search that reached it
  std::uint32_t search_ = 0;
};

}  // namespace

bool connect_parts(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
                   std::vector<std::uint32_t>& part_of, const std::stop_token& stop) {
  std::vector<std::uint32_t> changed = part_of;
  if (!Connector(graph, parts, limit, changed, stop)()) return false;
  part_of = std::move(changed);
  return true;
}

}  // namespace leonhard::graph::detail
