// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/hole_seeds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "leonhard/app/geometry/outline_checks.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

bool is_inside(const NamedOutline& outline, Point2 p) {
  return locate_in_polygon(outline.points, p) == PointPlace::inside;
}

/// Points of an outline's inside: first one in its middle, then some near its edges.
std::vector<Point2> candidates(const NamedOutline& outline) {
  std::vector<Point2> points{point_inside(outline)};
  const std::size_t n = outline.points.size();
  const double side = rounded_area2(outline.points) > 0 ? 1 : -1;
  for (int halving = 1; halving < 40; halving += 3)
    for (std::size_t i = 0; i < n; ++i) {
      const Point2 a = outline.points[i], b = outline.points[(i + 1) % n];
      const double inwards = side * std::ldexp(1.0, -halving);
      points.push_back({(a.x + b.x) / 2 - inwards * (b.y - a.y), (a.y + b.y) / 2 + inwards * (b.x - a.x)});
    }
  return points;
}

/// A point inside one outline and outside all those within it.
Point2 seed_of(const std::vector<NamedOutline>& outlines, std::size_t hole) {
  std::vector<const NamedOutline*> within;
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (i != hole && is_inside(outlines[hole], outlines[i].points[0])) within.push_back(&outlines[i]);
  for (const Point2 p : candidates(outlines[hole])) {
    const bool is_free = std::ranges::all_of(within, [&](const NamedOutline* inner) {
      return locate_in_polygon(inner->points, p) == PointPlace::outside;
    });
    if (is_free && is_inside(outlines[hole], p)) return p;
  }
  throw InputError(outlines[hole].where,
                   outlines[hole].name + " and what lies within it leave no room between them",
                   "move them apart, or give the geometry with seeds of its holes as .poly");
}

}  // namespace

std::optional<std::vector<std::vector<std::size_t>>> closed_outlines(std::span<const Pslg::Segment> segments,
                                                                     std::size_t points) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::array<std::size_t, 2>> neighbours(points, {none, none});
  const auto join = [&](std::size_t a, std::size_t b) {
    const auto place = std::ranges::find(neighbours[a], none);
    if (place == neighbours[a].end()) return false;
    *place = b;
    return true;
  };
  for (const Pslg::Segment& segment : segments)
    if (!join(segment.from, segment.to) || !join(segment.to, segment.from)) return std::nullopt;
  std::vector<char> seen(points, 0);
  std::vector<std::vector<std::size_t>> outlines;
  for (std::size_t start = 0; start < points; ++start) {
    if (seen[start] != 0 || neighbours[start][0] == none) continue;
    std::vector<std::size_t>& outline = outlines.emplace_back();
    for (std::size_t at = start, from = neighbours[start][1]; seen[at] == 0;) {
      if (neighbours[at][1] == none) return std::nullopt;
      seen[at] = 1;
      outline.push_back(at);
      from = std::exchange(at, neighbours[at][0] == from ? neighbours[at][1] : neighbours[at][0]);
    }
  }
  return outlines;
}

void find_holes(Pslg& pslg, std::size_t outline_segments, std::vector<std::string>& warnings) {
  const auto chains = closed_outlines(std::span(pslg.segments).first(outline_segments), pslg.points.size());
  if (!chains) {
    warnings.push_back(
        pslg.source +
        ": its edges are no separate closed outlines, so that holes could not be told; none was carved");
    return;
  }
  std::vector<NamedOutline> outlines;
  for (const std::vector<std::size_t>& chain : *chains) {
    NamedOutline& outline =
        outlines.emplace_back(NamedOutline{fmt::format("outline {}", outlines.size() + 1), pslg.source, {}});
    for (const std::size_t p : chain) outline.points.push_back(pslg.points[p]);
    if (chains->size() > 1) check_outline(outline);
  }
  if (outlines.size() < 2) return;
  check_edges_apart(outlines, "give outlines that are apart");
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const auto around = std::ranges::count_if(outlines, [&](const NamedOutline& other) {
      return &other != &outlines[i] && is_inside(other, outlines[i].points[0]);
    });
    if (around % 2 == 1) pslg.holes.push_back(seed_of(outlines, i));
  }
}

}  // namespace leonhard::app
