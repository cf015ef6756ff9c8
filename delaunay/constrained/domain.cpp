// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "leonhard/delaunay/constrained/carve.hpp"
#include "leonhard/delaunay/constrained/constrain.hpp"
#include "leonhard/delaunay/order/sorted_triangulation.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// The input's segment of which a segment of the graph that was triangulated is a part.
SegmentId input_segment(const Domain& domain, SegmentId s) {
  return domain.arrangement ? domain.arrangement->segment_of[s.index()] : s;
}

void note_overlaps(const std::vector<OverlapNote>& met, Domain& domain) {
  std::vector<OverlapNote> overlaps;
  for (const OverlapNote& note : met) {
    const std::size_t segment = input_segment(domain, SegmentId::from(note.segment)).index();
    const std::size_t earlier = input_segment(domain, SegmentId::from(note.earlier)).index();
    if (overlaps.empty() || overlaps.back().segment != segment || overlaps.back().earlier != earlier) overlaps.push_back({segment, earlier});
  }
  std::vector<std::string>& repairs = domain.repairs;
  constexpr std::size_t named = 10;
  for (std::size_t i = 0; i < std::min(named, overlaps.size()); ++i)
    repairs.push_back("segment " + std::to_string(overlaps[i].segment) + " overlaps segment " +
                      std::to_string(overlaps[i].earlier) + ": merged where they do (counted from 0)");
  if (overlaps.size() > named)
    repairs.push_back(std::to_string(overlaps.size() - named) + " more overlapping segments merged");
}

/// One a vertex: whether it has a real triangle.
std::vector<bool> used_vertices(const ConstrainedTriangulation& cells) {
  std::vector<bool> used(cells.points().size(), false);
  const GhostTriangulation& topology = cells.topology();
  for (std::size_t i = 0; i < topology.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    if (topology.is_ghost(t)) continue;
    for (unsigned k = 0; k < 3; ++k) used[topology.corner(t, k).index()] = true;
  }
  return used;
}

void note_unused(const Pslg& pslg, const Domain& domain, std::vector<std::string>& repairs) {
  const std::vector<bool> used = used_vertices(domain.cells);
  std::size_t unused = 0, first = std::numeric_limits<std::size_t>::max();
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] || domain.sorted.first_input[v] >= pslg.points.size()) continue;
    ++unused;
    first = std::min<std::size_t>(first, domain.sorted.first_input[v]);
  }
  if (unused > 0)
    repairs.push_back(std::to_string(unused) +
                      " points lie outside the domain or in a hole and are not in the mesh, " +
                      "the first of them point " + std::to_string(first) + " at " +
                      mesh::words(pslg.points[first]) + " (counted from 0)");
}

/// One a vertex: its number in the mesh, or none.
std::vector<MaybeId<VertexId>> mesh_numbers(const Domain& domain) {
  const std::vector<bool> used = used_vertices(domain.cells);
  const std::vector<std::uint32_t>& first_input = domain.sorted.first_input;
  std::vector<MaybeId<VertexId>> vertex_at_input(domain.sorted.sorted_index.size());
  for (std::size_t v = 0; v < first_input.size(); ++v)
    if (used[v]) vertex_at_input[first_input[v]] = VertexId::from(v);
  std::vector<MaybeId<VertexId>> number(used.size());
  std::size_t count = 0;
  for (const MaybeId<VertexId> v : vertex_at_input)
    if (v) number[(*v).index()] = VertexId::from(count++);
  for (std::size_t v = first_input.size(); v < used.size(); ++v)
    if (used[v]) number[v] = VertexId::from(count++);
  return number;
}

void copy_triangles(const ConstrainedTriangulation& cells, const Pslg& pslg,
                    const std::vector<MaybeId<VertexId>>& number, TriangleMesh& mesh) {
  const GhostTriangulation& topology = cells.topology();
  PerId<AnyTriangleId, MaybeId<TriangleId>> new_of_old(topology.triangle_count());
  std::size_t count = 0;
  for (const AnyTriangleId t : new_of_old.ids())
    if (!topology.is_ghost(t)) new_of_old[t] = TriangleId::from(count++);
  mesh.corners.resize(count);
  mesh.neighbours.resize(count);
  mesh.regions.resize(count);
  for (const AnyTriangleId t : new_of_old.ids()) {
    if (!new_of_old[t]) continue;
    const TriangleId u = *new_of_old[t];
    for (unsigned k = 0; k < 3; ++k) {
      mesh.corners[u][k] = *number[topology.corner(t, k).index()];
      mesh.neighbours[u][k] = new_of_old[topology.triangle(topology.twin(topology.side(t, k)))];
    }
    if (!cells.region_of().empty() && cells.region_of()[t.index()] != 0)
      mesh.regions[u] = pslg.regions[cells.region_of()[t.index()] - 1].attribute;
  }
}

/// Boundary and constraints in the order of the pieces. Vertices added on a segment take its marker.
void copy_edges(const Domain& domain, const std::vector<MaybeId<VertexId>>& number, TriangleMesh& mesh,
                InputSegments& segments) {
  const GhostTriangulation& topology = domain.cells.topology();
  const auto is_ghost = [&](SideId s) { return topology.is_ghost(topology.triangle(s)); };
  for (const Piece& piece : domain.cells.pieces()) {
    SideId s = piece.side;
    if (is_ghost(s)) s = topology.twin(s);
    const VertexId from = topology.origin(s), to = topology.destination(s);
    const MarkedEdge edge{*number[from.index()], *number[to.index()], piece.marker};
    const bool on_boundary = is_ghost(topology.twin(s));
    (on_boundary ? mesh.boundary : mesh.constraints).push_back(edge);
    MaybeId<SegmentId> segment = piece.segment;
    if (segment) segment = input_segment(domain, *segment);
    (on_boundary ? segments.boundary : segments.constraints).push_back(segment);
    for (const VertexId v : {from, to})
      if (v.index() >= domain.sorted.first_input.size())
        mesh.vertex_markers[*number[v.index()]] = piece.marker;
  }
}

}  // namespace

void check(const Pslg& pslg) {
  const std::size_t n = pslg.points.size();
  const auto check_point = [&](const char* what, std::size_t i, Point2 p) {
    if (!is_finite(p))
      throw InputError(pslg.source,
                       std::string(what) + " " + std::to_string(i) + " has the coordinates " + mesh::words(p),
                       "give finite numbers (counted from 0)");
  };
  const auto check_region = [&](std::size_t i) {
    const Pslg::Region& region = pslg.regions[i];
    check_point("region", i, region.seed);
    if (std::isnan(region.attribute) || std::isnan(region.max_area))
      throw InputError(pslg.source,
                       "region " + std::to_string(i) + " at " + mesh::words(region.seed) +
                           " has the attribute " + mesh::words(region.attribute) + " and the largest area " +
                           mesh::words(region.max_area),
                       "give numbers (regions counted from 0), a negative area for no bound");
  };
  if (n > std::numeric_limits<std::uint32_t>::max() / 8)
    throw InputError(pslg.source, std::to_string(n) + " points are too many", "give at most 536870911");
  for (std::size_t i = 0; i < n; ++i) check_point("point", i, pslg.points[i]);
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) check_point("hole", i, pslg.holes[i]);
  for (std::size_t i = 0; i < pslg.regions.size(); ++i) check_region(i);
  if (!pslg.point_markers.empty() && pslg.point_markers.size() != n)
    throw InputError(
        pslg.source,
        std::to_string(pslg.point_markers.size()) + " point markers for " + std::to_string(n) + " points",
        "give one a point or none");
  for (std::size_t i = 0; i < pslg.segments.size(); ++i)
    for (const std::size_t end : {pslg.segments[i].from, pslg.segments[i].to})
      if (end >= n)
        throw InputError(pslg.source,
                         "segment " + std::to_string(i) + " ends in point " + std::to_string(end) +
                             ", there are " + std::to_string(n) + " points",
                         "correct the segment (both counted from 0)");
}

void note_duplicates(const Pslg& pslg, const SortedPoints& sorted, std::vector<std::string>& repairs) {
  const std::size_t merged = pslg.points.size() - sorted.first_input.size();
  if (merged > 0) {
    std::size_t first_merged = 0;
    while (sorted.first_input[sorted.sorted_index[first_merged]] == first_merged) ++first_merged;
    repairs.push_back(
        std::to_string(merged) + " points merged with others at the same place, the first of them point " +
        std::to_string(first_merged) + " with point " + std::to_string(sorted.first_input[sorted.sorted_index[first_merged]]) +
        " at " + mesh::words(pslg.points[first_merged]) + " (counted from 0)");
  }
  std::size_t empty = 0, first = 0;
  for (std::size_t i = pslg.segments.size(); i-- > 0;) {
    const Pslg::Segment& s = pslg.segments[i];
    if (sorted.sorted_index[s.from] != sorted.sorted_index[s.to]) continue;
    ++empty;
    first = i;
  }
  if (empty > 0)
    repairs.push_back(std::to_string(empty) + " segments of no length left out, the first of them segment " +
                      std::to_string(first) + " (counted from 0)");
}

void set_point_markers(const Pslg& pslg, const std::vector<MaybeId<VertexId>>& vertex_of_input,
                       TriangleMesh& mesh) {
  for (std::size_t i = pslg.point_markers.size(); i-- > 0;)
    if (vertex_of_input[i] && pslg.point_markers[i] != 0)
      mesh.vertex_markers[*vertex_of_input[i]] = pslg.point_markers[i];
}

namespace {

/// Steps 1 and 2; the segments' ends are put into the triangulation, the segments not.
Domain triangulate_ends(const Pslg& graph, Algorithm algorithm, const AlgorithmOptions& options) {
  Domain domain;
  SortedTriangulation points_only = sort_and_triangulate(graph.points, algorithm, options);
  domain.outcome = points_only.cells.outcome;
  domain.sorted = std::move(points_only.sorted);
  if (domain.outcome == TriangulateOutcome::done)
    domain.cells = ConstrainedTriangulation(std::move(points_only.cells.triangulation), std::move(domain.sorted.points));
  return domain;
}

InsertedSegments insert_all(Domain& domain, const Pslg& graph, const Progress& progress) {
  std::vector<VertexId> vertex_of;
  vertex_of.reserve(graph.points.size());
  for (const std::uint32_t i : domain.sorted.sorted_index) vertex_of.push_back(VertexId{i});
  return insert_segments(domain.cells, graph, vertex_of, progress);
}

}  // namespace

Domain make_domain(const Pslg& pslg, bool keep_convex_hull, Crossings crossings, Algorithm algorithm,
                   const AlgorithmOptions& options) {
  // 1. check
  check(pslg);
  // 2. sort, merge, triangulate
  Domain domain = triangulate_ends(pslg, algorithm, options);
  if (domain.outcome != TriangulateOutcome::stopped) note_duplicates(pslg, domain.sorted, domain.repairs);
  if (domain.outcome != TriangulateOutcome::done) return domain;
  // 3. constrain and carve
  InsertedSegments inserted = insert_all(domain, pslg, options.progress);
  if (inserted.some_cross) {
    if (crossings == Crossings::reject) refuse_crossings(pslg, options.progress);
    Arrangement arrangement = crossings == Crossings::split ? split_crossings(pslg, options.progress)
                                                            : skip_crossings(pslg, options.progress);
    Domain again = triangulate_ends(arrangement.graph, algorithm, options);
    again.repairs = std::move(domain.repairs);
    domain = std::move(again);
    note_crossings(arrangement, domain.repairs);
    domain.arrangement = std::move(arrangement);
    if (domain.outcome == TriangulateOutcome::done) inserted = insert_all(domain, domain.arrangement->graph, options.progress);
    assert(!inserted.some_cross || options.progress.stop_requested());
  }
  note_overlaps(inserted.overlaps, domain);
  if (options.progress.stop_requested()) {
    domain.outcome = TriangulateOutcome::stopped;
    return domain;
  }
  domain.cells = carve(domain.cells, pslg, keep_convex_hull || pslg.segments.empty(), domain.repairs);
  note_unused(pslg, domain, domain.repairs);
  assert(!domain.cells.validate());
  return domain;
}

TriangleMesh to_mesh(const Domain& domain, const Pslg& pslg, std::vector<MaybeId<VertexId>>& vertex_of_input,
                     InputSegments& segments) {
  const ConstrainedTriangulation& cells = domain.cells;
  const Pslg& graph = domain.arrangement ? domain.arrangement->graph : pslg;
  const std::vector<MaybeId<VertexId>> number = mesh_numbers(domain);
  vertex_of_input.assign(graph.points.size(), {});
  for (std::size_t i = 0; i < graph.points.size(); ++i)
    vertex_of_input[i] = number[domain.sorted.sorted_index[i]];

  TriangleMesh mesh;
  const auto count = static_cast<std::size_t>(
      std::count_if(number.begin(), number.end(), [](MaybeId<VertexId> v) { return v.has_value(); }));
  mesh.points.resize(count);
  mesh.vertex_markers.resize(count, 0);
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v]) mesh.points[*number[v]] = cells.points()[v];
  copy_triangles(cells, pslg, number, mesh);
  copy_edges(domain, number, mesh, segments);
  set_point_markers(graph, vertex_of_input, mesh);
  vertex_of_input.resize(pslg.points.size());
  mesh.marker_names = pslg.marker_names;
  return mesh;
}

}  // namespace leonhard::delaunay
