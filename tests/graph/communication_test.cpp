// SPDX-License-Identifier: MIT
#include "leonhard/graph/communication.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

Partition partition_of(std::uint32_t parts, std::vector<std::uint32_t> part_of) {
  Partition result;
  result.parts = parts;
  result.part_of = std::move(part_of);
  return result;
}

/// Figure 2.3.0: parts 1-2, 2-3, 3-4, 4-1 and 1-3 share boundaries, with 0 for 1.
CsrGraph four_parts() { return graph_from_edges(4, Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}).graph; }

/// Seconds by playing the schedule: each part has a clock; a cycle begins when all are ready.
double simulated(const CommunicationSchedule& schedule, std::uint32_t parts, const MessageCost& cost) {
  std::vector<double> clock(parts, 0);
  for (const auto& cycle : schedule.cycles) {
    const double begin = parts == 0 ? 0 : std::ranges::max(clock);
    std::ranges::fill(clock, begin);
    for (const Exchange& e : cycle) {
      const double end = begin + std::max(cost(e.forwards), cost(e.backwards));
      CHECK(clock[e.first] == begin);  // busy with nothing else in this cycle
      CHECK(clock[e.second] == begin);
      clock[e.first] = clock[e.second] = end;
    }
  }
  return parts == 0 ? 0 : std::ranges::max(clock);
}

}  // namespace

TEST_CASE("messages_are_the_vertices_that_the_other_part_needs") {
  // Two columns of a 4 x 3 grid each: each part sends its inner column.
  const CsrGraph graph = grid(4, 3);
  const Partition halves = partition_of(2, {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1});
  const CommunicationGraph found = communication_graph(graph, halves);
  CHECK(edge_count(found.graph) == 1);
  CHECK(found.message == std::vector<std::uint64_t>{3, 3});
  // A star's hub alone: it sends one value to each part, and gets as many as there are leaves.
  const CommunicationGraph hub = communication_graph(star(7), partition_of(3, {0, 1, 1, 1, 1, 2, 2}));
  CHECK(hub.message == std::vector<std::uint64_t>{1, 1, 4, 2});
}

TEST_CASE("messages_add_up_to_the_halos") {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const CsrGraph graph = random_mesh_graph(14, 11, seed);
    std::mt19937_64 random(seed);
    std::vector<std::uint32_t> part_of(vertex_count(graph));
    for (std::uint32_t& part : part_of) part = static_cast<std::uint32_t>(random() % 6);
    const Partition partition = partition_of(7, part_of);  // the last part is empty
    const CommunicationGraph found = communication_graph(graph, partition);
    CHECK_FALSE(validate(found.graph));
    const PartitionCost cost = partition_cost(graph, partition);
    std::vector<std::uint64_t> received(7, 0);
    std::size_t arc = 0;
    for (std::uint32_t p = 0; p < 7; ++p) {
      CHECK(degree(found.graph, p) == cost.neighbours[p]);
      for (const std::uint32_t q : neighbours(found.graph, p)) received[q] += found.message[arc++];
    }
    for (std::uint32_t p = 0; p < 7; ++p) CHECK(received[p] == cost.halo[p]);
  }
}

TEST_CASE("the_notes_four_parts_exchange_in_three_cycles") {  // figure 2.3.0
  CommunicationGraph four{four_parts(), std::vector<std::uint64_t>(10, 5)};
  const CommunicationSchedule schedule = communication_schedule(four);
  REQUIRE(schedule.cycles.size() == 3);
  std::multiset<std::size_t> sizes;
  for (const auto& cycle : schedule.cycles) sizes.insert(cycle.size());
  CHECK(sizes == std::multiset<std::size_t>{1, 2, 2});
  const CommunicationCost cost = communication_cost(schedule, {2, 1});
  CHECK(cost.cycles == 3);
  CHECK(cost.values == 50);
  CHECK(cost.synchronous_seconds == 3 * 7);
  CHECK(cost.busiest_part_seconds == 3 * 7);
  CHECK(cost.all_messages_seconds == 5 * 7);
}

TEST_CASE("a_schedule_that_is_played_takes_as_long_as_the_cost_model_says") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const CsrGraph graph = random_mesh_graph(20, 20, seed);
    std::vector<std::uint32_t> part_of(vertex_count(graph));
    for (std::uint32_t v = 0; v < part_of.size(); ++v) part_of[v] = v % 21 / 4 + 6 * (v / 21 / 5);
    const std::uint32_t parts = std::ranges::max(part_of) + 1;
    const CommunicationGraph found = communication_graph(graph, partition_of(parts, part_of));
    const CommunicationSchedule schedule = communication_schedule(found);
    const MessageCost message{1e-6, 2.5e-9};
    const CommunicationCost cost = communication_cost(schedule, message);
    CHECK(cost.synchronous_seconds == doctest::Approx(simulated(schedule, parts, message)).epsilon(1e-12));
    CHECK(cost.busiest_part_seconds <= cost.synchronous_seconds * (1 + 1e-12));
    CHECK(cost.cycles <= partition_cost(graph, partition_of(parts, part_of)).max_neighbours + 1);
    std::size_t exchanges = 0;
    for (const auto& cycle : schedule.cycles) exchanges += cycle.size();
    CHECK(exchanges == edge_count(found.graph));
  }
}

TEST_CASE("exchanges_carry_the_message_of_either_direction") {
  const CommunicationGraph hub = communication_graph(star(7), partition_of(3, {0, 1, 1, 1, 1, 2, 2}));
  for (const auto& cycle : communication_schedule(hub).cycles)
    for (const Exchange& e : cycle) {
      CHECK(e.first == 0);
      CHECK(e.forwards == 1);
      CHECK(e.backwards == (e.second == 1 ? 4 : 2));
    }
  // The hub in the last part: it is always the second of an exchange, and the busiest.
  const CommunicationGraph last = communication_graph(star(7), partition_of(4, {3, 0, 0, 0, 1, 1, 2}));
  CHECK(last.message == std::vector<std::uint64_t>{3, 2, 1, 1, 1, 1});
  const CommunicationSchedule schedule = communication_schedule(last);
  std::multiset<std::uint64_t> forwards;
  for (const auto& cycle : schedule.cycles)
    for (const Exchange& e : cycle) {
      CHECK(e.second == 3);
      CHECK(e.backwards == 1);
      forwards.insert(e.forwards);
    }
  CHECK(forwards == std::multiset<std::uint64_t>{1, 2, 3});
  CHECK(communication_cost(schedule, {10, 1}).busiest_part_seconds == 30 + 6);
}

TEST_CASE("exchanges_of_many_parts_carry_what_each_side_needs") {
  const CsrGraph graph = random_mesh_graph(16, 12, 5);
  std::mt19937_64 random(5);
  std::vector<std::uint32_t> part_of(vertex_count(graph));
  for (std::uint32_t v = 0; v < part_of.size(); ++v) part_of[v] = v / 40 + (random() % 8 == 0 ? 1 : 0);
  const Partition partition = partition_of(*std::ranges::max_element(part_of) + 1, part_of);
  const auto needed = [&](std::uint32_t from, std::uint32_t to) {
    std::uint64_t count = 0;
    for (std::uint32_t v = 0; v < part_of.size(); ++v)
      if (part_of[v] == from &&
          std::ranges::any_of(neighbours(graph, v), [&](std::uint32_t w) { return part_of[w] == to; }))
        ++count;
    return count;
  };
  std::size_t one_sided = 0;
  for (const auto& cycle : communication_schedule(communication_graph(graph, partition)).cycles)
    for (const Exchange& e : cycle) {
      CHECK(e.forwards == needed(e.first, e.second));
      CHECK(e.backwards == needed(e.second, e.first));
      one_sided += e.forwards != e.backwards ? 1U : 0U;
    }
  CHECK(one_sided > 2);
}

TEST_CASE("bad_partitions_and_costs_are_refused") {
  CHECK_THROWS_AS(static_cast<void>(communication_graph(path(3), partition_of(2, {0, 1}))), InputError);
  CHECK_THROWS_AS(static_cast<void>(communication_graph(path(3), partition_of(2, {0, 1, 2}))), InputError);
  const CommunicationSchedule none =
      communication_schedule(communication_graph(path(3), partition_of(1, {0, 0, 0})));
  CHECK(communication_cost(none, {1, 1}).synchronous_seconds == 0);
  CHECK_THROWS_AS(static_cast<void>(communication_cost(none, {-1, 1})), InputError);
  CHECK_THROWS_AS(static_cast<void>(communication_cost(none, {1, std::nan("")})), InputError);
}
