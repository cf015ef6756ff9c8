// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition_parts.hpp"
#include "leonhard/mesh/compressed_rows.hpp"

/// Who holds what when each part of a partition is worked on by a process of its own: index lists for the exchange of
/// values between the parts.
namespace leonhard::graph {

/// A vertex of another part that a part's own vertices have as neighbour.
struct Ghost {
  std::uint32_t vertex;  ///< in the whole graph's numbering
  std::uint32_t owner;   ///< its part

  friend bool operator==(const Ghost&, const Ghost&) = default;
};

/// What one part keeps and exchanges. A part numbers its vertices locally: owned ones first, 0 .. owned.size() - 1, in the
/// sequence of `owned`, then ghosts in the sequence of `ghosts`. So the values received from one neighbour lie side by
/// side: those from neighbours[i] are the local numbers receive_begin[i] .. receive_begin[i + 1] - 1.
struct PartHalo {
  std::vector<std::uint32_t> owned;       ///< ascending, in the whole graph's numbering
  std::vector<Ghost> ghosts;              ///< by owner, then vertex
  std::vector<std::uint32_t> neighbours;  ///< the parts it exchanges values with, ascending
  /// Row i: the owned vertices, as local numbers, whose values go to neighbours[i], in the sequence in which that part
  /// lists them as ghosts.
  CompressedRows<std::uint32_t> send;
  std::vector<std::uint32_t> receive_begin;  ///< one a neighbour and one more, local numbers

  [[nodiscard]] std::uint32_t local_count() const {
    return static_cast<std::uint32_t>(owned.size() + ghosts.size());
  }
  /// The ghosts that neighbours[i] sends, a list as long as its send list to this part.
  [[nodiscard]] std::span<const Ghost> received_from(std::size_t i) const {
    return std::span(ghosts).subspan(receive_begin[i] - owned.size(),
                                     receive_begin[i + 1] - receive_begin[i]);
  }
};

/// The halos of all parts: one layer of ghosts, what a sum over neighbours needs.
///
/// throws  InputError if the partition has not one entry a vertex or names a part out of range
/// Cost O(n + m + parts), and a sort of the cut edges.
[[nodiscard]] std::vector<PartHalo> halos(const CsrGraph& graph, const PartitionView& partition);

/// The graph that one part sees, in its local numbering: the edges among owned vertices and between owned vertices and
/// ghosts, none between ghosts.
///
/// halo    one of halos(graph, ...)
/// Cost O(sum of the owned vertices' degrees, times log of the number of ghosts).
[[nodiscard]] CsrGraph local_graph(const CsrGraph& graph, const PartHalo& halo);

/// The first broken promise of halos in words (a vertex owned twice or by none, a neighbour that is no ghost, a send list
/// that differs from the other side's ghosts), if any. Cost O(n + m log halo).
[[nodiscard]] std::optional<std::string> validate(const CsrGraph& graph, std::span<const PartHalo> halos);

}  // namespace leonhard::graph
