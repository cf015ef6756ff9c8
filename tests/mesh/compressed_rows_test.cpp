// SPDX-License-Identifier: MIT
#include "leonhard/mesh/compressed_rows.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

using namespace leonhard;

TEST_CASE("rows_come_out_as_they_were_added") {
  CompressedRows<char> rows;
  CHECK(rows.empty());
  CHECK(rows.offsets().size() == 1);
  for (const std::string& row : {std::string("abc"), std::string(), std::string("d")}) {
    for (const char letter : row) rows.add_link(letter);
    rows.end_row();
  }
  CHECK(rows == CompressedRows<char>({0, 3, 3, 4}, {'a', 'b', 'c', 'd'}));
  CHECK(rows.size() == 3);
  CHECK(rows.link_count() == 4);
  CHECK(std::ranges::equal(rows[0], std::string("abc")));
  CHECK(rows[1].empty());
  rows[0][1] = 'x';
  CHECK(rows.links()[1] == 'x');
}

TEST_CASE("collected_rows_keep_the_sequence_in_which_links_are_named") {
  const std::vector<std::array<std::uint32_t, 2>> pairs{{2, 7}, {0, 9}, {2, 1}, {0, 9}, {3, 0}};
  const auto rows = collect_rows<std::uint32_t, std::uint64_t>(5, [&](const auto& add) {
    for (const auto& [row, link] : pairs) add(row, link);
  });
  CHECK(rows == CompressedRows<std::uint32_t, std::uint64_t>({0, 2, 2, 4, 5, 5}, {9, 9, 7, 1, 0}));
}

TEST_CASE("rows_moved_from_may_be_assigned_again") {
  CompressedRows<int> rows({0, 1}, {5});
  const CompressedRows<int> taken = std::move(rows);
  CHECK(taken.size() == 1);
  rows = CompressedRows<int>();
  CHECK(rows.empty());
}
