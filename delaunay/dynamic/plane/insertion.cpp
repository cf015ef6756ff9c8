// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <optional>

#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/order/cut_order.hpp"
#include "leonhard/delaunay/plane/fast.hpp"
#include "leonhard/delaunay/topology/conflict.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// A side has number 4 t + i, and there are 2 triangles a vertex.
constexpr std::size_t max_vertices = std::numeric_limits<IdRaw>::max() / 8;

void require_room(std::size_t vertices) {
  if (vertices > max_vertices)
    throw InputError("insert", std::to_string(vertices) + " vertices are too many",
                     "insert at most " + std::to_string(max_vertices) + ", or build with LEONHARD_64BIT_IDS");
}

void require_finite(std::span<const Point2> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InputError("insert",
                       "point " + std::to_string(i) + " has the coordinates " + mesh::words(points[i]),
                       "give finite numbers (counted from 0)");
}

}  // namespace

DynamicTriangulation::Inserted DynamicTriangulation::insert(Point2 p, MaybeId<VertexId> hint) {
  Search search = search_for(p, hint);
  if (extent() != Extent::plane) return insert_on_line(p);
  const Location found = find(p, search);
  if (found.kind == Location::Kind::on_vertex) return {triangles_.origin(found.side), false};
  return {insert_in_plane(p, triangles_.triangle(found.side)), true};
}

VertexId DynamicTriangulation::new_vertex(Point2 p) {
  if (!free_.empty()) {
    const VertexId v = free_.back();
    free_.pop_back();
    points_[v] = p;
    return v;
  }
  require_room(points_.size() + 1);
  sides_.push_back(SideId{});
  return points_.push_back(p);
}

void DynamicTriangulation::set_side(VertexId v, SideId side) {
  (v == GhostTriangulation::ghost ? ghost_side_ : sides_[v]) = side;
}

void DynamicTriangulation::set_sides_of(AnyTriangleId t) {
  for (unsigned i = 0; i < 3; ++i) {
    const SideId side = triangles_.side(t, i);
    set_side(triangles_.origin(side), side);
  }
}

/// destroyed  a triangle that p destroys
VertexId DynamicTriangulation::insert_in_plane(Point2 p, AnyTriangleId destroyed) {
  const VertexId v = new_vertex(p);
  cavity_.start(triangles_, destroyed);
  cavity_.grow(triangles_, [&](SideId inner) {
    return in_conflict(triangles_, points_.flat(), triangles_.triangle(triangles_.twin(inner)), p);
  });
  cavity_.fill(triangles_, v);
  for (const Cavity::Border& b : cavity_.border()) set_side(b.from, b.inner);
  set_side(v, triangles_.previous(cavity_.border().front().inner));
  last_ = v;
  return v;
}

DynamicTriangulation::Inserted DynamicTriangulation::insert_on_line(Point2 p) {
  if (const MaybeId<VertexId> there = line_.find(p)) return {*there, false};
  const VertexId v = new_vertex(p);
  if (line_.collinear_with(p))
    line_.insert(p, v);
  else
    fan_over_line(v);
  return {v, true};
}

/// The first point off the line makes a triangle with every piece of it.
void DynamicTriangulation::fan_over_line(VertexId v) {
  std::vector<VertexId> line;  // v to its left
  for (const auto& [point, vertex] : line_) line.push_back(vertex);
  if (kernel::orient2d(line_.first(), line_.last(), points_[v]) == Sign::negative)
    std::reverse(line.begin(), line.end());
  line_.clear();

  std::vector<SideId> hull_sides;
  SideId open{};  // the side of the last triangle that awaits its twin
  for (std::size_t i = 1; i < line.size(); ++i) {
    const AnyTriangleId t = triangles_.add(v, line[i - 1], line[i]);
    hull_sides.push_back(triangles_.side(t, 0));
    if (i > 1) triangles_.link(triangles_.side(t, 2), open);
    open = triangles_.side(t, 1);
  }
  hull_sides.push_back(open);
  hull_sides.push_back(triangles_.side(AnyTriangleId{0}, 2));
  add_ghosts(hull_sides);
  for (std::size_t i = 0; i < triangles_.triangle_count(); ++i) set_sides_of(AnyTriangleId::from(i));
  last_ = v;
}

/// hull_sides  counter-clockwise, of real triangles
void DynamicTriangulation::add_ghosts(std::span<const SideId> hull_sides) {
  SideId last{};
  for (const SideId s : hull_sides) {
    const AnyTriangleId t =
        triangles_.add(GhostTriangulation::ghost, triangles_.destination(s), triangles_.origin(s));
    triangles_.link(triangles_.side(t, 0), s);
    if (s != hull_sides.front()) triangles_.link(triangles_.side(t, 1), last);
    last = triangles_.side(t, 2);
  }
  const SideId first = triangles_.twin(hull_sides.front());
  triangles_.link(triangles_.next(first), last);
}

std::vector<VertexId> DynamicTriangulation::insert(std::span<const Point2> points, unsigned threads) {
  require_room(size() + points.size());
  require_finite(points);
  std::vector<VertexId> vertex_of(points.size());
  if (empty()) {
    insert_first(points, vertex_of, threads);
    return vertex_of;
  }
  MaybeId<VertexId> last;
  for (const std::uint32_t i : kernel::hilbert_order(points)) {
    vertex_of[i] = insert(points[i], last).vertex;
    last = vertex_of[i];
  }
  return vertex_of;
}

void DynamicTriangulation::insert_first(std::span<const Point2> points, std::vector<VertexId>& vertex_of,
                                        unsigned threads) {
  AlgorithmOptions options;
  options.threads = threads;
  const std::optional<CutOrder> order =
      sort_by_cuts(points, threads, options.progress);  // none if stopped: never
  const SortedPoints& sorted = order->sorted;
  PointTriangulation bulk = triangulate_fast(*order, options);

  clear();
  std::vector<VertexId> id_of_sorted(sorted.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t at = sorted.sorted_index[i];
    if (sorted.first_input[at] == i) id_of_sorted[at] = new_vertex(points[i]);
    vertex_of[i] = id_of_sorted[at];
  }
  if (bulk.outcome != TriangulateOutcome::done) {
    for (const VertexId v : points_.ids()) line_.insert(points_[v], v);
    return;
  }
  triangles_ = std::move(bulk.triangulation);
  const auto id_of = [&](VertexId at) {
    return at == GhostTriangulation::ghost ? at : id_of_sorted[at.index()];
  };
  for (std::size_t i = 0; i < triangles_.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    triangles_.set_corners(t, id_of(triangles_.corner(t, 0)), id_of(triangles_.corner(t, 1)),
                           id_of(triangles_.corner(t, 2)));
    set_sides_of(t);
  }
  last_ = VertexId{0};
}

}  // namespace leonhard::delaunay
