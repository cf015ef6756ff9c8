// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/pattern.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

// A path 0 - 1 - ... - (n-1) whose vertices carry shuffled numbers.
struct Path {
  std::vector<std::uint32_t> offsets{0}, links, order;
  explicit Path(std::uint32_t n) {
    std::vector<std::uint32_t> number(n), place(n);
    for (std::uint32_t i = 0; i < n; ++i) number[i] = i * 7919 % n;  // n is no multiple of 7919
    for (std::uint32_t i = 0; i < n; ++i) place[number[i]] = i;
    for (std::uint32_t row = 0; row < n; ++row) {
      if (place[row] > 0) links.push_back(number[place[row] - 1]);
      if (place[row] + 1 < n) links.push_back(number[place[row] + 1]);
      offsets.push_back(static_cast<std::uint32_t>(links.size()));
    }
    order = number;
  }
};

bool is_ink(std::uint32_t word) { return (word & 0xFF) > (word >> 16 & 0xFF) + 30; }  // bluish

}  // namespace

TEST_CASE("entries_stand_at_their_row_and_column_from_the_top_left") {
  const test::Folder folder;
  const std::vector<std::uint32_t> offsets{0, 1, 1, 1, 1}, links{3};
  const MatrixPattern pattern{.offsets = offsets, .links = links, .order = {}, .add_diagonal = false};
  draw_pattern(folder / "pattern.png", std::span(&pattern, 1), "", {.width = 800, .height = 800});
  const test::Pixels picture(folder / "pattern.png");
  const auto [left, top, right, bottom] = picture.box_of(packed(line_colour(0)));
  CHECK(std::abs((right - left) - (bottom - top)) <= 1);
  CHECK(right > 700);  // the last column
  CHECK(top < 100);    // the first row
  CHECK((right - left) < 200);
  CHECK((right - left) > 120);
}

TEST_CASE("an_order_renumbers_rows_and_columns") {
  const test::Folder folder;
  for (const std::uint32_t n : {200U, 5000U}) {  // squares, density
    const Path path(n);
    std::vector<MatrixPattern> patterns(1);
    patterns[0] = {.offsets = path.offsets, .links = path.links, .order = path.order};
    draw_pattern(folder / "pattern.png", patterns, "", {.width = 800, .height = 800});
    const test::Pixels picture(folder / "pattern.png");
    // Tridiagonal: all ink within a band about the diagonal, from corner to corner.
    int least = 800, most = -800, first = 800, last = 0;
    for (int y = 0; y < 800; ++y) {
      for (int x = 0; x < 800; ++x) {
        if (!is_ink(picture.at(x, y))) continue;
        least = std::min(least, x - y);
        most = std::max(most, x - y);
        first = std::min(first, y);
        last = std::max(last, y);
      }
    }
    CHECK(most - least < 16);
    CHECK(last - first > 600);
  }
}

TEST_CASE("no_entry_of_a_large_matrix_is_lost") {
  const test::Folder folder;
  constexpr std::uint32_t n = 100000;
  std::vector<std::uint32_t> offsets(n + 1, 0), links{70000};
  for (std::uint32_t i = 20001; i <= n; ++i) offsets[i] = 1;  // one entry: row 20000, column 70000
  const MatrixPattern pattern{.offsets = offsets, .links = links, .order = {}, .add_diagonal = false};
  draw_pattern(folder / "pattern.png", std::span(&pattern, 1), "", {.width = 800, .height = 800});
  CHECK(test::Pixels(folder / "pattern.png").count(is_ink) == 1);
}

TEST_CASE("two_patterns_stand_side_by_side") {
  const test::Folder folder;
  const Path path(60);
  const std::vector<MatrixPattern> patterns{
      {.offsets = path.offsets, .links = path.links, .order = {}, .title = "before"},
      {.offsets = path.offsets, .links = path.links, .order = path.order, .title = "after"}};
  draw_pattern(folder / "pattern.png", patterns, "Path");
  const test::Pixels picture(folder / "pattern.png");
  std::array<int, 2> inks{};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x)
      inks[x < picture.width / 2 ? 0 : 1] += is_ink(picture.at(x, y)) ? 1 : 0;
  }
  CHECK(inks[0] > 1000);
  CHECK(std::abs(inks[0] - inks[1]) < inks[0] / 10);
}
