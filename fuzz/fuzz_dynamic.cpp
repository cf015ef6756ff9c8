// SPDX-License-Identifier: MIT
// Sequences of insertions, removals, moves and queries from bytes, on small integer grids, nearly tenths and raw
// doubles: every invariant after each step, queries against a look at all vertices, and at the end the
// triangles from scratch.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;
using delaunay::DynamicTriangulation;
using Kind = delaunay::PointLocation::Kind;

/// The triangulation, what it must know, and how it came to be.
class Sequence {
 public:
  void insert(Point2 p, MaybeId<VertexId> hint) {
    note("insert", p);
    const auto [v, is_new] = sites_.insert(p, hint);
    const auto known = ids_.find(p);
    require(is_new == (known == ids_.end()), "insert tells new from known wrongly");
    require(is_new || known->second == v, "an id has changed");
    ids_.emplace(p, v);
    check();
  }
  void insert(const std::vector<Point2>& points) {
    for (const Point2 p : points) note("insert", p);
    const std::vector<VertexId> vertices = sites_.insert(points);
    for (std::size_t i = 0; i < points.size(); ++i) ids_.emplace(points[i], vertices[i]);
    check();
  }
  void remove(std::size_t which) {
    if (ids_.empty()) return;
    auto chosen = ids_.begin();
    std::advance(chosen, which % ids_.size());
    note("remove", chosen->first);
    sites_.remove(chosen->second);
    ids_.erase(chosen);
    check();
  }
  void move(std::size_t which, Point2 to) {
    if (ids_.empty()) return;
    auto chosen = ids_.begin();
    std::advance(chosen, which % ids_.size());
    note("move from", chosen->first);
    note("to", to);
    const VertexId v = chosen->second;
    const auto occupant = ids_.find(to);
    const delaunay::Moved moved = sites_.move(v, to);
    if (occupant != ids_.end()) {
      require(moved.vertex == occupant->second, "a move tells the occupant wrongly");
      require((moved.outcome == delaunay::MoveOutcome::moved) == (occupant == chosen),
              "a move tells its outcome wrongly");
    } else {
      require(moved.outcome == delaunay::MoveOutcome::moved && moved.vertex == v, "a move has changed an id");
      ids_.erase(chosen);
      ids_.emplace(to, v);
    }
    check();
  }
  void ask(Point2 p, MaybeId<VertexId> hint) {
    note("ask", p);
    const auto known = ids_.find(p);
    const delaunay::PointLocation at = sites_.locate(p, hint);
    require((at.kind == Kind::on_vertex) == (known != ids_.end()), "locate finds a vertex wrongly");
    require(sites_.locate(p) == at, "the hint changes the location");
    check_nearest(p, sites_.nearest_vertex(p, hint));
    check_weights(at.kind, sites_.natural_neighbours(p, hint));
    check_k_nearest(p, sites_.k_nearest_vertices(p, 5, hint));
    check_cells(p);
    check_counts();
  }
  void check_from_scratch() const {
    std::vector<Point2> points;
    for (const auto& [p, v] : ids_) points.push_back(p);
    const DynamicTriangulation::Mesh copy = sites_.to_mesh();
    if (sites_.extent() == delaunay::Extent::plane) {
      const auto broken = mesh::validate(copy.mesh);
      require(!broken, broken.value_or(""));
    }
    require(mesh::fingerprint(copy.mesh) == mesh::fingerprint(delaunay::triangulate(points).mesh),
            "triangulate() gives other triangles");
  }
  [[nodiscard]] MaybeId<VertexId> hint(std::uint8_t byte) const {
    return byte % 4 == 0 ? MaybeId<VertexId>{} : MaybeId<VertexId>(VertexId{byte});
  }

 private:
  void note(const char* what, Point2 p) {
    std::array<char, 96> line{};
    std::snprintf(line.data(), line.size(), "%s({%a, %a});\n", what, p.x, p.y);
    history_ += line.data();
  }
  /// Ends the program after printing the sequence; remove names the vertex by its place.
  void require(bool holds, const std::string& words) const {
    if (holds) return;
    std::fprintf(stderr, "\n%s// %s\n", history_.c_str(), words.c_str());
    std::abort();
  }
  void check() const {
    const auto broken = sites_.validate();
    require(!broken, broken.value_or(""));
    require(sites_.size() == ids_.size(), "the number of vertices is wrong");
    for (const auto& [p, v] : ids_) require(sites_.contains(v) && sites_.point(v) == p, "an id is lost");
  }
  void check_nearest(Point2 p, MaybeId<VertexId> found) const {
    require(found.has_value() == !ids_.empty(), "no nearest vertex");
    for (const auto& [q, v] : ids_) {
      const Sign sign = kernel::exact::compare_distance(p, q, sites_.point(*found));
      require(sign == Sign::positive || (sign == Sign::zero && !(q < sites_.point(*found))),
              "another vertex is nearer");
    }
  }
  void check_k_nearest(Point2 p, const std::vector<VertexId>& found) const {
    std::vector<Point2> all;
    for (const auto& [q, v] : ids_) all.push_back(q);
    std::stable_sort(all.begin(), all.end(), [&](Point2 a, Point2 b) {
      return kernel::exact::compare_distance(p, a, b) == Sign::negative;
    });
    require(found.size() == std::min<std::size_t>(5, all.size()), "too few or too many nearest vertices");
    for (std::size_t i = 0; i < found.size(); ++i)
      require(sites_.point(found[i]) == all[i], "the k nearest vertices are others");
  }
  /// p is in the cells of those vertices that no other one is nearer than.
  void check_cells(Point2 p) const {
    const MaybeId<VertexId> nearest = sites_.nearest_vertex(p);
    for (const auto& entry : ids_) {
      const Point2 q = entry.first;  // clang 14 captures no structured binding
      const VertexId v = entry.second;
      const auto is_nearer = [&](VertexId w) {
        return kernel::exact::compare_distance(p, sites_.point(w), q) == Sign::negative;
      };
      const delaunay::VoronoiCell cell = sites_.voronoi_cell(v);
      require(std::none_of(cell.across.begin(), cell.across.end(), is_nearer) == !is_nearer(*nearest),
              "a Voronoi cell lacks a side or has one too many");
      require(cell.is_bounded() == (sites_.extent() == delaunay::Extent::plane && !sites_.on_hull(v)),
              "a Voronoi cell is bounded on the hull or unbounded within");
    }
  }
  void check_counts() const {
    std::size_t edges = 0, triangles = 0, corners = 0, ends = 0;
    for ([[maybe_unused]] const auto& edge : sites_.edges()) ++edges;
    for ([[maybe_unused]] const auto& triangle : sites_.triangles()) ++triangles;
    for (const auto& [q, v] : ids_) {
      corners += sites_.triangles_at(v).size();
      for ([[maybe_unused]] const VertexId w : sites_.neighbours(v)) ++ends;
    }
    require(edges == sites_.edge_count() && ends == 2 * edges, "edges are counted wrongly");
    require(triangles == sites_.triangle_count() && corners == 3 * triangles,
            "triangles are counted wrongly");
  }
  void check_weights(Kind kind, const delaunay::NaturalNeighbours& found) const {
    require(found.where == kind, "natural_neighbours and locate disagree");
    double sum = 0;
    for (const auto& [v, weight] : found.weights) {
      require(sites_.contains(v) && weight >= 0, "a weight is negative or of no vertex");
      sum += weight;
    }
    require(kind == Kind::outside ? found.weights.empty() : std::abs(sum - 1) < 1e-9,
            "the weights do not sum to 1");
  }

  DynamicTriangulation sites_;
  std::map<Point2, VertexId, std::less<>> ids_;
  std::string history_;
};

Point2 point_from(fuzzing::Input& in, unsigned kind) {
  if (kind < 3) return in.point(kind);
  const double x = in.take<std::uint8_t>() % kind;  // a small grid
  return {x, static_cast<double>(in.take<std::uint8_t>() % kind)};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input in(data, size);
  const unsigned kind = in.take<std::uint8_t>() % 8;
  Sequence sequence;
  std::vector<Point2> first;
  for (unsigned i = in.take<std::uint8_t>() % 24; i > 0; --i) first.push_back(point_from(in, kind));
  if (!first.empty()) sequence.insert(first);
  for (int steps = 0; steps < 80 && !in.empty(); ++steps) {
    const auto action = in.take<std::uint8_t>();
    const MaybeId<VertexId> hint = sequence.hint(in.take<std::uint8_t>());
    if (action % 8 < 4)
      sequence.insert(point_from(in, kind), hint);
    else if (action % 8 < 6)
      sequence.remove(action / 8);
    else if (action % 8 < 7)
      sequence.move(action / 8, point_from(in, kind));
    else
      sequence.ask(point_from(in, kind), hint);
  }
  sequence.check_from_scratch();
  return 0;
}
