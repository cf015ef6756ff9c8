// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/mesh/edges.hpp"

/// Edges directed so that few leave any vertex (Barth's notes 2.1).
namespace leonhard::graph {

/// A graph's edges, each listed once, at its tail.
struct Orientation {
  CompressedRows<std::uint32_t> heads;  ///< row v: the heads of the edges that leave v, ascending

  [[nodiscard]] std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(heads.size()); }
  /// Row v. v is below vertex_count(): a precondition, asserted only, here and of out_degree.
  [[nodiscard]] std::span<const std::uint32_t> heads_of(std::uint32_t v) const { return heads[v]; }
  [[nodiscard]] std::uint32_t out_degree(std::uint32_t v) const {
    return static_cast<std::uint32_t>(heads[v].size());
  }
  [[nodiscard]] std::uint32_t max_out_degree() const;
};

enum class OrientationOutcome {
  three_bounded,  ///< no vertex has more than three outgoing edges
  not_planar      ///< the graph is not planar and the method found no way: by least degree instead
};

/// The word for it, e.g. "three_bounded".
[[nodiscard]] constexpr std::string_view to_string(OrientationOutcome outcome) {
  switch (outcome) {
    case OrientationOutcome::three_bounded:
      return "three_bounded";
    case OrientationOutcome::not_planar:
      return "not_planar";
  }
  return "";
}

struct [[nodiscard]] PlanarOrientation {
  OrientationOutcome outcome{};
  Orientation orientation;
  std::vector<std::uint32_t> removed;  ///< the vertices in the sequence of their removal; empty if not planar
};

/// Directs a planar graph's edges so that at most three leave any vertex.
///
/// The boundary, at first one vertex, is a set of vertices on the outer face of what is left of the graph. Such
/// vertices induce an outerplanar graph, so one of them is reducible: it has at most two neighbours on the boundary.
/// It is removed: its edges to the boundary are directed outwards, those to the interior inwards, and its interior
/// neighbours, which now lie on the outer face, join the boundary. An edge leaves a vertex when it joins the boundary
/// and two at most when it is removed. No embedding is needed; where a boundary has no reducible vertex, that proves
/// that the graph is not planar. (Some graphs that are not planar are oriented all the same.)
///
/// boundary  vertices to begin with, which lie on one face of some planar embedding, such as a mesh's outer boundary;
///           may be empty
/// throws    InputError for a boundary vertex that does not exist
/// Cost O(n + m).
/// Method: Chrobak and Eppstein, Theor. Comput. Sci. 86 (1991) 243-266.
PlanarOrientation orient_planar(const CsrGraph& graph, std::span<const std::uint32_t> boundary = {});

/// Directs each edge away from the end that goes first when always a vertex of least degree is removed: the largest
/// out-degree is the graph's degeneracy, for planar graphs five at most, and no acyclic orientation has a smaller one.
///
/// Cost O(n + m). Method: smallest-last order, Matula and Beck, Journal of the ACM 30 (1983) 417-427.
[[nodiscard]] Orientation orient_by_least_degree(const CsrGraph& graph);

/// The sequence in which orient_by_least_degree removes the vertices.
[[nodiscard]] std::vector<std::uint32_t> least_degree_sequence(const CsrGraph& graph);

/// Whether a graph can be drawn without crossings, by Boost.Graph's test of Boyer and Myrvold. Cost O(n + m).
[[nodiscard]] bool is_planar(const CsrGraph& graph);

/// The orientation of a mesh's vertex graph as mesh::out_degree_list takes it.
///
/// throws  InputError if an edge of the mesh is none of the orientation's
/// Cost O(edges log out-degree).
[[nodiscard]] PerId<EdgeId, VertexId> tails(const EdgeStructure& edges, const Orientation& orientation);

/// The first broken promise of an orientation of a graph in words (an edge missing, directed twice, none of the
/// graph's; lists out of order), if any. Cost O(m log d).
[[nodiscard]] std::optional<std::string> validate(const CsrGraph& graph, const Orientation& orientation);

}  // namespace leonhard::graph
