// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/mesh_domain.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "leonhard/app/console.hpp"
#include "leonhard/delaunay/sizing.hpp"

namespace leonhard::app {
namespace {

std::function<double(Point2)> sizing_of(const DomainGeometry& domain) {
  if (domain.sources.empty()) {
    if (domain.max_size > 0 && std::isfinite(domain.max_size))
      return [size = domain.max_size](Point2) { return size; };
    return {};
  }
  std::vector<delaunay::GradedSizing::Source> sources;
  sources.reserve(domain.sources.size());
  for (const SizeSource& source : domain.sources) sources.push_back({source.at, source.spacing});
  const double largest = domain.max_size > 0 ? domain.max_size : std::numeric_limits<double>::infinity();
  return delaunay::GradedSizing(std::move(sources), domain.growth, largest);
}

}  // namespace

delaunay::RefinedMesh mesh_domain(const DomainGeometry& domain, const MesherCase& mesher, double max_area,
                                  std::stop_token stop) {
  delaunay::RefineOptions options;
  options.min_angle_deg = mesher.min_angle_deg;
  options.max_vertices = mesher.max_vertices;
  options.max_area = max_area;
  options.keep_convex_hull = domain.keep_convex_hull;
  options.crossings = mesher.crossings;
  options.size = sizing_of(domain);
  options.progress.stop = std::move(stop);
  return delaunay::mesh_pslg(domain.pslg, options);
}

std::vector<std::string> mesh_warnings(const delaunay::RefineReport& report, const MesherCase& mesher) {
  std::vector<std::string> warnings = report.repairs;
  if (report.outcome == delaunay::RefineOutcome::vertex_budget_spent) {
    warnings.push_back(
        fmt::format("the mesher stopped at its largest number of vertices, {}: {} triangles are still larger "
                    "than asked, {} have a smaller angle",
                    grouped(mesher.max_vertices), grouped(report.above_size), grouped(report.below_angle)));
  }
  return warnings;
}

}  // namespace leonhard::app
