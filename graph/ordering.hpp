// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::graph {

// An ordering is a permutation `order` with order[new] = old: the sequence in which old numbers are visited.
// A method that takes a Progress reports under its name; where it is stopped, what is left is numbered by index.

enum class OrderOutcome {
  done,
  stopped  ///< a stop was requested: a valid ordering, not as good as it would have been
};

/// The word for it, e.g. "done".
[[nodiscard]] constexpr std::string_view to_string(OrderOutcome outcome) {
  switch (outcome) {
    case OrderOutcome::done:
      return "done";
    case OrderOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct [[nodiscard]] OrderResult {
  std::vector<std::uint32_t> order;  ///< order[new] = old
  OrderOutcome outcome = OrderOutcome::done;
};

/// A vertex at (nearly) the greatest distance from some other, for a level structure that is deep and narrow.
///
/// start   any vertex; the search stays in its component
/// throws  InputError if start is no vertex
/// Cost O(m) a level structure, usually 3 to 5 of them.
/// Method: George and Liu, "An implementation of a pseudoperipheral node finder", ACM TOMS 5 (1979) 284-295:
/// go to a vertex of least degree in the last level as long as that deepens the level structure. Ties:
/// smallest index.
[[nodiscard]] std::uint32_t pseudo_peripheral_vertex(const CsrGraph& graph, std::uint32_t start);

/// The Cuthill-McKee ordering as Barth's notes give it (2.2): each component breadth first from its vertex of least
/// degree, neighbours by increasing degree, ties by index.
///
/// returns order[new] = old
/// Cost O(n + m log d), d the largest degree.
[[nodiscard]] std::vector<std::uint32_t> cuthill_mckee(const CsrGraph& graph);

/// The reverse Cuthill-McKee ordering: small bandwidth and profile for a banded or incomplete factorisation.
///
/// As cuthill_mckee, but from a pseudo-peripheral vertex, searched from the vertex of least degree; then the whole
/// sequence is reversed. Components follow one another by least degree, then index, before reversal.
///
/// returns order[new] = old
/// Cost O(n + m log d), d the largest degree.
/// Method: Cuthill and McKee (1969); George (1971) for the reversal; Barth's notes 2.2.
[[nodiscard]] std::vector<std::uint32_t> reverse_cuthill_mckee(const CsrGraph& graph);

/// The Gibbs-Poole-Stockmeyer ordering: level structures from both ends of the graph merged into one that is narrow,
/// numbered level by level. In the direction whose envelope is smaller, as the next ones are.
///
/// Cost O(n + m log d) and about ten level structures.
/// Method: Gibbs, Poole and Stockmeyer, SIAM J. Numer. Anal. 13 (1976) 236-250.
[[nodiscard]] std::vector<std::uint32_t> gibbs_poole_stockmeyer(const CsrGraph& graph);
OrderResult gibbs_poole_stockmeyer(const CsrGraph& graph, const Progress& progress);

/// The Gibbs-King ordering: the level structure of gibbs_poole_stockmeyer, each level numbered by King's criterion, for
/// an envelope smaller than that at a bandwidth somewhat larger.
///
/// Cost O(m log n) and about ten level structures.
/// Method: Gibbs, ACM TOMS 2 (1976) 378-387; Lewis, ACM TOMS 8 (1982) 180-189.
[[nodiscard]] std::vector<std::uint32_t> gibbs_king(const CsrGraph& graph);
OrderResult gibbs_king(const CsrGraph& graph, const Progress& progress);

/// King's ordering, for a small envelope: next comes always the vertex of the front that brings the fewest others to
/// the front, the longest there among equals. The better one of two, from both ends of the graph. (With Boost.Graph's
/// the envelopes of meshes are about those of reverse_cuthill_mckee.)
///
/// Cost O(m log n) and about ten level structures.
/// Method: King, Int. J. Numer. Meth. Eng. 2 (1970) 523-533; ends: Gibbs, Poole and Stockmeyer (1976).
[[nodiscard]] std::vector<std::uint32_t> king(const CsrGraph& graph);
OrderResult king(const CsrGraph& graph, const Progress& progress);

/// What counts in Sloan's priorities: a vertex comes the sooner the farther it is from the end and the fewer rows it
/// adds to the front.
struct SloanWeights {
  std::uint32_t distance{}, degree{};
};

/// Sloan's ordering, for a small envelope and wavefront. (Boost.Graph's sorts a list at every step, which takes
/// hours where a heap takes seconds.)
///
/// choices  of weights: each component gets the order of the smallest envelope. Without them two are tried, which suit
///          small fronts and large ones
/// throws   InputError if there is none
/// Cost O(m d log n) at worst for each choice, d the mean degree.
/// Method: Sloan, Int. J. Numer. Meth. Eng. 23 (1986) 239-251; heap and choices: Kumfert and Pothen, BIT 37 (1997)
/// 559-590, Reid and Scott, Int. J. Numer. Meth. Eng. 45 (1999) 1737-1755.
[[nodiscard]] std::vector<std::uint32_t> sloan(const CsrGraph& graph);
[[nodiscard]] std::vector<std::uint32_t> sloan(const CsrGraph& graph, std::span<const SloanWeights> choices);
OrderResult sloan(const CsrGraph& graph, const Progress& progress);
OrderResult sloan(const CsrGraph& graph, std::span<const SloanWeights> choices, const Progress& progress);

struct [[nodiscard]] RosenResult : OrderResult {
  std::uint64_t exchanges{};
};

/// Rosen's algorithm (Barth's notes 2.2): exchanges pairs of numbers as long as that reduces the bandwidth or the
/// number of edges that attain it, and in between pairs that keep the bandwidth, if the sum of the squared widths of
/// all edges falls. It improves a given order and may take long.
///
/// start   the order to begin with
/// throws  InputError if start is no permutation of the graph's vertices
/// Cost O(bandwidth * degree) an exchange; some hundreds to millions of exchanges.
/// Method: Rosen, Proc. 23rd National Conference ACM (1968) 585-595.
RosenResult rosen(const CsrGraph& graph, std::span<const std::uint32_t> start, const Progress& progress = {});

/// The spectral ordering: vertices by their entry in the Fiedler vector, for a small envelope.
///
/// seed  of the eigensolver's start
/// Cost: one Fiedler vector a component.
/// Method: Barnard, Pothen and Simon, Numer. Linear Algebra Appl. 2 (1995) 317-334.
OrderResult spectral_order(const CsrGraph& graph, std::uint64_t seed = 1, const Progress& progress = {});

/// The inverse permutation: new_of_old[order[i]] = i.
///
/// throws  InputError if order is no permutation, naming the number that is out of range or repeated
[[nodiscard]] std::vector<std::uint32_t> invert(std::span<const std::uint32_t> order);

/// What an ordering costs a symmetric matrix with the graph's pattern and a full diagonal. With first(i) the
/// smallest column of row i up to the diagonal:
struct OrderingCost {
  std::uint32_t bandwidth{};  ///< max of i - first(i): the half bandwidth, 0 for a diagonal matrix
  std::uint64_t envelope{};   ///< sum of i - first(i), also called profile, the diagonal not counted
  double rms_wavefront{};     ///< root mean square over i of the rows active at step i, row i among them
};

/// throws  InputError if order is no permutation of the graph's vertices
/// Cost O(n + m).
[[nodiscard]] OrderingCost ordering_cost(const CsrGraph& graph, std::span<const std::uint32_t> order);

/// The order as it is: 0, 1, ... n-1.
[[nodiscard]] std::vector<std::uint32_t> natural_order(const CsrGraph& graph);

namespace detail {

/// throws InputError if order is no permutation of the graph's vertices
void check_order(const CsrGraph& graph, std::span<const std::uint32_t> order);

/// The order or its reverse, whichever has the smaller envelope.
[[nodiscard]] std::vector<std::uint32_t> better_direction(const CsrGraph& graph,
                                                          std::vector<std::uint32_t> order);

/// Appends what an order lacks of all vertices, in their sequence.
void append_missing(std::vector<std::uint32_t>& order, std::span<const std::uint32_t> all);

}  // namespace detail

}  // namespace leonhard::graph
