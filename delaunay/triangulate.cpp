// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/triangulate.hpp"

#include <cassert>
#include <utility>

#include "leonhard/delaunay/domain.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::delaunay {
namespace {

TriangulateOutcome outcome_of(IncrementalResult::Outcome outcome) {
  switch (outcome) {
    case IncrementalResult::Outcome::done:
      return TriangulateOutcome::done;
    case IncrementalResult::Outcome::too_few_points:
      return TriangulateOutcome::too_few_points;
    case IncrementalResult::Outcome::all_collinear:
      return TriangulateOutcome::all_collinear;
    case IncrementalResult::Outcome::stopped:
      break;
  }
  return TriangulateOutcome::stopped;
}

}  // namespace

Triangulation triangulate(const Pslg& pslg, const TriangulateOptions& options) {
  Domain domain = make_domain(pslg, options.keep_convex_hull, options.progress);
  Triangulation result;
  result.outcome = outcome_of(domain.outcome);
  result.vertex_of_input.resize(pslg.points.size());
  result.repairs = std::move(domain.repairs);
  if (result.outcome != TriangulateOutcome::done) return result;
  result.mesh = to_mesh(domain, pslg, result.vertex_of_input);
  assert(!mesh::validate(result.mesh) && !mesh::validate_delaunay(result.mesh));
  options.progress("triangulate", 1);
  return result;
}

Triangulation triangulate(std::vector<Point2> points, const TriangulateOptions& options) {
  Pslg pslg;
  pslg.points = std::move(points);
  pslg.source = "points";
  return triangulate(pslg, options);
}

}  // namespace leonhard::delaunay
