// SPDX-License-Identifier: MIT
#include "leonhard/graph/halo.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "leonhard/graph/communication.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

Partition random_parts(const CsrGraph& graph, std::uint32_t parts, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Partition result{parts, {}};
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    result.part_of.push_back(static_cast<std::uint32_t>(random() % parts));
  return result;
}

std::vector<CsrGraph> halo_shelf() {
  return {
      path(0), path(1), path(9), star(8), grid(6, 5), random_graph(30, 40, 2), random_mesh_graph(9, 7, 1)};
}

/// One exchange: every part sends the values of what it owns, in the sequence of its send lists.
std::vector<std::vector<double>> exchanged(const std::vector<PartHalo>& halos,
                                           const std::vector<double>& value) {
  std::vector<std::vector<double>> local(halos.size());
  for (std::size_t p = 0; p < halos.size(); ++p) {
    for (const std::uint32_t v : halos[p].owned) local[p].push_back(value[v]);
    local[p].resize(halos[p].local_count(), -1);
  }
  for (std::size_t p = 0; p < halos.size(); ++p)
    for (std::size_t i = 0; i < halos[p].neighbours.size(); ++i) {
      const std::uint32_t q = halos[p].neighbours[i];
      const PartHalo& to = halos[q];
      const auto back = static_cast<std::size_t>(
          std::ranges::lower_bound(to.neighbours, static_cast<std::uint32_t>(p)) - to.neighbours.begin());
      REQUIRE(to.neighbours[back] == p);
      REQUIRE(halos[p].send[i].size() == to.receive_begin[back + 1] - to.receive_begin[back]);
      std::uint32_t place = to.receive_begin[back];
      for (const std::uint32_t v : halos[p].send[i]) local[q][place++] = local[p][v];
    }
  return local;
}

}  // namespace

TEST_CASE("every_vertex_is_owned_once_and_every_neighbour_is_at_hand") {
  for (const CsrGraph& graph : halo_shelf())
    for (const std::uint32_t parts : {1U, 2U, 5U}) {
      const Partition partition = random_parts(graph, parts, parts);
      const std::vector<PartHalo> made = halos(graph, partition);
      REQUIRE(made.size() == parts);
      CHECK(validate(graph, made) == std::nullopt);
      std::vector<std::uint32_t> owned;
      for (std::uint32_t p = 0; p < parts; ++p) {
        CHECK(std::ranges::is_sorted(made[p].owned));
        for (const std::uint32_t v : made[p].owned) {
          CHECK(partition.part_of[v] == p);
          owned.push_back(v);
        }
        for (const Ghost& ghost : made[p].ghosts) {
          CHECK(ghost.owner == partition.part_of[ghost.vertex]);
          CHECK(ghost.owner != p);
        }
      }
      CHECK(is_permutation_of_all(graph, owned));
    }
}

TEST_CASE("one_exchange_gives_every_ghost_its_owners_value") {
  for (const CsrGraph& graph : halo_shelf()) {
    const std::vector<PartHalo> made = halos(graph, random_parts(graph, 4, 9));
    std::vector<double> value(vertex_count(graph));
    std::iota(value.begin(), value.end(), 100.0);
    const auto local = exchanged(made, value);
    for (std::size_t p = 0; p < made.size(); ++p)
      for (std::size_t i = 0; i < made[p].ghosts.size(); ++i)
        CHECK(local[p][made[p].owned.size() + i] == value[made[p].ghosts[i].vertex]);
  }
}

TEST_CASE("sums_over_neighbours_are_the_same_part_by_part") {
  const CsrGraph graph = random_mesh_graph(9, 7, 1);
  const std::vector<PartHalo> made = halos(graph, random_parts(graph, 3, 1));
  std::vector<double> value(vertex_count(graph));
  std::iota(value.begin(), value.end(), 1.0);
  const auto local = exchanged(made, value);
  for (std::size_t p = 0; p < made.size(); ++p) {
    const CsrGraph piece = local_graph(graph, made[p]);
    CHECK(validate(piece) == std::nullopt);
    REQUIRE(vertex_count(piece) == made[p].local_count());
    for (std::uint32_t i = 0; i < made[p].owned.size(); ++i) {
      double here = 0, whole = 0;
      for (const std::uint32_t j : neighbours(piece, i)) here += local[p][j];
      for (const std::uint32_t w : neighbours(graph, made[p].owned[i])) whole += value[w];
      CHECK(here == whole);
    }
  }
}

TEST_CASE("halos_agree_with_the_communication_graph_and_the_cost") {
  const CsrGraph graph = random_mesh_graph(12, 10, 5);
  const Partition partition = leonhard::graph::partition(graph, 6);
  const std::vector<PartHalo> made = halos(graph, partition);
  const CommunicationGraph communication = communication_graph(graph, partition);
  const PartitionCost cost = partition_cost(graph, partition);
  std::size_t message = 0;
  for (std::uint32_t p = 0; p < 6; ++p) {
    CHECK(std::ranges::equal(made[p].neighbours, neighbours(communication.graph, p)));
    CHECK(made[p].ghosts.size() == cost.halo[p]);
    for (std::size_t i = 0; i < made[p].neighbours.size(); ++i)
      CHECK(made[p].send[i].size() == communication.message[message++]);
  }
}

TEST_CASE("halos_of_triangles_take_a_typed_partition") {
  const TriangleMesh mesh = random_triangulation(6, 6, 2);
  const TrianglePartition parts = partition_triangles(mesh, 4);
  CHECK(validate(dual_graph(mesh), halos(dual_graph(mesh), parts)) == std::nullopt);
}

TEST_CASE("validate_names_what_is_wrong_with_halos") {
  const CsrGraph graph = path(4);
  const std::vector<PartHalo> good = halos(graph, Partition{2, {0, 0, 1, 1}});
  auto bad = good;
  bad[0].owned.pop_back();
  CHECK(validate(graph, bad).value().find("vertex 1 is owned by no part") != std::string::npos);
  bad = good;
  bad[1].owned.insert(bad[1].owned.begin(), 0);
  CHECK(validate(graph, bad).value().find("vertex 0 is owned by parts 0 and 1") != std::string::npos);
  bad = good;
  bad[0].ghosts[0].vertex = 3;
  CHECK(validate(graph, bad).value().find("vertex 2, a neighbour of vertex 1, is no ghost of part 0") !=
        std::string::npos);
  bad = good;
  bad[0].send = CompressedRows<std::uint32_t>({0, 1}, {0});
  CHECK(validate(graph, bad).value().find("part 0 sends vertex 0 where part 1 expects vertex 1") !=
        std::string::npos);
}

TEST_CASE("halos_refuse_a_partition_of_something_else") {
  CHECK_THROWS_AS(static_cast<void>(halos(path(3), Partition{2, {0, 1}})), InputError);
  CHECK_THROWS_AS(static_cast<void>(halos(path(3), Partition{2, {0, 1, 2}})), InputError);
}
