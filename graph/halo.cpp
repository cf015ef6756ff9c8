// SPDX-License-Identifier: MIT
#include "leonhard/graph/halo.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

#include "leonhard/graph/partition/partition_checks.hpp"

namespace leonhard::graph {
namespace {

bool by_owner(const Ghost& a, const Ghost& b) {
  return std::tie(a.owner, a.vertex) < std::tie(b.owner, b.vertex);
}

/// The vertices of other parts next to a part's own, each once.
std::vector<Ghost> ghosts_of(const CsrGraph& graph, const PartitionView& partition,
                             std::span<const std::uint32_t> owned) {
  std::vector<Ghost> ghosts;
  for (const std::uint32_t v : owned)
    for (const std::uint32_t w : neighbours(graph, v))
      if (partition.part_of[w] != partition.part_of[v]) ghosts.push_back({w, partition.part_of[w]});
  std::ranges::sort(ghosts, by_owner);
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  return ghosts;
}

/// Parts and places that follow from the ghosts: who sends them, and where they lie.
void list_senders(PartHalo& halo) {
  for (std::uint32_t i = 0; i < halo.ghosts.size(); ++i) {
    if (i > 0 && halo.ghosts[i].owner == halo.ghosts[i - 1].owner) continue;
    halo.neighbours.push_back(halo.ghosts[i].owner);
    halo.receive_begin.push_back(static_cast<std::uint32_t>(halo.owned.size()) + i);
  }
  halo.receive_begin.push_back(halo.local_count());
}

std::uint32_t local_number_of_owned(const PartHalo& halo, std::uint32_t vertex) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(halo.owned, vertex) - halo.owned.begin());
}

/// Parts are each other's neighbours, because edges go both ways: what q lists as ghosts of part p, p sends.
void list_sent(std::vector<PartHalo>& halos, std::uint32_t part) {
  PartHalo& halo = halos[part];
  for (const std::uint32_t other : halo.neighbours) {
    const PartHalo& receiver = halos[other];
    const auto at = std::ranges::lower_bound(receiver.neighbours, part) - receiver.neighbours.begin();
    for (const Ghost& ghost : receiver.received_from(static_cast<std::size_t>(at)))
      halo.send.add_link(local_number_of_owned(halo, ghost.vertex));
    halo.send.end_row();
  }
}

}  // namespace

std::vector<PartHalo> halos(const CsrGraph& graph, const PartitionView& partition) {
  detail::check_partition(partition, vertex_count(graph), "vertices");
  std::vector<PartHalo> result(partition.parts);
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) result[partition.part_of[v]].owned.push_back(v);
  for (PartHalo& halo : result) {
    halo.ghosts = ghosts_of(graph, partition, halo.owned);
    list_senders(halo);
  }
  for (std::uint32_t part = 0; part < partition.parts; ++part) list_sent(result, part);
  return result;
}

CsrGraph local_graph(const CsrGraph& graph, const PartHalo& halo) {
  const auto owned_count = static_cast<std::uint32_t>(halo.owned.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ghosts;  // vertex, local number
  for (std::uint32_t i = 0; i < halo.ghosts.size(); ++i)
    ghosts.emplace_back(halo.ghosts[i].vertex, owned_count + i);
  std::ranges::sort(ghosts);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::uint32_t i = 0; i < owned_count; ++i)
    for (const std::uint32_t w : neighbours(graph, halo.owned[i])) {
      const auto ghost =
          std::ranges::lower_bound(ghosts, w, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
      if (ghost != ghosts.end() && ghost->first == w)
        edges.push_back({i, ghost->second});
      else if (halo.owned[i] < w)
        edges.push_back({i, local_number_of_owned(halo, w)});
    }
  return graph_from_edges(halo.local_count(), edges).graph;
}

namespace {

using Word = std::optional<std::string>;

/// To each vertex its part.
Word list_owners(std::span<const PartHalo> halos, std::vector<std::uint32_t>& owner) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::ranges::fill(owner, none);
  for (std::uint32_t part = 0; part < halos.size(); ++part)
    for (const std::uint32_t v : halos[part].owned) {
      if (v >= owner.size())
        return "part " + std::to_string(part) + " owns vertex " + std::to_string(v) +
               ", which does not exist";
      if (owner[v] != none)
        return "vertex " + std::to_string(v) + " is owned by parts " + std::to_string(owner[v]) + " and " +
               std::to_string(part);
      owner[v] = part;
    }
  if (const auto lost = std::ranges::find(owner, none); lost != owner.end())
    return "vertex " + std::to_string(lost - owner.begin()) + " is owned by no part";
  return std::nullopt;
}

Word check_ghosts(const CsrGraph& graph, std::span<const PartHalo> halos,
                  std::span<const std::uint32_t> owner) {
  for (std::uint32_t part = 0; part < halos.size(); ++part)
    for (const std::uint32_t v : halos[part].owned)
      for (const std::uint32_t w : neighbours(graph, v))
        if (owner[w] != part && !std::ranges::binary_search(halos[part].ghosts, Ghost{w, owner[w]}, by_owner))
          return "vertex " + std::to_string(w) + ", a neighbour of vertex " + std::to_string(v) +
                 ", is no ghost of part " + std::to_string(part);
  return std::nullopt;
}

/// What one part sends another against what that one expects.
Word check_message(std::span<const PartHalo> halos, std::uint32_t from, std::size_t i) {
  const PartHalo& sender = halos[from];
  const std::uint32_t to = sender.neighbours[i];
  const std::string who = "part " + std::to_string(from) + " sends ";
  const std::string whom = " part " + std::to_string(to) + " expects ";
  if (to >= halos.size()) return who + "to part " + std::to_string(to) + ", which does not exist";
  const auto back = std::ranges::find(halos[to].neighbours, from) - halos[to].neighbours.begin();
  if (back == std::ssize(halos[to].neighbours)) return who + "where" + whom + "nothing";
  const auto expected = halos[to].received_from(static_cast<std::size_t>(back));
  const auto sent = sender.send[i];
  if (sent.size() != expected.size())
    return who + std::to_string(sent.size()) + " values where" + whom + std::to_string(expected.size());
  for (std::size_t k = 0; k < sent.size(); ++k)
    if (sent[k] >= sender.owned.size() || sender.owned[sent[k]] != expected[k].vertex)
      return who +
             (sent[k] < sender.owned.size() ? "vertex " + std::to_string(sender.owned[sent[k]])
                                            : "what it does not own") +
             " where" + whom + "vertex " + std::to_string(expected[k].vertex);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> validate(const CsrGraph& graph, std::span<const PartHalo> halos) {
  std::vector<std::uint32_t> owner(vertex_count(graph));
  if (const Word wrong = list_owners(halos, owner)) return wrong;
  if (const Word wrong = check_ghosts(graph, halos, owner)) return wrong;
  for (std::uint32_t part = 0; part < halos.size(); ++part)
    for (std::size_t i = 0; i < halos[part].neighbours.size(); ++i)
      if (const Word wrong = check_message(halos, part, i)) return wrong;
  return std::nullopt;
}

}  // namespace leonhard::graph
