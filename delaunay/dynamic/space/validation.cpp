// SPDX-License-Identifier: MIT
#include <algorithm>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

std::string vertex_words(std::span<const Point3> points, VertexId v) {
  if (v == ghost) return "the ghost";
  std::string text = "vertex " + std::to_string(v.raw);
  if (v.index() < points.size()) text += " at " + mesh::words(points[v.index()]);
  return text;
}

std::string tet_words(TetId t) { return "tetrahedron " + std::to_string(t.raw); }

}  // namespace

std::optional<std::string> DynamicTetrahedralization::validate() const {
  if (auto problem = broken_id()) return problem;
  if (auto problem = broken_span()) return problem;
  if (!has_tets()) return std::nullopt;
  if (auto problem = broken_topology()) return problem;
  if (auto problem = broken_star()) return problem;
  return broken_geometry();
}

/// The removed ids are those without coordinates, each once.
std::optional<std::string> DynamicTetrahedralization::broken_id() const {
  if (tets_.size() != points_.size()) return "there is not one tetrahedron a vertex id";
  std::vector<VertexId> removed = free_, without_place;
  std::sort(removed.begin(), removed.end());
  for (const VertexId v : points_.ids())
    if (!is_finite(points_[v])) without_place.push_back(v);
  if (removed != without_place) return "the removed ids are not those of vertices without coordinates";
  return std::nullopt;
}

std::optional<std::string> DynamicTetrahedralization::broken_span() const {
  if (flat_.size() != (has_tets() ? 0 : size()))
    return std::to_string(flat_.size()) + " of " + std::to_string(size()) + " vertices are kept as coplanar";
  std::vector<Point3> places;
  for (const auto& [place, v] : flat_) {
    places.push_back(place);
    if (!contains(v) || points_[v] != place)
      return vertex_words(points_.flat(), v) + " is kept as coplanar at " + mesh::words(place);
    if (!flat_.spans(place)) return vertex_words(points_.flat(), v) + " is not in the span of the others";
  }
  if (first_tetrahedron(places).extent != flat_.extent())
    return "the coplanar vertices span something else than is said";
  return std::nullopt;
}

std::optional<std::string> DynamicTetrahedralization::broken_topology() const {
  for (const TetId t : spare_)
    if (!cells_.corners.contains(t) || cells_.corners[t] != TetCorners{ghost, ghost, ghost, ghost})
      return tet_words(t) + " is not out of use";
  GhostTetrahedralization in_use = cells_;
  in_use.erase(spare_);
  if (auto problem = in_use.validate()) return problem;
  for (const TetCorners& corners : in_use.corners)
    for (const VertexId v : corners)
      if (v != ghost && !contains(v)) return "a tetrahedron has a removed vertex, " + std::to_string(v.raw);
  return std::nullopt;
}

/// Every vertex, the ghost too, has a tetrahedron of its own; the triangles opposite to it in those about it close to a
/// sphere; and together they have every corner of every tetrahedron.
std::optional<std::string> DynamicTetrahedralization::broken_star() const {
  std::size_t corners = 0;
  TetStar star;
  const auto broken = [&](VertexId v, TetId t) -> std::optional<std::string> {
    if (!cells_.corners.contains(t) || corner_index(cells_.corners[t], v) == 4 ||
        cells_.corners[t][1] == ghost)
      return vertex_words(points_.flat(), v) + " has another vertex's tetrahedron, " + std::to_string(t.raw);
    star.collect(cells_, t, v);
    corners += star.tets().size();
    if (2 * star.neighbours().size() != star.tets().size() + 4)
      return vertex_words(points_.flat(), v) + " has " + std::to_string(star.neighbours().size()) +
             " neighbours and " + std::to_string(star.tets().size()) + " tetrahedra, which make no sphere";
    return std::nullopt;
  };
  for (const VertexId v : vertices())
    if (auto problem = broken(v, tets_[v])) return problem;
  if (auto problem = broken(ghost, ghost_tet_)) return problem;
  if (corners != 4 * (cells_.tet_count() - spare_.size())) return "a vertex has tetrahedra in two places";
  if (!contains(last_))
    return "the vertex that searches start from, " + std::to_string(last_.raw) + ", is removed";
  return std::nullopt;
}

std::optional<std::string> DynamicTetrahedralization::broken_geometry() const {
  const auto at = [&](VertexId v) -> const Point3& { return points_[v]; };
  for (const TetId t : cells_.corners.ids()) {
    const TetCorners& c = cells_.corners[t];
    if (!cells_.is_ghost(t) && kernel::orient3d(at(c[0]), at(c[1]), at(c[2]), at(c[3])) != Sign::positive)
      return tet_words(t) + " is not positive";
  }
  for (const TetId t : cells_.corners.ids()) {
    if (cells_.corners[t][1] == ghost) continue;  // out of use
    for (unsigned i = 0; i < 4; ++i) {
      const VertexId behind = cells_.corners[*cells_.neighbours[t][i]][mirror_index(cells_, t, i)];
      if (behind != ghost && in_conflict(cells_, points_.flat(), t, points_[behind]))
        return vertex_words(points_.flat(), behind) + " is in the sphere of " + tet_words(t) + " next to it";
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::delaunay
