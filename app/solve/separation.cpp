// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/separation.hpp"

#include <map>

namespace leonhard::app {
namespace {

using Friction = std::map<VertexId, solver::Axes<2>>;

/// Friction along the wall in the direction of the line at each of its points; none on a slip wall and at a corner.
std::vector<std::optional<double>> friction_along(const SurfaceLine& line, const Friction& friction) {
  const std::size_t count = line.points.size();
  std::vector<std::optional<double>> along(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = friction.find(line.points[i].vertex);
    if (found == friction.end()) continue;
    const bool starts = i == 0 && !line.closed, ends = i + 1 == count && !line.closed;
    const Point2 before = line.points[starts ? i : (i + count - 1) % count].at, here = line.points[i].at,
                 after = line.points[ends ? i : (i + 1) % count].at;
    if (!starts && !ends && dot(here - before, after - here) <= 0) continue;
    const Vec2 way = after - before;
    along[i] = found->second[0] * way.x + found->second[1] * way.y;
  }
  return along;
}

}  // namespace

std::vector<FrictionZero> friction_zeros(const SteadyResult<2>& flow) {
  Friction friction;
  for (const auto& stress : flow.stresses) friction[stress.at.vertex] = stress.friction;
  std::vector<FrictionZero> zeros;
  for (const SurfaceLine& line : flow.surface) {
    const auto along = friction_along(line, friction);
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
      const std::size_t next = (i + 1) % count;
      if (!along[i] || !along[next] || (*along[i] > 0) == (*along[next] > 0)) continue;
      const double share = *along[i] / (*along[i] - *along[next]);
      const Vec2 edge = line.points[next].at - line.points[i].at;
      zeros.push_back({*along[i] > 0 ? FrictionZero::Kind::separation : FrictionZero::Kind::attachment, line.marker,
                       line.points[i].at + share * edge, line.points[i].arc_length + share * norm(edge)});
    }
  }
  return zeros;
}

}  // namespace leonhard::app
