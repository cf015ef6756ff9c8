// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/triangulate.hpp"

#include <cassert>
#include <utility>

#include "leonhard/delaunay/constrained/domain.hpp"
#include "leonhard/delaunay/order/sorted_triangulation.hpp"
#include "leonhard/delaunay/plane/point_mesh.hpp"
#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::delaunay {
namespace {

AlgorithmOptions algorithm_options(const TriangulateOptions& options) {
  return {options.seed, options.threads, options.progress};
}

/// A graph of points alone, which become the mesh's.
Triangulation triangulate_points(Pslg pslg, const TriangulateOptions& options) {
  check(pslg);
  Triangulation result;
  SortedTriangulation made = sort_and_triangulate(pslg.points, options.algorithm, algorithm_options(options));
  result.outcome = made.cells.outcome;
  if (result.outcome != TriangulateOutcome::stopped) note_duplicates(pslg, made.sorted, result.repairs);
  if (result.outcome != TriangulateOutcome::done) {
    result.vertex_of_input.resize(pslg.points.size());
    return result;
  }
  release(made.sorted.points);
  PointMesh mesh = to_mesh(std::move(made.cells.triangulation), std::move(made.sorted),
                           std::move(pslg.points), options.threads);
  result.mesh = std::move(mesh.mesh);
  result.vertex_of_input = std::move(mesh.vertex_of_input);
  set_point_markers(pslg, result.vertex_of_input, result.mesh);
  result.mesh.marker_names = std::move(pslg.marker_names);
  result.segments.boundary.resize(result.mesh.boundary.size());
  return result;
}

Triangulation triangulate_graph(const Pslg& pslg, const TriangulateOptions& options) {
  Domain domain = make_domain(pslg, options.keep_convex_hull, options.crossings, options.algorithm, algorithm_options(options));
  Triangulation result;
  result.outcome = domain.outcome;
  result.vertex_of_input.resize(pslg.points.size());
  result.repairs = std::move(domain.repairs);
  if (domain.arrangement) result.crossings = domain.arrangement->crossings;
  if (result.outcome == TriangulateOutcome::done)
    result.mesh = to_mesh(domain, pslg, result.vertex_of_input, result.segments);
  return result;
}

}  // namespace

Triangulation triangulate(Pslg pslg, const TriangulateOptions& options) {
  const bool points_alone = pslg.segments.empty() && pslg.holes.empty() && pslg.regions.empty();
  Triangulation result =
      points_alone ? triangulate_points(std::move(pslg), options) : triangulate_graph(pslg, options);
  assert(!mesh::validate(result.mesh) && !mesh::validate_delaunay(result.mesh));
  if (result.outcome == TriangulateOutcome::done) options.progress("triangulate", 1);
  return result;
}

Triangulation triangulate(std::vector<Point2> points, const TriangulateOptions& options) {
  Pslg pslg;
  pslg.points = std::move(points);
  pslg.source = "points";
  return triangulate(std::move(pslg), options);
}

}  // namespace leonhard::delaunay
