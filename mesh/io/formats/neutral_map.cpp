// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/neutral_map.hpp"

#include <algorithm>
#include <optional>

#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {
namespace {

/// Which of the directions i, j, k of a map's block are the grid's i and j.
struct Directions {
  std::size_t i, j;
  std::optional<std::size_t> span;  ///< the third one; none: the map is one of the plane
};

/// Faces k min, k max, i min, i max, j min, j max by direction.
constexpr std::array<std::size_t, 6> direction_of_face{2, 2, 0, 0, 1, 1};

class NeutralMapParser {
 public:
  NeutralMapParser(std::string_view text, const std::string& source, const std::vector<BlockSize>& sizes)
      : scan_(text, source, {.comment = '#'}), sizes_(sizes) {}

  NeutralMap parse() {
    scan_.need_line("the number of blocks");
    const std::int64_t blocks = scan_.integer("the number of blocks");
    if (blocks != static_cast<std::int64_t>(sizes_.size()))
      scan_.fail("the map has " + std::to_string(blocks) + " blocks, the grid " +
                 std::to_string(sizes_.size()));
    for (std::size_t block = 0; block < sizes_.size(); ++block) read_block(block);
    while (scan_.next_line()) read_patch();
    return std::move(map_);
  }

 private:
  void read_block(std::size_t block) {
    scan_.need_line("the dimensions of a block");
    if (scan_.integer("the number of a block") != static_cast<std::int64_t>(block + 1))
      scan_.fail("block " + std::to_string(block + 1) + " was expected here");
    std::array<std::int64_t, 3> points{};
    for (auto& count : points) count = scan_.integer("the number of points in a direction");
    scan_.expect_line_end("the dimensions of the block");
    const auto is_grid = [&](std::size_t i, std::size_t j) {
      return points[i] == static_cast<std::int64_t>(sizes_[block].i) &&
             points[j] == static_cast<std::int64_t>(sizes_[block].j);
    };
    if (points[2] == 1 && is_grid(0, 1)) return directions_.push_back({0, 1, std::nullopt});
    for (const std::size_t span : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      const std::size_t i = span == 0 ? 1 : 0, j = span == 2 ? 1 : 2;
      if (points[span] == 2 && is_grid(i, j)) return directions_.push_back({i, j, span});
    }
    scan_.fail("block " + std::to_string(block + 1) + " is no grid of " + std::to_string(sizes_[block].i) +
                   " by " + std::to_string(sizes_[block].j) +
                   " points, nor one moved along a third direction",
               "give the map of this grid");
  }

  void read_patch() {
    std::string name(scan_.word("the type of a patch"));
    std::erase_if(name, [](char c) { return c == '\'' || c == '"'; });
    const std::size_t line = scan_.line();
    const std::optional<SideRange> range = read_range();
    std::string upper = name;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    if (upper != "ONE_TO_ONE") {
      if (name.empty()) scan_.fail("a patch has no type");
      if (range) map_.patches.push_back({name, *range, line});
      return;
    }
    const std::optional<SideRange> other = read_range();
    if (range.has_value() != other.has_value()) scan_.fail("a side of the grid is joined to the grid itself");
    if (!range) return;
    if (range->point_count() != other->point_count())
      scan_.fail("a side of " + std::to_string(range->point_count()) + " points is joined to one of " +
                 std::to_string(other->point_count()));
    map_.joins.push_back({{*range, *other}, line});
  }

  /// Block, face and two ranges; none if the face is the grid itself.
  std::optional<SideRange> read_range() {
    SideRange range;
    range.block = read_number("the number of a block", sizes_.size()) - 1;
    const Directions& directions = directions_[range.block];
    const std::size_t face = read_number("the number of a face", directions.span ? 6 : 4);
    std::array<std::array<std::size_t, 2>, 2> ends{};
    for (auto& of_range : ends)
      for (std::size_t& end : of_range) end = read_number("the number of a point", 0);
    const bool is_max = face % 2 == 0;
    const std::size_t across = directions.span ? direction_of_face[face - 1] : (face - 1) / 2;
    if (across == directions.span) return std::nullopt;
    const bool i_is_fixed = across == directions.i;
    range.side = i_is_fixed ? (is_max ? BlockSide::i_max : BlockSide::i_min)
                            : (is_max ? BlockSide::j_max : BlockSide::j_min);
    // The ranges of a face are those of the two directions that follow the one across it, in their cycle.
    const std::size_t along = i_is_fixed ? directions.j : directions.i;
    const bool is_second =
        directions.span ? (across + 2) % 3 == along : ends[0] == std::array<std::size_t, 2>{1, 1};
    set_points(range, ends[is_second ? 1 : 0], i_is_fixed ? sizes_[range.block].j : sizes_[range.block].i);
    return range;
  }

  void set_points(SideRange& range, const std::array<std::size_t, 2>& ends, std::size_t count) {
    if (ends[0] == ends[1] || std::max(ends[0], ends[1]) > count)
      scan_.fail("the points " + std::to_string(ends[0]) + " to " + std::to_string(ends[1]) +
                 " are no part of a side of " + std::to_string(count) + " points");
    range.from = ends[0] - 1;
    range.to = ends[1] - 1;
  }

  /// From 1 to `most`, if that is not 0.
  std::size_t read_number(const char* expected, std::size_t most) {
    const std::int64_t number = scan_.integer(expected);
    if (number < 1 || (most != 0 && number > static_cast<std::int64_t>(most)))
      scan_.fail("found " + std::to_string(number) + " where " + expected + " was expected" +
                 (most == 0 ? "" : ", from 1 to " + std::to_string(most)));
    return static_cast<std::size_t>(number);
  }

  TextScanner scan_;
  const std::vector<BlockSize>& sizes_;
  std::vector<Directions> directions_;
  NeutralMap map_;
};

}  // namespace

NeutralMap parse_neutral_map(std::string_view text, const std::string& source,
                             const std::vector<BlockSize>& sizes) {
  return NeutralMapParser(text, source, sizes).parse();
}

}  // namespace leonhard::io
