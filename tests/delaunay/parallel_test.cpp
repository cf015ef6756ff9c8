// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/support/parallel.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <vector>

namespace leonhard {
namespace {

TEST_CASE("every_block_runs_once_for_any_number_of_threads") {
  for (const unsigned threads : {0U, 1U, 2U, 100U}) {
    std::vector<int> runs(1000, 0);
    delaunay::parallel_for_blocks(runs.size(), threads, [&](std::size_t block) { ++runs[block]; });
    CHECK(runs == std::vector<int>(1000, 1));
    CHECK(delaunay::thread_count(threads) >= 1);
  }
  delaunay::parallel_for_blocks(0, 2, [](std::size_t) { FAIL("no block was asked for"); });
}

TEST_CASE("both_bodies_run_and_calls_may_be_nested") {
  int sums[2] = {0, 0};
  delaunay::parallel_invoke(
      4,
      [&] {
        delaunay::parallel_invoke(
            2, [&] { sums[0] = 1; }, [&] { sums[1] = 2; });
      },
      [] {});
  CHECK(sums[0] + sums[1] == 3);
}

TEST_CASE("an_exception_of_a_body_reaches_the_caller") {
  for (const unsigned threads : {1U, 2U})
    CHECK_THROWS_AS(delaunay::parallel_for_blocks(8, threads,
                                                  [](std::size_t block) {
                                                    if (block == 5) throw std::runtime_error("block 5");
                                                  }),
                    std::runtime_error);
}

}  // namespace
}  // namespace leonhard
