// SPDX-License-Identifier: MIT
#include "leonhard/graph/orientation.hpp"

#include <limits>
#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using Vertex = std::uint32_t;

/// Lists edges at their tails as they are directed one after another.
class Directions {
 public:
  explicit Directions(const CsrGraph& graph) : graph_(graph) { arcs_.reserve(edge_count(graph)); }

  void direct(Vertex tail, Vertex head) { arcs_.emplace_back(tail, head); }

  [[nodiscard]] Orientation listed() const {
    Orientation result;
    result.heads = collect_rows<Vertex>(vertex_count(graph_), [&](const auto& add) {
      for (const auto& [tail, head] : arcs_) add(tail, head);
    });
    for (Vertex v = 0; v < vertex_count(graph_); ++v) std::ranges::sort(result.heads[v]);
    return result;
  }

 private:
  const CsrGraph& graph_;
  std::vector<std::pair<Vertex, Vertex>> arcs_;  ///< tail, head
};

/// Removal of reducible boundary vertices.
class Reduction {
 public:
  explicit Reduction(const CsrGraph& graph)
      : graph_(graph),
        state_(vertex_count(graph), State::interior),
        boundary_neighbours_(vertex_count(graph), 0),
        directions_(graph) {}

  /// Whether all went well; from the given boundary and then, where that is used up, from any vertex left.
  bool run(std::span<const Vertex> boundary) {
    for (const Vertex v : boundary) join_boundary(v);
    if (!remove_all()) return false;
    for (Vertex v = 0; v < vertex_count(graph_); ++v) {
      join_boundary(v);
      if (!remove_all()) return false;
    }
    return true;
  }

  [[nodiscard]] Orientation listed() const { return directions_.listed(); }
  [[nodiscard]] std::vector<Vertex> take_sequence() { return std::move(removed_); }

 private:
  enum class State : char { interior, boundary, removed };

  void join_boundary(Vertex v) {
    if (state_[v] != State::interior) return;
    state_[v] = State::boundary;
    ++boundary_size_;
    for (const Vertex w : neighbours(graph_, v))
      if (state_[w] == State::boundary) {
        ++boundary_neighbours_[v];
        ++boundary_neighbours_[w];
      }
    if (is_reducible(v)) reducible_.push_back(v);
  }

  [[nodiscard]] bool is_reducible(Vertex v) const {
    return state_[v] == State::boundary && boundary_neighbours_[v] <= 2;
  }

  /// Whether the boundary could be used up. A vertex found reducible may have got more neighbours on the boundary
  /// since; it comes back when it loses them.
  bool remove_all() {
    while (!reducible_.empty()) {
      const Vertex v = reducible_.back();
      reducible_.pop_back();
      if (is_reducible(v)) remove(v);
    }
    return boundary_size_ == 0;
  }

  void remove(Vertex v) {
    state_[v] = State::removed;
    --boundary_size_;
    removed_.push_back(v);
    for (const Vertex w : neighbours(graph_, v)) {
      if (state_[w] != State::boundary) continue;
      directions_.direct(v, w);
      if (--boundary_neighbours_[w] <= 2) reducible_.push_back(w);
    }
    for (const Vertex w : neighbours(graph_, v)) {
      if (state_[w] != State::interior) continue;
      directions_.direct(w, v);
      join_boundary(w);
    }
  }

  const CsrGraph& graph_;
  std::vector<State> state_;
  std::vector<std::uint32_t> boundary_neighbours_;  ///< of a boundary vertex
  std::vector<Vertex> reducible_;  ///< all reducible vertices, and some that are so no longer
  std::vector<Vertex> removed_;
  Directions directions_;
  std::size_t boundary_size_ = 0;
};

}  // namespace

std::uint32_t Orientation::max_out_degree() const {
  std::uint32_t largest = 0;
  for (Vertex v = 0; v < vertex_count(); ++v) largest = std::max(largest, out_degree(v));
  return largest;
}

PlanarOrientation orient_planar(const CsrGraph& graph, std::span<const std::uint32_t> boundary) {
  for (const Vertex v : boundary)
    if (v >= vertex_count(graph))
      throw InputError("boundary",
                       "vertex " + std::to_string(v) + " does not exist, the graph has " +
                           std::to_string(vertex_count(graph)) + " vertices",
                       "name vertices of the graph");
  Reduction reduction(graph);
  if (!reduction.run(boundary)) return {OrientationOutcome::not_planar, orient_by_least_degree(graph), {}};
  return {OrientationOutcome::three_bounded, reduction.listed(), reduction.take_sequence()};
}

std::vector<std::uint32_t> least_degree_sequence(const CsrGraph& graph) {
  // Vertices sorted by what is left of their degree, in one array with the places where each degree begins; a vertex
  // whose degree falls changes places with the first of its degree (Batagelj and Zaversnik 2003).
  const std::uint32_t n = vertex_count(graph);
  std::vector<std::uint32_t> left(n), first, place(n), sequence(n);
  for (Vertex v = 0; v < n; ++v) {
    left[v] = degree(graph, v);
    if (first.size() < left[v] + std::size_t{2}) first.resize(left[v] + std::size_t{2}, 0);
    ++first[left[v] + std::size_t{1}];
  }
  for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
  std::vector<std::uint32_t> next = first;
  for (Vertex v = 0; v < n; ++v) {
    place[v] = next[left[v]]++;
    sequence[place[v]] = v;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vertex v = sequence[i];
    for (const Vertex w : neighbours(graph, v)) {
      if (place[w] <= i || left[w] <= left[v]) continue;
      std::uint32_t& begin = first[left[w]];
      begin = std::max(begin, i + 1);
      const Vertex other = sequence[begin];
      std::swap(sequence[begin], sequence[place[w]]);
      std::swap(place[other], place[w]);
      ++begin;
      --left[w];
    }
  }
  return sequence;
}

Orientation orient_by_least_degree(const CsrGraph& graph) {
  const std::vector<std::uint32_t> sequence = least_degree_sequence(graph);
  std::vector<std::uint32_t> place(sequence.size());
  for (std::uint32_t i = 0; i < sequence.size(); ++i) place[sequence[i]] = i;
  Directions directions(graph);
  for (const Vertex v : sequence)
    for (const Vertex w : neighbours(graph, v))
      if (place[v] < place[w]) directions.direct(v, w);
  return directions.listed();
}

PerId<EdgeId, VertexId> tails(const EdgeStructure& edges, const Orientation& orientation) {
  const auto leads = [&](VertexId from, VertexId to) {
    return from.raw < orientation.vertex_count() &&
           std::ranges::binary_search(orientation.heads_of(static_cast<Vertex>(from.raw)), to.raw);
  };
  PerId<EdgeId, VertexId> result(edges.edge_count());
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    if (!leads(a, b) && !leads(b, a))
      throw InputError("orientation",
                       "it does not direct edge " + std::to_string(e.raw) + ", which joins vertices " +
                           std::to_string(a.raw) + " and " + std::to_string(b.raw),
                       "orient the vertex graph of this mesh");
    result[e] = leads(a, b) ? a : b;
  }
  return result;
}

std::optional<std::string> validate(const CsrGraph& graph, const Orientation& orientation) {
  if (orientation.vertex_count() != vertex_count(graph))
    return "the orientation has " + std::to_string(orientation.vertex_count()) + " vertices, the graph " +
           std::to_string(vertex_count(graph));
  if (orientation.heads.link_count() != edge_count(graph))
    return "the orientation has " + std::to_string(orientation.heads.link_count()) + " edges, the graph " +
           std::to_string(edge_count(graph));
  for (Vertex v = 0; v < vertex_count(graph); ++v) {
    const auto heads = orientation.heads_of(v);
    for (std::size_t k = 0; k < heads.size(); ++k) {
      const std::string edge = "from vertex " + std::to_string(v) + " to " + std::to_string(heads[k]);
      if (k > 0 && heads[k - 1] >= heads[k]) return "the list does not ascend at the edge " + edge;
      if (!std::ranges::binary_search(neighbours(graph, v), heads[k])) return "the graph has no edge " + edge;
      if (std::ranges::binary_search(orientation.heads_of(heads[k]), v))
        return "the edge " + edge + " is directed both ways";
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::graph
