// SPDX-License-Identifier: MIT
// Planar straight-line graphs from bytes, on small integer grids (many ties, overlaps and crossings) or from raw
// doubles: triangulate, constrain and refine with a small budget, and check every answer with the public
// validators. A graph may be refused with an InputError; whatever is returned must be valid.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/delaunay/refine.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;

/// Whether two segments have a point in the interior of both that is a vertex of neither.
bool cross(const Pslg& pslg, const Pslg::Segment& s, const Pslg::Segment& t) {
  const auto side = [&](const Pslg::Segment& of, std::size_t i) {
    return kernel::orient2d(pslg.points[of.from], pslg.points[of.to], pslg.points[i]);
  };
  return side(s, t.from) * side(s, t.to) == Sign::negative &&
         side(t, s.from) * side(t, s.to) == Sign::negative;
}

/// Some graphs keep crossing segments, to be refused or mended; from others they are left out.
Pslg graph_from(fuzzing::Input& in) {
  Pslg pslg;
  const unsigned kind =
      in.take<std::uint8_t>() % 4;  // 0 and 1: points of fuzzing::Input; 2 and 3: a small grid
  const unsigned grid = 2 + in.take<std::uint8_t>() % 14;
  const std::size_t points = 3 + in.take<std::uint8_t>() % 40, segments = in.take<std::uint8_t>() % 64;
  const unsigned seeds = in.take<std::uint8_t>() % 8;
  const bool crossing = in.take<std::uint8_t>() % 4 == 0;
  const auto byte_below = [&](std::size_t bound) { return in.take<std::uint8_t>() % bound; };
  const auto grid_point = [&] {
    const double x = static_cast<double>(byte_below(grid));
    return Point2{x, static_cast<double>(byte_below(grid))};
  };
  for (std::size_t i = 0; i < points; ++i)
    pslg.points.push_back(kind < 2 ? in.point(2 * kind) : grid_point());
  for (std::size_t i = 0; i < segments; ++i) {
    const Pslg::Segment s{byte_below(points), byte_below(points), static_cast<Marker>(i % 3)};
    const bool crosses = std::any_of(pslg.segments.begin(), pslg.segments.end(),
                                     [&](const Pslg::Segment& t) { return cross(pslg, s, t); });
    if (crossing || !crosses) pslg.segments.push_back(s);
  }
  if ((seeds & 1) != 0) pslg.holes.push_back(grid_point() + Vec2{0.25, 0.125});
  if ((seeds & 2) != 0) pslg.regions.push_back({grid_point() + Vec2{0.5, 0.125}, 1.0, 0.25});
  if ((seeds & 4) != 0) pslg.regions.push_back({grid_point(), 2.0, -1.0});
  return pslg;
}

void print(const Pslg& pslg) {
  std::fprintf(stderr, "Pslg pslg;\npslg.points = {");
  for (const Point2 p : pslg.points) std::fprintf(stderr, "{%a, %a}, ", p.x, p.y);
  std::fprintf(stderr, "};\npslg.segments = {");
  for (const Pslg::Segment& s : pslg.segments)
    std::fprintf(stderr, "{%zu, %zu, %d}, ", s.from, s.to, s.marker);
  std::fprintf(stderr, "};\npslg.holes = {");
  for (const Point2 p : pslg.holes) std::fprintf(stderr, "{%a, %a}, ", p.x, p.y);
  std::fprintf(stderr, "};\npslg.regions = {");
  for (const Pslg::Region& r : pslg.regions)
    std::fprintf(stderr, "{{%a, %a}, %g, %g}, ", r.seed.x, r.seed.y, r.attribute, r.max_area);
  std::fprintf(stderr, "};\n");
}

void require(bool holds, const Pslg& pslg, const std::string& words) {
  if (holds) return;
  print(pslg);
  std::fprintf(stderr, "// %s\n", words.c_str());
  std::abort();
}

void check(const TriangleMesh& mesh, const Pslg& pslg) {
  for (const std::optional<std::string>& broken :
       {mesh::validate(mesh), mesh::validate_embedding(mesh), mesh::validate_delaunay(mesh)})
    require(!broken, pslg, broken.value_or(""));
}

Pslg reversed(Pslg pslg) {
  std::reverse(pslg.points.begin(), pslg.points.end());
  for (Pslg::Segment& s : pslg.segments)
    s = {pslg.points.size() - 1 - s.from, pslg.points.size() - 1 - s.to, s.marker};
  std::reverse(pslg.segments.begin(), pslg.segments.end());
  return pslg;
}

/// Whether the pieces of each segment add up to its length, as far as rounding tells, where segments share none and nothing is
/// carved away.
bool has_all_segments(const delaunay::Triangulation& result, const Pslg& pslg) {
  std::vector<double> length(pslg.segments.size(), 0.0);
  const auto add = [&](const std::vector<MarkedEdge>& edges, const std::vector<MaybeId<delaunay::SegmentId>>& segments) {
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (segments[i]) length[(*segments[i]).index()] += distance(result.mesh.points[edges[i].from], result.mesh.points[edges[i].to]);
  };
  add(result.mesh.boundary, result.segments.boundary);
  add(result.mesh.constraints, result.segments.constraints);
  for (std::size_t i = 0; i < length.size(); ++i) {
    const double whole = distance(pslg.points[pslg.segments[i].from], pslg.points[pslg.segments[i].to]);
    if (std::abs(length[i] - whole) > 1e-9 * (1 + whole)) return false;
  }
  return true;
}

bool notes_overlaps(const delaunay::Triangulation& result) {
  return std::ranges::any_of(result.repairs, [](const std::string& words) { return words.find("overlap") != std::string::npos; });
}

bool is_on_small_grid(const Pslg& pslg) {
  return std::ranges::all_of(pslg.points, [](Point2 p) { return std::abs(p.x) <= 64 && std::abs(p.y) <= 64; });
}

void check_triangulation(const Pslg& pslg, const delaunay::TriangulateOptions& options) {
  const delaunay::Triangulation one = delaunay::triangulate(pslg, options);
  check(one.mesh, pslg);
  if (options.crossings == delaunay::Crossings::split && options.keep_convex_hull && pslg.holes.empty() && is_on_small_grid(pslg) &&
      one.outcome == delaunay::TriangulateOutcome::done && !notes_overlaps(one))
    require(has_all_segments(one, pslg), pslg, "a segment is not in the mesh");
  if (options.crossings == delaunay::Crossings::skip) return;  // which are left out depends on their order
  const delaunay::Triangulation other = delaunay::triangulate(reversed(pslg), options);
  require(one.outcome == other.outcome && mesh::fingerprint(one.mesh) == mesh::fingerprint(other.mesh), pslg,
          "the reversed graph has another triangulation");
}

void check_refinement(const Pslg& pslg, double min_angle_deg, const delaunay::TriangulateOptions& as) {
  delaunay::RefineOptions options;
  options.min_angle_deg = min_angle_deg;
  options.max_vertices = 400;
  options.keep_convex_hull = as.keep_convex_hull;
  options.crossings = as.crossings;
  const delaunay::RefinedMesh one = delaunay::mesh_pslg(pslg, options);
  check(one.mesh, pslg);
  const delaunay::RefineReport& report = one.report;
  require(report.outcome != delaunay::RefineOutcome::achieved || report.below_angle + report.above_size == 0,
          pslg, "achieved, yet bounds are unmet");
  if (as.crossings == delaunay::Crossings::skip) return;
  const delaunay::RefinedMesh other = delaunay::mesh_pslg(reversed(pslg), options);
  require(mesh::fingerprint(one.mesh) == mesh::fingerprint(other.mesh), pslg,
          "the reversed graph has another mesh");
  const delaunay::Triangulation coarse = delaunay::triangulate(pslg, as);
  require(report.rounded_splits > 0 || mesh::exact_area2(coarse.mesh) == mesh::exact_area2(one.mesh), pslg,
          "refinement changed the area");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input in(data, size);
  const unsigned ways = in.take<std::uint8_t>();
  delaunay::TriangulateOptions options;
  options.keep_convex_hull = ways % 2 == 1;
  options.crossings = delaunay::named_crossings[ways / 2 % delaunay::named_crossings.size()].second;
  const double min_angle_deg = in.take<std::uint8_t>() % 36;
  const Pslg pslg = graph_from(in);
  try {
    check_triangulation(pslg, options);
  } catch (const InputError&) {
    return 0;
  }
  try {
    check_refinement(pslg, min_angle_deg, options);
  } catch (const InputError&) {
  }
  return 0;
}
