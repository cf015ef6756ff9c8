// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/plot3d.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/io/formats/neutral_map.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {
namespace {

constexpr std::array all_sides{BlockSide::i_min, BlockSide::i_max, BlockSide::j_min, BlockSide::j_max};
constexpr std::array<const char*, 4> side_names{"i_min", "i_max", "j_min", "j_max"};

/// The blocks of a file, their points one after another.
struct Plot3dGrid {
  std::vector<BlockSize> sizes;
  std::vector<std::size_t> first;  ///< number of each block's first point
  std::vector<Point2> points;

  [[nodiscard]] std::size_t point(std::size_t block, std::size_t i, std::size_t j) const {
    return first[block] + j * sizes[block].i + i;
  }
  [[nodiscard]] std::size_t point(std::size_t block, BlockSide side, std::size_t along) const {
    const BlockSize& size = sizes[block];
    switch (side) {
      case BlockSide::i_min:
        return point(block, 0, along);
      case BlockSide::i_max:
        return point(block, size.i - 1, along);
      case BlockSide::j_min:
        return point(block, along, 0);
      case BlockSide::j_max:
        return point(block, along, size.j - 1);
    }
    return 0;
  }
  [[nodiscard]] SideRange whole(std::size_t block, BlockSide side) const {
    const bool i_is_fixed = side == BlockSide::i_min || side == BlockSide::i_max;
    return {block, side, 0, (i_is_fixed ? sizes[block].j : sizes[block].i) - 1};
  }
  /// The points of a range in its order.
  [[nodiscard]] std::vector<std::size_t> points_of(const SideRange& range) const {
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < range.point_count(); ++k)
      numbers.push_back(
          point(range.block, range.side, range.from < range.to ? range.from + k : range.from - k));
    return numbers;
  }
};

// ---- the file ----

std::size_t checked_point_count(TextScanner& scan, std::int64_t count) {
  constexpr std::int64_t most = std::int64_t{1} << 31;
  if (count < 2 || count >= most)
    scan.fail("found " + std::to_string(count) + " points in a direction, where a grid has two or more");
  return static_cast<std::size_t>(count);
}

std::size_t read_point_count(TextScanner& scan) {
  return checked_point_count(scan, scan.integer("the number of points in a direction"));
}

/// The number of blocks and their sizes; a single block may come without its number.
std::vector<BlockSize> read_block_sizes(TextScanner& scan) {
  scan.need_line("the number of blocks");
  const std::int64_t first = scan.integer("the number of blocks");
  if (!scan.line_done()) {
    const std::size_t i = checked_point_count(scan, first);
    return {{i, read_point_count(scan)}};
  }
  if (first < 1 || static_cast<std::uint64_t>(first) > scan.bytes_left() / 4)
    scan.fail("found " + std::to_string(first) + " where the number of blocks was expected");
  std::vector<BlockSize> sizes;
  for (std::int64_t block = 0; block < first; ++block) {
    BlockSize size;
    scan.need_word("the number of points in a direction");
    size.i = read_point_count(scan);
    scan.need_word("the number of points in a direction");
    size.j = read_point_count(scan);
    sizes.push_back(size);
  }
  return sizes;
}

void read_block_points(TextScanner& scan, const BlockSize& size, std::vector<Point2>& points) {
  const std::size_t first = points.size(), count = size.i * size.j;
  if (count > (scan.bytes_left() + 1) / 4)  // two numbers a point, a digit and a blank each
    scan.fail("the remaining " + std::to_string(scan.bytes_left()) +
                  " bytes of the file cannot hold a block of " + std::to_string(size.i) + " by " +
                  std::to_string(size.j) + " points",
              "correct its size, or the file was cut short");
  points.resize(first + count);
  for (double Point2::*coordinate : {&Point2::x, &Point2::y}) {
    for (std::size_t p = first; p < points.size(); ++p) {
      scan.need_word("a coordinate");
      points[p].*coordinate = scan.number("a coordinate");
    }
  }
}

Plot3dGrid read_grid(std::string_view text, const std::string& source) {
  TextScanner scan(text, source, {});
  Plot3dGrid grid;
  grid.sizes = read_block_sizes(scan);
  scan.expect_line_end("the sizes of the blocks");
  for (const BlockSize& size : grid.sizes) {
    grid.first.push_back(grid.points.size());
    read_block_points(scan, size, grid.points);
  }
  scan.expect_line_end("the last coordinate");
  if (scan.next_line()) scan.fail_found(scan.rest(), "the end of the file");
  return grid;
}

// ---- joining ----

/// The distance to the nearer one of a point's neighbours in a run.
double shortest_step(const Plot3dGrid& grid, const std::vector<std::size_t>& run, std::size_t k) {
  const Point2 p = grid.points[run[k]];
  const double back = k > 0 ? distance(p, grid.points[run[k - 1]]) : distance(p, grid.points[run[1]]);
  return k + 1 < run.size() ? std::min(back, distance(p, grid.points[run[k + 1]])) : back;
}

/// Joins what a map says is one.
void join_by_map(const Plot3dGrid& grid, const NeutralMap& map, const std::string& map_source,
                 mesh::DisjointSets& same, std::vector<std::string>& warnings) {
  double largest = 0;
  for (const NeutralMap::Join& join : map.joins) {
    const auto one = grid.points_of(join.ranges[0]), other = grid.points_of(join.ranges[1]);
    for (std::size_t k = 0; k < one.size(); ++k) {
      const Point2 p = grid.points[one[k]], q = grid.points[other[k]];
      const double apart = distance(p, q);
      if (apart > std::min(shortest_step(grid, one, k), shortest_step(grid, other, k)))
        throw InputError(at_line(map_source, join.line),
                         "the points at " + mesh::words(p) + " and " + mesh::words(q) +
                             " are to be one, but lie farther apart than the edges at them are long",
                         "correct the ranges, or the order of one of them");
      largest = std::max(largest, apart);
      same.join(one[k], other[k]);
    }
  }
  if (largest > 0)
    warnings.push_back("points that the map joins are not equal, but up to " + mesh::words(largest) +
                       " apart; the first one of each was taken");
}

/// Joins points of sides that are equal. returns how many are joined to another one
std::size_t join_equal_points(const Plot3dGrid& grid, mesh::DisjointSets& same) {
  std::vector<std::size_t> on_sides;
  for (std::size_t block = 0; block < grid.sizes.size(); ++block)
    for (const BlockSide side : all_sides)
      for (const std::size_t p : grid.points_of(grid.whole(block, side))) on_sides.push_back(p);
  std::sort(on_sides.begin(), on_sides.end());
  on_sides.erase(std::unique(on_sides.begin(), on_sides.end()), on_sides.end());
  std::stable_sort(on_sides.begin(), on_sides.end(),
                   [&](std::size_t a, std::size_t b) { return grid.points[a] < grid.points[b]; });
  std::size_t joined = 0;
  for (std::size_t k = 1; k < on_sides.size(); ++k) {
    if (grid.points[on_sides[k - 1]] != grid.points[on_sides[k]]) continue;
    same.join(on_sides[k - 1], on_sides[k]);
    ++joined;
  }
  return joined;
}

/// Vertices of a grid's points: one a class, in the order of the classes' first points.
std::vector<VertexId> make_vertices(const Plot3dGrid& grid, mesh::DisjointSets& same, MixedMesh<2>& mesh) {
  std::vector<VertexId> vertex_of(grid.points.size());
  std::vector<MaybeId<VertexId>> of_class(grid.points.size());
  for (std::size_t p = 0; p < grid.points.size(); ++p) {
    MaybeId<VertexId>& vertex = of_class[same.find(p)];
    if (!vertex) vertex = mesh.points.push_back(grid.points[p]);
    vertex_of[p] = *vertex;
  }
  return vertex_of;
}

// ---- cells and sides ----

/// The corners of a cell of a block but for those equal to the one before, from the lower left in the directions i and j.
std::vector<VertexId> block_cell(const Plot3dGrid& grid, const std::vector<VertexId>& vertex_of,
                                 std::size_t block, std::size_t i, std::size_t j) {
  std::vector<VertexId> corners;
  for (const std::size_t p : {grid.point(block, i, j), grid.point(block, i + 1, j),
                              grid.point(block, i + 1, j + 1), grid.point(block, i, j + 1)})
    if (corners.empty() || corners.back() != vertex_of[p]) corners.push_back(vertex_of[p]);
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

void add_block(const Plot3dGrid& grid, const std::vector<VertexId>& vertex_of, std::size_t block,
               const std::string& source, MixedMesh<2>& mesh) {
  const BlockSize& size = grid.sizes[block];
  std::vector<std::vector<VertexId>> cells;
  std::size_t clockwise = 0;
  for (std::size_t j = 0; j + 1 < size.j; ++j) {
    for (std::size_t i = 0; i + 1 < size.i; ++i) {
      cells.push_back(block_cell(grid, vertex_of, block, i, j));
      const auto& c = cells.back();
      if (c.size() < 3)
        throw InputError(source,
                         "the cell " + std::to_string(i + 1) + ", " + std::to_string(j + 1) + " of block " +
                             std::to_string(block + 1) + " at " +
                             mesh::words(grid.points[grid.point(block, i, j)]) +
                             " has no area: its corners are equal",
                         "correct the coordinates");
      if (kernel::orient2d(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]) == Sign::negative)
        ++clockwise;
    }
  }
  for (auto& corners : cells) {
    if (2 * clockwise > cells.size()) std::reverse(corners.begin() + 1, corners.end());
    mesh.add_cell(corners.size() == 3 ? CellKind::triangle : CellKind::quadrilateral, corners);
  }
}

/// The edges of a range of a side, but for those drawn together to a point.
void add_side_edges(const Plot3dGrid& grid, const std::vector<VertexId>& vertex_of, const SideRange& range,
                    Marker marker, std::vector<MarkedMixedFacet<2>>& edges) {
  const auto points = grid.points_of(range);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const VertexId a = vertex_of[points[k - 1]], b = vertex_of[points[k]];
    if (a != b) edges.push_back({{a, b}, marker});
  }
}

/// Sides by their types.
void mark_by_map(const Plot3dGrid& grid, const std::vector<VertexId>& vertex_of, const NeutralMap& map,
                 MixedMesh<2>& mesh) {
  std::map<std::string, Marker> markers;
  for (const NeutralMap::Patch& patch : map.patches) {
    const auto [at, is_new] = markers.emplace(patch.name, static_cast<Marker>(markers.size() + 1));
    if (is_new) mesh.marker_names.emplace(at->second, patch.name);
    add_side_edges(grid, vertex_of, patch.range, at->second, mesh.boundary);
  }
}

/// Sides by their names, but for edges that two of them have in common: the cut.
void mark_by_side(const Plot3dGrid& grid, const std::vector<VertexId>& vertex_of, MixedMesh<2>& mesh) {
  std::vector<MarkedMixedFacet<2>> edges;
  Marker marker = 0;
  for (std::size_t block = 0; block < grid.sizes.size(); ++block) {
    for (const BlockSide side : all_sides) {
      const std::string name = side_names[static_cast<std::size_t>(side)];
      mesh.marker_names.emplace(
          ++marker, grid.sizes.size() == 1 ? name : "block_" + std::to_string(block + 1) + "_" + name);
      add_side_edges(grid, vertex_of, grid.whole(block, side), marker, edges);
    }
  }
  std::map<std::pair<VertexId, VertexId>, int> uses;
  const auto ends = [](const MarkedMixedFacet<2>& edge) {
    return std::minmax({edge.corners[0], edge.corners[1]});
  };
  for (const auto& edge : edges) ++uses[ends(edge)];
  for (const auto& edge : edges)
    if (uses.at(ends(edge)) == 1) mesh.boundary.push_back(edge);
  std::erase_if(mesh.marker_names, [&](const auto& name) {
    return std::none_of(mesh.boundary.begin(), mesh.boundary.end(),
                        [&](const auto& edge) { return edge.marker == name.first; });
  });
}

}  // namespace

MeshSoup<2> plot3d_soup(std::string_view text, const std::string& source, std::string_view map_text,
                        const std::string& map_source) {
  const Plot3dGrid grid = read_grid(text, source);
  MeshSoup<2> soup;
  soup.source = source;
  mesh::DisjointSets same(grid.points.size());
  NeutralMap map;
  if (!map_source.empty()) {
    map = parse_neutral_map(map_text, map_source, grid.sizes);
    join_by_map(grid, map, map_source, same, soup.warnings);
  } else if (const std::size_t joined = join_equal_points(grid, same); joined > 0) {
    soup.warnings.push_back(std::to_string(joined) +
                            " points on sides of blocks are equal to others and were joined");
  }
  const std::vector<VertexId> vertex_of = make_vertices(grid, same, soup.mesh);
  for (std::size_t block = 0; block < grid.sizes.size(); ++block)
    add_block(grid, vertex_of, block, source, soup.mesh);
  if (map_source.empty()) {
    mark_by_side(grid, vertex_of, soup.mesh);
  } else {
    mark_by_map(grid, vertex_of, map, soup.mesh);
  }
  return soup;
}

MixedMeshFile<2> parse_plot3d(std::string_view text, const std::string& source, std::string_view map_text,
                              const std::string& map_source) {
  return assemble_mixed(plot3d_soup(text, source, map_text, map_source));
}

MeshSoup<2> read_plot3d_soup(const std::filesystem::path& path) {
  const std::filesystem::path map = std::filesystem::path(path).replace_extension(".nmf");
  if (!std::filesystem::exists(map)) return plot3d_soup(read_whole_file(path), path.string(), {}, {});
  return plot3d_soup(read_whole_file(path), path.string(), read_whole_file(map), map.string());
}

MixedMeshFile<2> read_plot3d(const std::filesystem::path& path) {
  return assemble_mixed(read_plot3d_soup(path));
}

}  // namespace leonhard::io
