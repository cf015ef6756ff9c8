// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/assemble.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "leonhard/app/case/conditions.hpp"
#include "leonhard/app/geometry/curve.hpp"
#include "leonhard/app/geometry/dyadic_grid.hpp"
#include "leonhard/app/geometry/naca4.hpp"
#include "leonhard/app/geometry/outline_checks.hpp"
#include "leonhard/app/geometry/spacing.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/airfoil_dat.hpp"
#include "leonhard/mesh/io/pslg_file.hpp"

namespace leonhard::app {
namespace {

constexpr int least_far_field_edges = 12;

struct Box {
  Point2 low, high;
  [[nodiscard]] Point2 centre() const { return low + 0.5 * (high - low); }
  [[nodiscard]] double extent() const { return std::max(high.x - low.x, high.y - low.y); }
  [[nodiscard]] double largest() const {
    return std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  }
  void include(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

Box box_of(std::span<const Point2> points) {
  Box box{points.front(), points.front()};
  for (const Point2 p : points) box.include(p);
  return box;
}

/// The element of a body's file that it is.
AirfoilCoordinates element_of(const BodyCase& body) {
  if (body.element == 0) return io::read_airfoil(body.file);
  std::vector<AirfoilCoordinates> elements = io::read_airfoils(body.file);
  if (body.element > elements.size())
    throw InputError(body.file.string(), fmt::format("the file has no element {}", body.element),
                     "it has fewer");
  return std::move(elements[body.element - 1]);
}

/// The body's curve where it will lie.
/// warnings  those of its file are added
OutlineCurve placed_curve(const BodyCase& body, std::vector<std::string>& warnings) {
  const Placement placement{body.scale, body.rotation_deg, body.translation};
  if (!body.naca.empty()) return place(Naca4(body.naca, body.trailing_edge, body.where).outline(), placement);
  const AirfoilCoordinates airfoil = element_of(body);
  warnings.insert(warnings.end(), airfoil.warnings.begin(), airfoil.warnings.end());
  check_outline({body.name, body.file.string(), airfoil.points});
  if (airfoil.points.size() < 4)
    throw InputError(body.file.string(),
                     fmt::format("body \"{}\" has {} points only", body.name, airfoil.points.size()),
                     "a curve needs at least 4");
  return place(spline_outline(airfoil.points, airfoil.blunt_trailing_edge, body.corner_angle_deg), placement);
}

NamedOutline outline_of(const BodyCase& body, double chord, std::vector<std::string>& warnings) {
  const OutlineSpacing spacing{.elsewhere = body.spacing * chord,
                               .leading_edge = body.leading_edge_spacing * chord,
                               .trailing_edge = body.trailing_edge_spacing * chord};
  return {body.name, body.where, distribute(placed_curve(body, warnings), spacing)};
}

/// Put an outline's points on the grid, counter-clockwise.
void snap(NamedOutline& outline, const DyadicGrid& grid) {
  for (Point2& p : outline.points) p = grid(p);
  if (rounded_area2(outline.points) < 0) std::ranges::reverse(outline.points);
}

std::vector<Point2> far_field_circle(Point2 centre, double radius, double spacing, const DyadicGrid& grid) {
  const int edges =
      std::max(least_far_field_edges, static_cast<int>(std::ceil(2 * std::numbers::pi * radius / spacing)));
  std::vector<Point2> circle;
  for (int i = 0; i < edges; ++i) {
    const double angle = 2 * std::numbers::pi * i / edges;
    circle.push_back(grid(centre + radius * Vec2{std::cos(angle), std::sin(angle)}));
  }
  return circle;
}

void add_loop(Pslg& pslg, const std::vector<Point2>& loop, Marker marker, const std::string& name) {
  const std::size_t first = pslg.points.size();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    pslg.points.push_back(loop[i]);
    pslg.point_markers.push_back(marker);
    pslg.segments.push_back({first + i, first + (i + 1) % loop.size(), marker});
  }
  pslg.marker_names[marker] = name;
}

/// Each boundary point asks for the longer of its two edges.
void add_sources(const std::vector<Point2>& loop, std::vector<SizeSource>& sources) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 before = loop[(i + loop.size() - 1) % loop.size()], after = loop[(i + 1) % loop.size()];
    sources.push_back({loop[i], std::max(distance(before, loop[i]), distance(loop[i], after))});
  }
}

void check_edge_count(const Case& c, double radius, double spacing) {
  if (radius / spacing > 1e6)
    throw InputError(
        c.file.string(),
        fmt::format("farfield.spacing = {} asks for millions of edges on the far field", spacing),
        "raise farfield.spacing");
}

DomainGeometry domain_about_bodies(const Case& c) {
  const double chord = c.reference.length;
  DomainGeometry domain;
  std::vector<NamedOutline> bodies;
  for (const BodyCase& body : c.bodies) bodies.push_back(outline_of(body, chord, domain.warnings));
  Box box = box_of(bodies.front().points);
  for (const NamedOutline& body : bodies) {
    const Box other = box_of(body.points);
    box.include(other.low);
    box.include(other.high);
  }
  domain.body_extent = box.extent();
  domain.centre = c.farfield.centre.value_or(box.centre());
  domain.growth = c.mesher.growth;
  domain.max_size = chord * std::min(c.farfield.spacing, c.mesher.size.value_or(c.farfield.spacing));
  const double radius = c.farfield.distance * chord;
  check_edge_count(c, radius, domain.max_size);

  const double reach = std::max(std::abs(domain.centre.x), std::abs(domain.centre.y)) + radius;
  const DyadicGrid grid(box.extent(), std::max(box.largest(), reach));
  for (NamedOutline& body : bodies) snap(body, grid);
  const std::vector<Point2> circle = far_field_circle(domain.centre, radius, domain.max_size, grid);
  for (const NamedOutline& body : bodies) check_outline(body);
  check_inside_far_field(bodies, circle, c.file.string());
  check_apart(bodies);

  domain.pslg.source = c.file.string();
  for (const NamedOutline& body : bodies) {
    domain.body_names.push_back(body.name);
    add_loop(domain.pslg, body.points, static_cast<Marker>(domain.body_names.size()), body.name);
    domain.pslg.holes.push_back(point_inside(body));
    add_sources(body.points, domain.sources);
    domain.outlines.push_back(body.points);
  }
  add_loop(domain.pslg, circle, static_cast<Marker>(bodies.size() + 1), "farfield");
  return domain;
}

DomainGeometry domain_of(Pslg&& pslg, const Case& c) {
  DomainGeometry domain;
  domain.pslg = std::move(pslg);
  if (domain.pslg.points.size() < 3 || domain.pslg.segments.empty())
    throw InputError(c.domain_file.string(),
                     fmt::format("{} points and {} segments enclose no domain", domain.pslg.points.size(),
                                 domain.pslg.segments.size()),
                     "give the boundary as segments");
  const Box box = box_of(domain.pslg.points);
  if (!(box.extent() > 0) || !std::isfinite(box.extent()))
    throw InputError(c.domain_file.string(), fmt::format("the points span {}", box.extent()),
                     "correct the coordinates");
  domain.body_extent = box.extent();
  domain.centre = box.centre();
  if (c.mesher.size) domain.max_size = *c.mesher.size * c.reference.length;
  return domain;
}

}  // namespace

void name_markers(const Case& c, Pslg& pslg) {
  // Unmarked segments may all turn out to be inner ones: [boundary.0] may be there and is not asked for yet.
  const bool zero_has_condition = c.boundary.contains("0");
  std::vector<Marker> used;
  for (const Pslg::Segment& segment : pslg.segments)
    if (segment.marker != 0 || zero_has_condition) used.push_back(segment.marker);
  for (const auto& [marker, condition] : match_conditions(c, used, pslg.marker_names, c.domain_file.string()))
    pslg.marker_names[marker] = condition.name;
}

DomainGeometry make_domain(const Case& c) {
  if (!c.mesh_file.empty())
    throw InputError(c.file.string(), "the case gives a ready mesh, there is no geometry to mesh",
                     "use the mesh");
  return c.domain_file.empty() ? domain_about_bodies(c) : domain_of(io::read_pslg(c.domain_file), c);
}

DomainGeometry make_domain(const Case& c, Pslg pslg) { return domain_of(std::move(pslg), c); }

}  // namespace leonhard::app
