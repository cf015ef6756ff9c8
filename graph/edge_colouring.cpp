// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <random>
#include <span>
#include <utility>

#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/colouring/boost_colourings.hpp"
#include "leonhard/graph/support/step_counter.hpp"

namespace leonhard::graph {
namespace {

using Vertex = std::uint32_t;
using EdgeNumber = std::uint32_t;
using Colour = std::uint32_t;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A partial colouring of edges that stays proper. Which edge has a colour at a vertex is read from a table where the
/// vertex has many edges, and found among its edges where it has few; so memory is O(m) whatever the degrees.
class PartialColouring {
 public:
  PartialColouring(const CsrGraph& graph, Colour colours)
      : edges_(edges_of(graph)),
        colours_(colours),
        colour_of_(edges_.size(), none),
        first_(vertex_count(graph) + std::size_t{1}, 0),
        table_(vertex_count(graph), no_table),
        hint_(vertex_count(graph), 0) {
    for (Vertex v = 0; v < vertex_count(graph); ++v) {
      first_[v + std::size_t{1}] = first_[v] + degree(graph, v);
      if (degree(graph, v) < few || degree(graph, v) * std::size_t{8} < colours) continue;
      table_[v] = entries_.size();
      entries_.resize(entries_.size() + colours, none);
    }
    at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (EdgeNumber e = 0; e < edges_.size(); ++e)
      for (const Vertex end : edges_[e]) at_[next[end]++] = e;
  }

  [[nodiscard]] EdgeNumber edge_count() const { return static_cast<EdgeNumber>(edges_.size()); }
  [[nodiscard]] Colour colours() const { return colours_; }
  [[nodiscard]] const std::array<Vertex, 2>& ends(EdgeNumber e) const { return edges_[e]; }
  [[nodiscard]] Vertex other_end(EdgeNumber e, Vertex v) const {
    return edges_[e][0] == v ? edges_[e][1] : edges_[e][0];
  }
  [[nodiscard]] std::span<const EdgeNumber> edges_at(Vertex v) const {
    return std::span(at_).subspan(first_[v], first_[v + std::size_t{1}] - first_[v]);
  }
  [[nodiscard]] Colour colour(EdgeNumber e) const { return colour_of_[e]; }
  [[nodiscard]] const std::vector<Colour>& all() const { return colour_of_; }

  /// The edge of a colour at v, or none.
  [[nodiscard]] EdgeNumber edge_of(Vertex v, Colour c) const {
    if (table_[v] != no_table) return entries_[table_[v] + c];
    for (const EdgeNumber e : edges_at(v))
      if (colour_of_[e] == c) return e;
    return none;
  }
  [[nodiscard]] bool is_free(Vertex v, Colour c) const { return edge_of(v, c) == none; }

  /// A colour free at v, the next one after that of the last call; there must be one.
  [[nodiscard]] Colour free_colour(Vertex v) {
    while (!is_free(v, hint_[v])) hint_[v] = (hint_[v] + 1) % colours_;
    return hint_[v];
  }
  /// All colours free at v, ascending.
  [[nodiscard]] std::vector<Colour> free_colours(Vertex v) const {
    std::vector<char> taken(colours_, 0);
    for (const EdgeNumber e : edges_at(v))
      if (colour_of_[e] != none) taken[colour_of_[e]] = 1;
    std::vector<Colour> free;
    for (Colour c = 0; c < colours_; ++c)
      if (taken[c] == 0) free.push_back(c);
    return free;
  }

  void set(EdgeNumber e, Colour c) {
    colour_of_[e] = c;
    for (const Vertex end : edges_[e])
      if (table_[end] != no_table) entries_[table_[end] + c] = e;
  }
  void clear(EdgeNumber e) {
    for (const Vertex end : edges_[e])
      if (table_[end] != no_table) entries_[table_[end] + colour_of_[e]] = none;
    colour_of_[e] = none;
  }

  /// The path of colours a and b in turn that begins at v with a; its last vertex.
  Vertex follow_path(Vertex v, Colour a, Colour b, std::vector<EdgeNumber>& path) const {
    path.clear();
    for (Colour c = a;; c = c == a ? b : a) {
      const EdgeNumber e = edge_of(v, c);
      if (e == none) return v;
      path.push_back(e);
      v = other_end(e, v);
    }
  }
  /// Exchanges the two colours along a path.
  void flip(const std::vector<EdgeNumber>& path, Colour a, Colour b) {
    if (path.empty()) return;
    Colour c = colour_of_[path.front()];
    for (const EdgeNumber e : path) clear(e);
    for (const EdgeNumber e : path) set(e, c = c == a ? b : a);
  }

 private:
  static constexpr std::uint32_t few = 16;
  static constexpr std::size_t no_table = std::numeric_limits<std::size_t>::max();

  std::vector<std::array<Vertex, 2>> edges_;
  Colour colours_;
  std::vector<Colour> colour_of_;
  std::vector<std::size_t> first_;  ///< per vertex: where its edges begin in at_
  std::vector<EdgeNumber> at_;
  std::vector<std::size_t> table_;  ///< per vertex: where its table begins in entries_, or no_table
  std::vector<EdgeNumber> entries_;       ///< per colour the edge, or none
  std::vector<Colour> hint_;
};

/// Colours e by exchanging the colours of an alternating path so that one colour becomes free at both ends. Always
/// works where the graph is bipartite and each end has a free colour.
bool colour_by_path(PartialColouring& colouring, EdgeNumber e, Colour a, Colour b, std::vector<EdgeNumber>& path) {
  const auto [u, v] = colouring.ends(e);  // a is free at u, b at v
  if (a != b && !colouring.is_free(v, a)) {
    if (colouring.follow_path(v, a, b, path) == u) return false;
    colouring.flip(path, a, b);
  }
  colouring.set(e, a);
  return true;
}

// ---- Delta + 1: Misra and Gries ----

class MisraGries {
 public:
  MisraGries(const CsrGraph& graph, Colour colours) : colouring_(graph, colours) {}

  std::vector<Colour> run(detail::StepCounter& steps) {
    for (EdgeNumber e = 0; e < colouring_.edge_count() && steps.step(); ++e) colour(e);
    return colouring_.all();
  }

 private:
  /// Edges at u, of which each but the first has a colour that is free at the other end of the one before.
  void build_fan(Vertex u, EdgeNumber first) {
    fan_.assign(1, first);
    bool longer = true;
    while (longer) {
      longer = false;
      const Vertex last = colouring_.other_end(fan_.back(), u);
      for (const EdgeNumber e : colouring_.edges_at(u)) {
        const Colour c = colouring_.colour(e);
        if (c == none || !colouring_.is_free(last, c) || std::ranges::find(fan_, e) != fan_.end()) continue;
        fan_.push_back(e);
        longer = true;
        break;
      }
    }
  }

  void colour(EdgeNumber e) {
    const Vertex u = colouring_.ends(e)[0];
    build_fan(u, e);
    const Colour c = colouring_.free_colour(u),
                 d = colouring_.free_colour(colouring_.other_end(fan_.back(), u));
    colouring_.follow_path(u, d, c, path_);
    colouring_.flip(path_, c, d);
    rotate_and_close(u, d);
  }

  /// d is free at u now. The first edges of the fan, up to one at whose other end d is free too, pass their colours
  /// on to the one before; the last of them gets d.
  void rotate_and_close(Vertex u, Colour d) {
    std::size_t last = 0;
    while (!colouring_.is_free(colouring_.other_end(fan_[last], u), d)) ++last;
    for (std::size_t k = 0; k < last; ++k) {
      const Colour next = colouring_.colour(fan_[k + 1]);
      colouring_.clear(fan_[k + 1]);
      colouring_.set(fan_[k], next);
    }
    colouring_.set(fan_[last], d);
  }

  PartialColouring colouring_;
  std::vector<EdgeNumber> fan_, path_;
};

// ---- Delta ----

/// Tries to do with as many colours as the largest degree.
class DeltaAttempt {
 public:
  DeltaAttempt(const CsrGraph& graph, Colour colours, std::uint64_t seed)
      : colouring_(graph, colours), random_(seed) {}

  /// Whether all edges could be coloured with so many others in the way.
  bool run(std::size_t patience, detail::StepCounter& steps) {
    for (EdgeNumber e = 0; e < colouring_.edge_count(); ++e) todo_.push_back(e);
    for (std::size_t i = todo_.size(); i > 1; --i) std::swap(todo_[i - 1], todo_[random_() % i]);
    for (std::size_t failures = 0; !todo_.empty();) {
      if (!steps.step()) return false;
      const EdgeNumber e = todo_.back();
      todo_.pop_back();
      if (colour(e)) continue;
      if (++failures > patience) return false;
      make_way(e);
    }
    return true;
  }
  [[nodiscard]] const std::vector<Colour>& colours() const { return colouring_.all(); }

 private:
  /// Nearly always the first colours at hand do; else all pairs of free colours are tried.
  bool colour(EdgeNumber e) {
    const auto [u, v] = colouring_.ends(e);
    const Colour first_u = colouring_.free_colour(u), first_v = colouring_.free_colour(v);
    if (colouring_.is_free(u, first_v)) {
      colouring_.set(e, first_v);
      return true;
    }
    if (colour_by_path(colouring_, e, first_u, first_v, path_)) return true;
    const std::vector<Colour> free_u = colouring_.free_colours(u), free_v = colouring_.free_colours(v);
    for (const Colour a : free_u)
      for (const Colour b : free_v)
        if (colour_by_path(colouring_, e, a, b, path_)) return true;
    return false;
  }

  /// Gives e a colour free at one end and takes it from the edge that has it at the other, which waits its turn.
  void make_way(EdgeNumber e) {
    const std::size_t which = random_() % 2;
    const Vertex end = colouring_.ends(e)[which];
    const std::vector<Colour> free = colouring_.free_colours(end);
    const Colour c = free[random_() % free.size()];
    const EdgeNumber in_the_way = colouring_.edge_of(colouring_.other_end(e, end), c);
    colouring_.clear(in_the_way);
    colouring_.set(e, c);
    todo_.push_back(in_the_way);
  }

  PartialColouring colouring_;
  std::mt19937_64 random_;
  std::vector<EdgeNumber> todo_, path_;
};

std::vector<Colour> colour_bipartite(const CsrGraph& graph, Colour colours, detail::StepCounter& steps) {
  PartialColouring colouring(graph, colours);
  std::vector<EdgeNumber> path;
  for (EdgeNumber e = 0; e < colouring.edge_count() && steps.step(); ++e) {
    const auto [u, v] = colouring.ends(e);
    static_cast<void>(colour_by_path(colouring, e, colouring.free_colour(u), colouring.free_colour(v), path));
  }
  return colouring.all();
}

bool is_bipartite(const CsrGraph& graph) {
  std::vector<char> side(vertex_count(graph), 2);
  std::vector<Vertex> queue;
  for (Vertex root = 0; root < vertex_count(graph); ++root) {
    if (side[root] != 2) continue;
    side[root] = 0;
    queue.assign(1, root);
    while (!queue.empty()) {
      const Vertex v = queue.back();
      queue.pop_back();
      for (const Vertex w : neighbours(graph, v)) {
        if (side[w] == side[v]) return false;
        if (side[w] != 2) continue;
        side[w] = static_cast<char>(1 - side[v]);
        queue.push_back(w);
      }
    }
  }
  return true;
}

Colour largest_degree(const CsrGraph& graph) {
  Colour largest = 0;
  for (Vertex v = 0; v < vertex_count(graph); ++v) largest = std::max(largest, degree(graph, v));
  return largest;
}

/// Whether some component has more edges than Delta matchings can hold: no colouring has Delta colours then.
bool is_overfull(const CsrGraph& graph, Colour delta) {
  const Components parts = components(graph);
  std::vector<std::size_t> arcs(parts.count(), 0);
  for (Vertex v = 0; v < vertex_count(graph); ++v) arcs[parts.component_of[v]] += degree(graph, v);
  for (std::uint32_t c = 0; c < parts.count(); ++c)
    if (arcs[c] / 2 > std::size_t{delta} * (parts.sizes[c] / 2)) return true;
  return false;
}

EdgeColouring made(std::vector<Colour> colour_of, Colour colours, EdgeColourCount count, bool certain) {
  EdgeColouring result;
  result.colours = colours;
  result.colour_of = std::move(colour_of);
  result.count = count;
  result.certain = certain;
  return result;
}

/// Of no use if steps was stopped.
EdgeColouring least_colouring(const CsrGraph& graph, Colour delta, const EdgeColouringOptions& options,
                              detail::StepCounter& steps) {
  if (is_bipartite(graph))
    return made(colour_bipartite(graph, delta, steps), delta, EdgeColourCount::delta, true);
  const bool impossible = is_overfull(graph, delta);
  // A failure follows paths of some thousand edges where they are long: the larger the graph, the fewer are allowed.
  const std::size_t patience = std::clamp<std::size_t>(2'000'000 / vertex_count(graph), 50, 2000);
  for (std::uint32_t round = 0; !impossible && round < options.rounds && steps.goes_on(); ++round) {
    DeltaAttempt attempt(graph, delta, options.seed + round);
    if (attempt.run(patience, steps)) return made(attempt.colours(), delta, EdgeColourCount::delta, true);
  }
  return made(MisraGries(graph, delta + 1).run(steps), delta + 1, EdgeColourCount::delta_plus_one,
              impossible);
}

EdgeColouring boost_colouring(const CsrGraph& graph, Colour delta, detail::StepCounter& steps) {
  std::vector<std::uint32_t> colour_of;
  const std::uint32_t colours = detail::boost_colour_edges(graph, colour_of, steps).value_or(0);
  return made(std::move(colour_of), colours,
              colours <= delta ? EdgeColourCount::delta : EdgeColourCount::delta_plus_one, colours <= delta);
}

}  // namespace

EdgeColouring colour_edges(const CsrGraph& graph, const EdgeColouringOptions& options) {
  const Colour delta = largest_degree(graph);
  if (delta == 0) return made({}, 0, EdgeColourCount::delta, true);
  const bool by_boost = options.method == EdgeColouringMethod::boost;
  detail::StepCounter steps(options.progress, "edge colouring", (by_boost ? 2 : 1) * edge_count(graph));
  EdgeColouring result =
      by_boost ? boost_colouring(graph, delta, steps) : least_colouring(graph, delta, options, steps);
  if (!steps.stopped()) return result;
  Colouring greedy = colour_edges_greedily(graph);
  return made(std::move(greedy.colour_of), greedy.colours, EdgeColourCount::stopped, false);
}

}  // namespace leonhard::graph
