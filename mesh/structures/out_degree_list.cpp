// SPDX-License-Identifier: MIT
#include "leonhard/mesh/structures/out_degree_list.hpp"

#include <array>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {
namespace {

std::size_t vertex_count(const EdgeStructure& edges) {
  return edges.first_edge.empty() ? 0 : edges.first_edge.size() - 1;
}

VertexId other_end(const EdgeStructure& edges, EdgeId e, VertexId end) {
  const auto& [a, b] = edges.ends[e];
  return a == end ? b : a;
}

/// The edges at every vertex, in compressed rows.
class Star {
 public:
  explicit Star(const EdgeStructure& edges)
      : first_(vertex_count(edges) + 1, 0), edges_(2 * edges.edge_count()) {
    for (const auto& ends : edges.ends)
      for (const VertexId v : ends) ++first_[v.index() + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const EdgeId e : edges.ends.ids())
      for (const VertexId v : edges.ends[e]) edges_[next[v.index()]++] = e;
  }
  [[nodiscard]] std::span<const EdgeId> of(VertexId v) const {
    return std::span(edges_).subspan(first_[v.index()], degree(v));
  }
  [[nodiscard]] std::size_t degree(VertexId v) const { return first_[v.index() + 1] - first_[v.index()]; }

 private:
  std::vector<std::size_t> first_;
  std::vector<EdgeId> edges_;
};

/// Vertices by degree; degrees only fall. A vertex whose degree fell stays in its former bucket too and is
/// passed over there.
class DegreeBuckets {
 public:
  explicit DegreeBuckets(const Star& star, std::size_t vertices) : degree_(vertices) {
    for (std::size_t v = 0; v < vertices; ++v) {
      degree_[v] = star.degree(VertexId::from(v));
      file(VertexId::from(v));
    }
  }
  /// Take out a vertex of least degree. There must be one.
  VertexId take() {
    while (true) {
      while (buckets_[least_].empty()) ++least_;
      const VertexId v = buckets_[least_].back();
      buckets_[least_].pop_back();
      if (degree_[v.index()] != least_) continue;
      degree_[v.index()] = taken;
      return v;
    }
  }
  [[nodiscard]] bool is_taken(VertexId v) const { return degree_[v.index()] == taken; }
  void lower(VertexId v) {
    --degree_[v.index()];
    file(v);
    least_ = std::min(least_, degree_[v.index()]);
  }

 private:
  static constexpr std::size_t taken = static_cast<std::size_t>(-1);
  void file(VertexId v) {
    const std::size_t degree = degree_[v.index()];
    if (buckets_.size() <= degree) buckets_.resize(degree + 1);
    buckets_[degree].push_back(v);
  }
  std::vector<std::size_t> degree_;
  std::vector<std::vector<VertexId>> buckets_;
  std::size_t least_ = 0;
};

void require_tails(const EdgeStructure& edges, const PerId<EdgeId, VertexId>& tails) {
  if (tails.size() != edges.edge_count()) {
    throw InputError(
        "tails",
        "there are " + std::to_string(tails.size()) + " for " + std::to_string(edges.edge_count()) + " edges",
        "give one an edge");
  }
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    if (tails[e] == a || tails[e] == b) continue;
    throw InputError("tails",
                     "vertex " + std::to_string(tails[e].raw) + " is no end of edge " +
                         std::to_string(e.raw) + ", which joins vertices " + std::to_string(a.raw) + " and " +
                         std::to_string(b.raw),
                     "name one of the two");
  }
}

}  // namespace

PerId<EdgeId, VertexId> smallest_last_tails(const EdgeStructure& edges) {
  const Star star(edges);
  DegreeBuckets left(star, vertex_count(edges));
  PerId<EdgeId, VertexId> tails(edges.edge_count());
  for (std::size_t step = 0; step < vertex_count(edges); ++step) {
    const VertexId v = left.take();
    for (const EdgeId e : star.of(v)) {
      const VertexId other = other_end(edges, e, v);
      if (left.is_taken(other)) continue;
      tails[e] = v;
      left.lower(other);
    }
  }
  return tails;
}

OutDegreeList out_degree_list(const EdgeStructure& edges, const PerId<EdgeId, VertexId>& tails) {
  require_tails(edges, tails);
  OutDegreeList list;
  list.first.assign(vertex_count(edges) + 1, 0);
  for (const VertexId tail : tails) ++list.first[tail.index() + 1];
  for (std::size_t v = 1; v < list.first.size(); ++v) list.first[v] += list.first[v - 1];
  list.heads.resize(edges.edge_count());
  // Edges are sorted by (ends[0], ends[1]): heads below their tail arrive in order, before those above it.
  std::vector<IdRaw> next(list.first.begin(), list.first.end() - 1);
  for (const EdgeId e : edges.ends.ids())
    list.heads[next[tails[e].index()]++] = other_end(edges, e, tails[e]);
  return list;
}

OutDegreeList out_degree_list(const EdgeStructure& edges) {
  return out_degree_list(edges, smallest_last_tails(edges));
}

}  // namespace leonhard::mesh
