// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <utility>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/tet_algorithm.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// 7 tetrahedra a vertex where they fill space, ghosts and all.
constexpr std::size_t max_vertices = std::numeric_limits<IdRaw>::max() / 8;

void require_room(std::size_t vertices) {
  if (vertices > max_vertices)
    throw InputError("insert", std::to_string(vertices) + " vertices are too many",
                     "insert at most " + std::to_string(max_vertices) + ", or build with LEONHARD_64BIT_IDS");
}

void require_finite(std::span<const Point3> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InputError("insert",
                       "point " + std::to_string(i) + " has the coordinates " + mesh::words(points[i]),
                       "give finite numbers (counted from 0)");
}

}  // namespace

DynamicTetrahedralization::Inserted DynamicTetrahedralization::insert(const Point3& p,
                                                                      MaybeId<VertexId> hint) {
  Search search = search_for(p, hint);
  if (!has_tets()) return insert_flat(p);
  const TetId found = find(p, search);
  if (!cells_.is_ghost(found))
    for (const VertexId v : cells_.corners[found])
      if (points_[v] == p) return {v, false};
  return {insert_in_space(p, found), true};
}

VertexId DynamicTetrahedralization::new_vertex(const Point3& p) {
  if (!free_.empty()) {
    const VertexId v = free_.back();
    free_.pop_back();
    points_[v] = p;
    return v;
  }
  require_room(points_.size() + 1);
  tets_.push_back(TetId{});
  return points_.push_back(p);
}

void DynamicTetrahedralization::set_tets_of(TetId t) {
  for (const VertexId v : cells_.corners[t]) (v == ghost ? ghost_tet_ : tets_[v]) = t;
}

/// destroyed  a tetrahedron that p destroys
VertexId DynamicTetrahedralization::insert_in_space(const Point3& p, TetId destroyed) {
  const VertexId v = new_vertex(p);
  cavity_.insert(cells_, points_.flat(), v, destroyed, spare_);
  for (const TetId t : cavity_.made()) set_tets_of(t);
  last_ = v;
  return v;
}

DynamicTetrahedralization::Inserted DynamicTetrahedralization::insert_flat(const Point3& p) {
  if (const MaybeId<VertexId> there = flat_.find(p)) return {*there, false};
  const bool leaves_plane = extent() == Extent::plane && !flat_.spans(p);
  const VertexId v = new_vertex(p);
  if (leaves_plane)
    build(1);
  else
    flat_.insert(p, v);
  return {v, true};
}

/// Tetrahedra between all vertices if they span space, else all of them into flat_.
void DynamicTetrahedralization::build(unsigned threads) {
  flat_.clear();
  std::vector<VertexId> ids, sorted_ids;
  std::vector<Point3> points, sorted;
  for (const VertexId v : vertices()) {
    ids.push_back(v);
    points.push_back(points_[v]);
  }
  for (const std::uint32_t i : kernel::hilbert_order(points)) {
    sorted_ids.push_back(ids[i]);
    sorted.push_back(points[i]);
  }
  TetAlgorithmOptions options;
  options.threads = threads;
  PointTetrahedralization made = tetrahedralize_distinct(sorted, TetAlgorithm::insertion, options);
  if (made.outcome != TetrahedralizeOutcome::done) {
    for (const VertexId v : ids) flat_.insert(points_[v], v);
    return;
  }
  cells_ = std::move(made.cells);
  spare_.clear();
  for (const TetId t : cells_.corners.ids()) {
    for (VertexId& v : cells_.corners[t])
      if (v != ghost) v = sorted_ids[v.index()];
    set_tets_of(t);
  }
  last_ = ids.front();
}

std::vector<VertexId> DynamicTetrahedralization::insert(std::span<const Point3> points, unsigned threads) {
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

void DynamicTetrahedralization::insert_first(std::span<const Point3> points, std::vector<VertexId>& vertex_of,
                                             unsigned threads) {
  std::vector<std::size_t> first_there(
      points.size());  // equal points are neighbours in the order, the first one first
  const std::vector<std::uint32_t> order = kernel::hilbert_order(points);
  for (std::size_t k = 0; k < order.size(); ++k)
    first_there[order[k]] =
        k > 0 && points[order[k]] == points[order[k - 1]] ? first_there[order[k - 1]] : order[k];
  clear();
  for (std::size_t i = 0; i < points.size(); ++i)
    vertex_of[i] = first_there[i] == i ? new_vertex(points[i]) : vertex_of[first_there[i]];
  build(threads);
}

}  // namespace leonhard::delaunay
