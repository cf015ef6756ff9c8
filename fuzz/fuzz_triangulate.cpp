// SPDX-License-Identifier: MIT
// Point sets from bytes, on small integer grids, of nearly tenths or of raw doubles, through every
// triangulation algorithm: the same outcome and the same fingerprint from all, and a mesh in which the public
// validators find nothing. Then the Delaunay tree is asked where points lie and which site is nearest,
// against a look at all sites.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/delaunay/delaunay_tree.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;

std::vector<Point2> points_from(fuzzing::Input& in) {
  const unsigned kind = in.take<std::uint8_t>() % 4;  // 0 to 2: as fuzzing::Input has them; 3: a small grid
  const unsigned grid = 2 + in.take<std::uint8_t>() % 8;
  const std::size_t count = in.take<std::uint8_t>() % 61;
  const auto grid_coordinate = [&] { return static_cast<double>(in.take<std::uint8_t>() % grid); };
  std::vector<Point2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = kind < 3 ? in.coordinate(kind) : grid_coordinate();
    points.push_back({x, kind < 3 ? in.coordinate(kind) : grid_coordinate()});
  }
  return points;
}

void require(bool holds, const std::string& broken, const std::vector<Point2>& points) {
  if (!holds) fuzzing::report(broken.c_str(), points);
}

void check_algorithms(const std::vector<Point2>& points, std::uint64_t seed) {
  const delaunay::Triangulation expected = delaunay::triangulate(points);
  for (const auto& broken : {mesh::validate(expected.mesh), mesh::validate_embedding(expected.mesh),
                             mesh::validate_delaunay(expected.mesh)})
    require(!broken, broken.value_or(""), points);
  for (const delaunay::NamedAlgorithm& named : delaunay::named_algorithms) {
    delaunay::TriangulateOptions options;
    options.algorithm = named.algorithm;
    options.seed = seed;
    const delaunay::Triangulation result = delaunay::triangulate(points, options);
    require(result.outcome == expected.outcome &&
                mesh::fingerprint(result.mesh) == mesh::fingerprint(expected.mesh),
            std::string(named.name) + " gives other triangles", points);
  }
}

/// Neighbouring sites keep their order here, so that the tree takes them as the fuzzer gives them.
std::vector<Point2> distinct(const std::vector<Point2>& points) {
  std::vector<Point2> once;
  for (const Point2 p : points)
    if (std::find(once.begin(), once.end(), p) == once.end()) once.push_back(p);
  return once;
}

bool holds(const delaunay::DelaunayTree& tree, const delaunay::Location& at, Point2 p) {
  using Kind = delaunay::Location::Kind;
  const delaunay::GhostTriangulation& in = tree.triangulation();
  const auto side_of = [&](delaunay::SideId s) {
    return kernel::orient2d(tree.points()[in.origin(s).index()], tree.points()[in.destination(s).index()], p);
  };
  if (at.kind == Kind::on_vertex) return tree.points()[in.origin(at.side).index()] == p;
  if (at.kind == Kind::outside)
    return in.is_ghost(in.triangle(at.side)) && side_of(at.side) == Sign::positive;
  return !in.is_ghost(in.triangle(at.side)) && side_of(in.next(at.side)) == Sign::positive &&
         side_of(in.previous(at.side)) == Sign::positive &&
         side_of(at.side) == (at.kind == Kind::on_side ? Sign::zero : Sign::positive);
}

bool is_nearest(const delaunay::DelaunayTree& tree, VertexId site, Point2 p) {
  const Point2 nearest = tree.points()[site.index()];
  return std::all_of(tree.points().begin(), tree.points().end(), [&](Point2 q) {
    const Sign farther = kernel::compare_distance(p, nearest, q);
    return farther == Sign::negative || (farther == Sign::zero && !(q < nearest));
  });
}

void check_tree(const std::vector<Point2>& points, std::uint64_t seed) {
  delaunay::AlgorithmOptions options;
  options.seed = seed;
  const delaunay::DelaunayTree tree(distinct(points), options);
  if (tree.outcome() != delaunay::TriangulateOutcome::done) return;
  std::vector<Point2> asked = points;
  for (std::size_t i = 1; i < points.size(); ++i)  // halves first: sums may overflow
    asked.push_back({points[i - 1].x / 2 + points[i].x / 2, points[i - 1].y / 2 + points[i].y / 2});
  for (const Point2 p : asked) {
    require(holds(tree, tree.locate(p), p), "the tree locates a point where it is not", points);
    require(is_nearest(tree, tree.nearest(p), p), "the tree does not find the nearest site", points);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input in(data, size);
  const std::uint64_t seed = in.take<std::uint8_t>();
  const std::vector<Point2> points = points_from(in);
  check_algorithms(points, seed);
  check_tree(points, seed);
  return 0;
}
