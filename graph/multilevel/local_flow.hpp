// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace leonhard::graph::detail {

/// A maximum flow through a small network between a source and a sink outside it, and its minimum cuts. Kept and
/// refilled, so that many small networks cost no allocations.
///
/// Method: Dinic, Soviet Math. Dokl. 11 (1970) 1277-1280.
class LocalFlow {
 public:
  void clear();
  /// Vertices are numbered as they are added.
  void add_vertex();
  /// An edge of the last vertex added with an earlier one.
  void add_edge(std::uint32_t earlier, std::int32_t capacity) { add_edge(earlier, capacity, capacity); }
  /// One whose two directions carry different amounts.
  void add_edge(std::uint32_t earlier, std::int32_t to_earlier, std::int32_t from_earlier);
  void add_source_edge(std::int32_t capacity) { from_source_.back() += capacity; }
  void add_sink_edge(std::int32_t capacity) { to_sink_.back() += capacity; }

  /// The value of a maximum flow, or a value of at least `enough` as soon as the flow is known to reach that.
  std::int64_t maximum(std::int64_t enough);

  /// After maximum(): the vertices that the source still reaches (the smallest source side of a minimum cut) ...
  [[nodiscard]] bool reached_from_source(std::uint32_t v) const { return level_[v] != unreached; }
  /// ... and those that still reach the sink (the smallest sink side).
  [[nodiscard]] std::vector<char> reaching_sink() const;

 private:
  struct Edge {
    std::uint32_t later, earlier;
    std::int32_t to_earlier, from_earlier;
  };
  struct Link {
    std::uint32_t to;
    std::uint32_t back;  ///< the link of the other direction
    std::int32_t residual;
  };
  static constexpr std::uint32_t unreached = ~std::uint32_t{0};

  void build_links();
  [[nodiscard]] bool build_levels();
  std::int32_t augment_from(std::uint32_t start);

  std::vector<Edge> edges_;
  std::vector<Link> links_;                          ///< row v is [start_[v], start_[v+1])
  std::vector<std::uint32_t> start_;                 ///< per vertex: until build_links its number of links
  std::vector<std::int32_t> from_source_, to_sink_;  ///< per vertex: residual capacities
  std::vector<std::uint32_t> level_, current_, queue_, path_;
};

}  // namespace leonhard::graph::detail
