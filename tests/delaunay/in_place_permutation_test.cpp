// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/in_place_permutation.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <random>

namespace leonhard::delaunay {
namespace {

TEST_CASE("every_value_reaches_its_place_for_any_size_and_number_of_threads") {
  std::mt19937_64 random(1);
  for (const std::size_t size : {0, 1, 2, 7, 32768, 32769, 200'000}) {
    std::vector<IdRaw> to(size);
    std::iota(to.begin(), to.end(), IdRaw{0});
    std::shuffle(to.begin(), to.end(), random);
    for (const unsigned threads : {1U, 0U}) {
      std::vector<IdRaw> left = to, values = to;
      std::vector<double> others(to.begin(), to.end());
      permute_in_place(left, threads, values, others);
      bool right = true;
      for (std::size_t i = 0; i < size; ++i)
        right = right && values[i] == i && others[i] == static_cast<double>(i);
      CHECK(right);
    }
  }
}

}  // namespace
}  // namespace leonhard::delaunay
