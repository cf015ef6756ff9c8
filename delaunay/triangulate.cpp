// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/triangulate.hpp"

#include <cassert>
#include <utility>

#include "leonhard/delaunay/domain.hpp"
#include "leonhard/mesh/validate.hpp"

namespace leonhard::delaunay {

Triangulation triangulate(const Pslg& pslg, const TriangulateOptions& options) {
  Domain domain = make_domain(pslg, options.keep_convex_hull, options.algorithm,
                              {options.seed, options.threads, options.progress});
  Triangulation result;
  result.outcome = domain.outcome;
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
