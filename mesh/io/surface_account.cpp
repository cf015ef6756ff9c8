// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/surface_account.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/box_tree.hpp"
#include "leonhard/mesh/check/triangle_contact.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/io/soup/places.hpp"

namespace leonhard::io {
namespace {

using SurfaceTriangle = std::array<Point3, 3>;

/// A polygon's side by its smaller and larger vertex.
struct SurfaceSide {
  std::array<VertexId, 2> ends;
  bool turned;  ///< runs from the larger to the smaller
  std::size_t polygon;
};

Vec3 twice_area(const SurfaceTriangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Without area: exact, in the three coordinate planes.
bool is_flat(const SurfaceTriangle& t) {
  const auto collinear = [&](auto project) {
    return kernel::orient2d(project(t[0]), project(t[1]), project(t[2])) == Sign::zero;
  };
  return collinear([](const Point3& p) {
           return Point2{p.x, p.y};
         }) &&
         collinear([](const Point3& p) {
           return Point2{p.y, p.z};
         }) &&
         collinear([](const Point3& p) {
           return Point2{p.z, p.x};
         });
}

/// The triangles of all polygons, from their first corners.
std::vector<SurfaceTriangle> triangles_of(const SurfaceFile& surface) {
  std::vector<SurfaceTriangle> triangles;
  const auto at = [&](VertexId v) { return surface.set.points[v.index()]; };
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const auto corners = surface.polygon(i);
    for (std::size_t k = 2; k < corners.size(); ++k)
      triangles.push_back({at(corners[0]), at(corners[k - 1]), at(corners[k])});
  }
  return triangles;
}

bool is_degenerate(const SurfaceFile& surface, std::span<const VertexId> corners) {
  if (corners.size() < 3) return true;
  std::vector<VertexId> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return true;
  const auto at = [&](VertexId v) { return surface.set.points[v.index()]; };
  for (std::size_t k = 2; k < corners.size(); ++k)
    if (!is_flat({at(corners[0]), at(corners[k - 1]), at(corners[k])})) return false;
  return true;
}

void count_polygons(const SurfaceFile& surface, SurfaceAccount& account) {
  std::vector<bool> used(surface.set.points.size(), false);
  account.vertices = used.size();
  account.polygons = surface.polygon_count();
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const auto corners = surface.polygon(i);
    for (const VertexId v : corners) used[v.index()] = true;
    if (corners.size() == 3) ++account.triangles;
    if (corners.size() == 4) ++account.quadrilaterals;
    if (is_degenerate(surface, corners)) ++account.degenerate;
  }
  account.unused_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  const PerId<VertexId, Point3> points(surface.set.points);
  const auto first = first_at_equal_places(points);
  for (const VertexId v : first.ids())
    if (first[v] != v) ++account.repeated_places;
}

void count_edges(const SurfaceFile& surface, SurfaceAccount& account) {
  std::vector<SurfaceSide> sides;
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const auto corners = surface.polygon(i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexId a = corners[k], b = corners[k + 1 == corners.size() ? 0 : k + 1];
      if (a != b) sides.push_back({{std::min(a, b), std::max(a, b)}, b < a, i});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const SurfaceSide& a, const SurfaceSide& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.polygon < b.polygon;
  });
  mesh::DisjointSets joined(surface.polygon_count());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    for (end = begin + 1; end < sides.size() && sides[end].ends == sides[begin].ends; ++end)
      joined.join(sides[begin].polygon, sides[end].polygon);
    ++account.edges;
    if (end - begin == 1) ++account.open_edges;
    if (end - begin > 2) ++account.crowded_edges;
    if (end - begin == 2 && sides[begin].turned == sides[begin + 1].turned) ++account.unlike_edges;
  }
  for (std::size_t i = 0; i < surface.polygon_count(); ++i)
    if (joined.find(i) == i) ++account.components;
}

void count_contacts(std::vector<SurfaceTriangle> triangles, SurfaceAccount& account) {
  std::erase_if(triangles, is_flat);
  std::vector<Point3> centres;
  for (const SurfaceTriangle& t : triangles)
    centres.push_back({t[0].x / 3 + t[1].x / 3 + t[2].x / 3, t[0].y / 3 + t[1].y / 3 + t[2].y / 3,
                       t[0].z / 3 + t[1].z / 3 + t[2].z / 3});
  std::vector<SurfaceTriangle> ordered;
  std::vector<mesh::Box3> boxes;
  for (const std::size_t i : kernel::hilbert_order(centres)) {
    ordered.push_back(triangles[i]);
    boxes.emplace_back();
    for (const Point3& p : triangles[i]) boxes.back().include(p);
  }
  mesh::BoxTree<Point3>(boxes).for_each_meeting_pair_until([&](std::size_t i, std::size_t j) {
    if (mesh::in_contact(ordered[i], ordered[j])) ++account.contacts;
    return false;
  });
}

}  // namespace

SurfaceAccount surface_account(const SurfaceFile& surface) {
  SurfaceAccount account;
  count_polygons(surface, account);
  count_edges(surface, account);
  const std::vector<SurfaceTriangle> triangles = triangles_of(surface);
  const Point3 origin = surface.set.points.front();  // differences keep their digits far from the origin
  for (const SurfaceTriangle& t : triangles) {
    account.area += norm(twice_area(t)) / 2;
    account.volume += dot(t[0] - origin, cross(t[1] - origin, t[2] - origin)) / 6;
  }
  count_contacts(triangles, account);
  return account;
}

void weld(SurfaceFile& surface, double tolerance) {
  const PerId<VertexId, Point3> points(surface.set.points);
  const auto stands_for = weld_places(points, tolerance);
  std::vector<VertexId> new_id(stands_for.size());
  std::vector<Point3> kept;
  std::vector<Marker> markers;
  for (const VertexId v : stands_for.ids()) {
    if (stands_for[v] != v) continue;
    new_id[v.index()] = VertexId::from(kept.size());
    kept.push_back(points[v]);
    if (!surface.set.markers.empty()) markers.push_back(surface.set.markers[v.index()]);
  }
  const std::size_t joined = points.size() - kept.size();
  SurfaceFile welded;
  welded.warnings = std::move(surface.warnings);
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    std::vector<VertexId> corners;
    for (const VertexId v : surface.polygon(i)) {
      const VertexId id = new_id[stands_for[v].index()];
      if (corners.empty() || corners.back() != id) corners.push_back(id);
    }
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) continue;
    welded.corners.insert(welded.corners.end(), corners.begin(), corners.end());
    welded.offsets.push_back(welded.corners.size());
    if (!surface.markers.empty()) welded.markers.push_back(surface.markers[i]);
    if (!surface.facets.empty()) welded.facets.push_back(surface.facets[i]);
  }
  const std::size_t lost = surface.polygon_count() - welded.polygon_count();
  welded.set.points = std::move(kept);
  welded.set.markers = std::move(markers);
  if (joined > 0) welded.warnings.push_back(std::to_string(joined) + " vertices were joined with others");
  if (lost > 0)
    welded.warnings.push_back(std::to_string(lost) +
                              " polygons have fewer than three corners then, and went");
  surface = std::move(welded);
}

}  // namespace leonhard::io
