// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/refine.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "leonhard/delaunay/constrained/domain.hpp"
#include "leonhard/delaunay/constrained/refiner.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

void check_options(const RefineOptions& options) {
  if (!(options.min_angle_deg >= 0 && options.min_angle_deg <= 40))
    throw InputError("RefineOptions::min_angle_deg", "is " + mesh::words(options.min_angle_deg),
                     "give 0 to 40 degrees; up to 33 can be met as a rule");
  if (!(options.min_edge >= 0) || !std::isfinite(options.min_edge))
    throw InputError("RefineOptions::min_edge", "is " + mesh::words(options.min_edge), "give 0 or a length");
  if (std::isnan(options.max_area))
    throw InputError("RefineOptions::max_area", "is not a number", "give an area, or -1 for no bound");
}

/// Lengths are squared and multiplied in the quality bounds.
void check_range(const Pslg& pslg) {
  constexpr double largest = 1e70, smallest = 1e-70;
  if (pslg.points.empty()) return;
  double low_x = pslg.points[0].x, low_y = pslg.points[0].y, high_x = low_x, high_y = low_y, far = 0;
  for (const Point2 p : pslg.points) {
    low_x = std::min(low_x, p.x);
    low_y = std::min(low_y, p.y);
    high_x = std::max(high_x, p.x);
    high_y = std::max(high_y, p.y);
    far = std::max({far, std::abs(p.x), std::abs(p.y)});
  }
  if (far > largest || std::max(high_x - low_x, high_y - low_y) < smallest)
    throw InputError(
        pslg.source,
        "the points span " + mesh::words(Point2{low_x, low_y}) + " to " + mesh::words(Point2{high_x, high_y}),
        "scale them: refinement works between 1e-70 and 1e70");
}

void refuse(const Pslg& pslg, TriangulateOutcome outcome) {
  if (outcome == TriangulateOutcome::too_few_points)
    throw InputError(pslg.source, "fewer than three distinct points",
                     "give an outline that encloses an area");
  if (outcome == TriangulateOutcome::all_collinear)
    throw InputError(pslg.source, "all points lie on one line", "give an outline that encloses an area");
}

}  // namespace

RefinedMesh mesh_pslg(const Pslg& pslg, const RefineOptions& options) {
  check_options(options);
  RefinedMesh result;
  Domain domain =
      make_domain(pslg, options.keep_convex_hull, options.crossings, Algorithm::fast, {.progress = options.progress});
  if (domain.arrangement) result.crossings = domain.arrangement->crossings;
  refuse(pslg, domain.outcome);
  check_range(pslg);
  result.report.repairs = std::move(domain.repairs);
  result.vertex_of_input.resize(pslg.points.size());
  if (domain.outcome == TriangulateOutcome::stopped) {
    result.report.outcome = RefineOutcome::stopped;
    return result;
  }
  std::vector<double> region_areas;
  for (const Pslg::Region& region : pslg.regions) region_areas.push_back(region.max_area);
  Refiner(domain.cells, options, std::move(region_areas)).run(result.report);
  assert(!domain.cells.validate());
  result.mesh = to_mesh(domain, pslg, result.vertex_of_input, result.segments);
  assert(!mesh::validate(result.mesh) && !mesh::validate_delaunay(result.mesh));
  options.progress("refine", 1);
  return result;
}

}  // namespace leonhard::delaunay
