// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/kernel/progress.hpp"

/// Colours of vertices and edges: what may be worked on at the same time (Barth's notes 2.3).
namespace leonhard::graph {

/// A graph's edges, each once, smaller end first, ascending: the numbering of edge colourings, and that of a mesh's
/// EdgeStructure for its vertex graph. Cost O(m).
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> edges_of(const CsrGraph& graph);

struct Colouring {
  std::uint32_t colours{};               ///< colours are 0 ... colours-1
  std::vector<std::uint32_t> colour_of;  ///< one a vertex, or one an edge in the sequence of edges_of
};

enum class VertexColouringMethod {
  smallest_last,  ///< against the sequence of least degrees
  boost           ///< Boost.Graph's sequential_vertex_coloring, by index; to compare with
};

/// Colours of vertices such that neighbours differ, given greedily; with smallest_last at most one more than the graph's
/// degeneracy (six on a planar graph).
///
/// Cost O(n + m), some tenths of a second for 10^6 vertices: no stop could save time.
/// Method: Matula and Beck, Journal of the ACM 30 (1983) 417-427.
[[nodiscard]] Colouring colour_vertices(const CsrGraph& graph,
                                        VertexColouringMethod method = VertexColouringMethod::smallest_last);

/// Colours of edges such that no two edges of a colour share a vertex, as few as cheaply possible: each edge in turn
/// gets the first colour that is free at both its ends. At most 2 Delta - 1 colours, on meshes Delta and some; for
/// loops over edges that threads share.
///
/// Cost O(m Delta), in practice O(m); some tenths of a second for 10^6 vertices.
[[nodiscard]] Colouring colour_edges_greedily(const CsrGraph& graph);

enum class EdgeColourCount {
  delta,           ///< as many colours as the largest degree, which is the least possible
  delta_plus_one,  ///< one more; where `certain`, no colouring has fewer
  stopped          ///< a stop was requested: the colours of colour_edges_greedily
};

/// The word for it, e.g. "delta".
[[nodiscard]] constexpr std::string_view to_string(EdgeColourCount count) {
  switch (count) {
    case EdgeColourCount::delta:
      return "delta";
    case EdgeColourCount::delta_plus_one:
      return "delta_plus_one";
    case EdgeColourCount::stopped:
      return "stopped";
  }
  return "";
}

struct [[nodiscard]] EdgeColouring : Colouring {
  EdgeColourCount count{};
  bool certain = false;  ///< the number is known to be the least
};

enum class EdgeColouringMethod {
  alternating_paths,  ///< as below
  boost               ///< Boost.Graph's edge_coloring: Delta or Delta + 1 colours, slower; to compare with
};

struct EdgeColouringOptions {
  std::uint32_t rounds = 5;  ///< attempts at Delta colours before one more is taken
  std::uint64_t seed = 1;
  Progress progress{};  ///< stage "edge colouring"
  EdgeColouringMethod method = EdgeColouringMethod::alternating_paths;
};

/// Colours of edges such that no two edges of a colour share a vertex: Delta, the largest degree, if the graph is
/// bipartite or an attempt at it succeeds, Delta + 1 otherwise.
///
/// Method: bipartite: alternating paths (Koenig 1916); else Misra and Gries, Inf. Process. Lett. 41 (1992) 131-133, a
/// constructive proof of Vizing's theorem; Delta is tried with alternating paths, and by uncolouring an edge in the way
/// where these fail.
/// Cost O(n m) at worst; on meshes and communication graphs about proportional to m Delta.
EdgeColouring colour_edges(const CsrGraph& graph, const EdgeColouringOptions& options = {});

/// The first broken promise in words (a colour out of range, neighbours or edges at one vertex of one colour), if any.
[[nodiscard]] std::optional<std::string> validate_vertex_colouring(const CsrGraph& graph,
                                                                   const Colouring& colouring);
[[nodiscard]] std::optional<std::string> validate_edge_colouring(const CsrGraph& graph,
                                                                 const Colouring& colouring);

}  // namespace leonhard::graph
