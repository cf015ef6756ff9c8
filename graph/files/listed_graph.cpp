// SPDX-License-Identifier: MIT
#include "leonhard/graph/files/listed_graph.hpp"

#include <algorithm>
#include <limits>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph::detail {
namespace {

using Entry = std::uint32_t;  ///< its place in the file's list

void check_size(const ListedGraph& listed) {
  constexpr std::size_t limit = std::numeric_limits<std::uint32_t>::max();
  if (listed.entries.size() <= (listed.both_directions ? limit : limit / 2)) return;
  throw InputError(listed.source, std::to_string(listed.entries.size()) + " entries",
                   "graphs hold at most 2^31 - 1 edges");
}

void add_other_directions(ListedGraph& listed) {
  const std::size_t given = listed.entries.size();
  listed.entries.reserve(2 * given);
  listed.weights.reserve(2 * listed.weights.size());
  for (std::size_t i = 0; i < given; ++i) {
    const ListedEdge e = listed.entries[i];
    if (e.from != e.to) listed.entries.push_back({e.to, e.from, e.line});
    if (e.from != e.to && !listed.weights.empty()) listed.weights.push_back(listed.weights[i]);
  }
}

/// The entries that are no self-loops, by (from, to), equal ones in the file's sequence.
std::vector<Entry> sorted_entries(const ListedGraph& listed) {
  std::vector<std::size_t> start(listed.vertices + std::size_t{1}, 0);
  for (const ListedEdge& e : listed.entries)
    if (e.from != e.to) ++start[e.from + std::size_t{1}];
  for (std::size_t v = 0; v < listed.vertices; ++v) start[v + 1] += start[v];
  std::vector<Entry> sorted(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (Entry i = 0; i < listed.entries.size(); ++i)
    if (const ListedEdge& e = listed.entries[i]; e.from != e.to) sorted[next[e.from]++] = i;
  const auto before = [&](Entry a, Entry b) {
    const std::uint32_t to_a = listed.entries[a].to, to_b = listed.entries[b].to;
    return to_a != to_b ? to_a < to_b : a < b;
  };
  for (std::size_t v = 0; v < listed.vertices; ++v)
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(start[v]),
              sorted.begin() + static_cast<std::ptrdiff_t>(start[v + 1]), before);
  return sorted;
}

bool same_edge(const ListedEdge& a, const ListedEdge& b) { return a.from == b.from && a.to == b.to; }

[[noreturn]] void fail_one_sided(const ListedGraph& listed, const ListedEdge& e, std::uint32_t first_number) {
  const std::string from = std::to_string(std::uint64_t{e.from} + first_number),
                    to = std::to_string(std::uint64_t{e.to} + first_number);
  throw InputError(at_line(listed.source, e.line),
                   "vertex " + from + " has an edge to vertex " + to + ", but " + to + " has none to " + from,
                   listed.remedy);
}

/// Each directed edge's entry and that of its reverse agree.
void check_symmetry(const ListedGraph& listed, const std::vector<Entry>& rows, const GraphFile& file) {
  for (const Entry i : rows) {
    const ListedEdge& e = listed.entries[i];
    const auto reverse = std::lower_bound(rows.begin(), rows.end(), e, [&](Entry j, const ListedEdge& edge) {
      const ListedEdge& other = listed.entries[j];
      return other.from != edge.to ? other.from < edge.to : other.to < edge.from;
    });
    if (reverse == rows.end() || !same_edge(listed.entries[*reverse], {e.to, e.from, 0}))
      fail_one_sided(listed, e, file.first_number);
    if (!listed.weights.empty() && listed.weights[i] != listed.weights[*reverse])
      throw InputError(at_line(listed.source, e.line),
                       "the edge from vertex " + std::to_string(std::uint64_t{e.from} + file.first_number) +
                           " to vertex " + std::to_string(std::uint64_t{e.to} + file.first_number) +
                           " weighs " + std::to_string(listed.weights[i]) + ", in line " +
                           std::to_string(listed.entries[*reverse].line) + " it weighs " +
                           std::to_string(listed.weights[*reverse]),
                       "give it one weight");
  }
}

}  // namespace

void assemble(ListedGraph&& listed, GraphFile& file) {
  check_size(listed);
  if (!listed.both_directions) add_other_directions(listed);
  std::vector<Entry> rows = sorted_entries(listed);
  file.self_loops = listed.entries.size() - rows.size();
  const auto repeated = std::unique(rows.begin(), rows.end(), [&](Entry a, Entry b) {
    return same_edge(listed.entries[a], listed.entries[b]);
  });
  file.parallel_edges = (static_cast<std::size_t>(rows.end() - repeated) + 1) / 2;
  rows.erase(repeated, rows.end());
  if (listed.both_directions) check_symmetry(listed, rows, file);

  file.graph = CsrGraph(collect_rows<std::uint32_t>(listed.vertices, [&](const auto& add) {
    for (const Entry i : rows) add(listed.entries[i].from, listed.entries[i].to);
  }));
  if (!listed.weights.empty())
    for (const Entry i : rows) file.edge_weights.push_back(listed.weights[i]);
  file.components = components(file.graph).count();
}

}  // namespace leonhard::graph::detail
