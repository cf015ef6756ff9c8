// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/outline_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/geometry/algorithms/point_on_surface.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "leonhard/kernel/boost_geometry.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::app {
namespace {

std::string words(Point2 p) { return fmt::format("({}, {})", p.x, p.y); }

/// For p on the line through a and b: whether it lies on the segment.
bool within_box(Point2 a, Point2 b, Point2 p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// An edge of one of several outlines.
struct Edge {
  std::size_t outline, index;  ///< from point `index` to the next one around
  Point2 from, to;
  double low_x, high_x, low_y, high_y;
};

std::vector<Edge> edges_by_x(std::span<const NamedOutline> outlines) {
  std::vector<Edge> edges;
  for (std::size_t o = 0; o < outlines.size(); ++o) {
    const std::vector<Point2>& points = outlines[o].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point2 a = points[i], b = points[(i + 1) % points.size()];
      edges.push_back(
          {o, i, a, b, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.low_x, e.outline, e.index); });
  return edges;
}

/// Visit all pairs of edges whose boxes overlap: sweep in x, compare in y.
void for_overlapping(const std::vector<Edge>& edges,
                     const std::function<void(const Edge&, const Edge&)>& visit) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].low_x <= edges[i].high_x; ++j)
      if (edges[i].low_y <= edges[j].high_y && edges[j].low_y <= edges[i].high_y) visit(edges[i], edges[j]);
}

/// Whether two edges of one outline of n points meet in more than the corner that neighbours share.
bool improper_meeting(const Edge& e, const Edge& f, std::size_t n) {
  const bool e_first = (e.index + 1) % n == f.index, f_first = (f.index + 1) % n == e.index;
  if (!e_first && !f_first) return segments_meet(e.from, e.to, f.from, f.to);
  const Edge& first = e_first ? e : f;
  const Edge& second = e_first ? f : e;
  return kernel::orient2d(first.from, first.to, second.to) == Sign::zero &&
         (within_box(first.from, first.to, second.to) || within_box(second.from, second.to, first.from));
}

void check_points(const NamedOutline& body) {
  const std::size_t n = body.points.size();
  if (n < 3)
    throw InputError(body.where, fmt::format("body \"{}\" has {} points only", body.name, n),
                     "an outline needs at least 3");
  for (std::size_t i = 0; i < n; ++i)
    if (!is_finite(body.points[i]))
      throw InputError(body.where,
                       fmt::format("point {} of body \"{}\" is {}", i + 1, body.name, words(body.points[i])),
                       "coordinates must be finite numbers");
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto less = [&body](std::size_t a, std::size_t b) {
    return std::tuple(body.points[a].x, body.points[a].y, a) <
           std::tuple(body.points[b].x, body.points[b].y, b);
  };
  std::ranges::sort(order, less);
  for (std::size_t k = 1; k < n; ++k)
    if (body.points[order[k - 1]] == body.points[order[k]])
      throw InputError(body.where,
                       fmt::format("points {} and {} of body \"{}\" are the same, {}", order[k - 1] + 1,
                                   order[k] + 1, body.name, words(body.points[order[k]])),
                       "give each point once; the outline closes by itself");
}

/// Points that lie inside a small triangle at a convex corner, or halfway to what reaches into it: the classic proof that
/// every polygon has a diagonal, tried at every corner in turn.
std::optional<Point2> inside_by_diagonals(const std::vector<Point2>& points) {
  const std::size_t n = points.size();
  const Sign turn = rounded_area2(points) > 0 ? Sign::positive : Sign::negative;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 a = points[(i + n - 1) % n], b = points[i], c = points[(i + 1) % n];
    if (kernel::orient2d(a, b, c) != turn) continue;
    Point2 end = a + 0.5 * (c - a);
    double reach = 0;
    for (const Point2 q : points) {
      const bool in_triangle = q != a && q != b && q != c && kernel::orient2d(a, b, q) == turn &&
                               kernel::orient2d(b, c, q) == turn && kernel::orient2d(c, a, q) == turn;
      const double far = in_triangle ? std::abs(cross(c - a, q - a)) : 0;
      if (far > reach) reach = far, end = q;
    }
    const Point2 middle = b + 0.5 * (end - b);
    if (locate_in_polygon(points, middle) == PointPlace::inside) return middle;
  }
  return std::nullopt;
}

}  // namespace

bool segments_meet(Point2 a, Point2 b, Point2 c, Point2 d) {
  const Sign abc = kernel::orient2d(a, b, c), abd = kernel::orient2d(a, b, d);
  const Sign cda = kernel::orient2d(c, d, a), cdb = kernel::orient2d(c, d, b);
  if (abc * abd == Sign::negative && cda * cdb == Sign::negative) return true;
  return (abc == Sign::zero && within_box(a, b, c)) || (abd == Sign::zero && within_box(a, b, d)) ||
         (cda == Sign::zero && within_box(c, d, a)) || (cdb == Sign::zero && within_box(c, d, b));
}

PointPlace locate_in_polygon(std::span<const Point2> polygon, Point2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Point2 low = polygon[i], high = polygon[(i + 1) % polygon.size()];
    if (high.y < low.y) std::swap(low, high);
    if (p.y < low.y || p.y > high.y) continue;
    const Sign side = kernel::orient2d(low, high, p);
    if (side == Sign::zero && within_box(low, high, p)) return PointPlace::on_boundary;
    if (low.y <= p.y && p.y < high.y && side == Sign::positive) inside = !inside;
  }
  return inside ? PointPlace::inside : PointPlace::outside;
}

double rounded_area2(std::span<const Point2> polygon) {
  double area2 = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    area2 += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return area2;
}

void check_outline(const NamedOutline& body) {
  check_points(body);
  const std::size_t n = body.points.size();
  const auto check_pair = [&](const Edge& e, const Edge& f) {
    if (!improper_meeting(e, f, n)) return;
    const auto [first, second] = std::minmax(e.index, f.index);
    const Edge& g = e.index == first ? e : f;
    const Edge& h = e.index == first ? f : e;
    throw InputError(
        body.where,
        fmt::format("the outline of body \"{}\" crosses or touches itself: edge {} from {} to {} meets edge "
                    "{} from {} to {}",
                    body.name, first + 1, words(g.from), words(g.to), second + 1, words(h.from), words(h.to)),
        "correct the points or their order");
  };
  for_overlapping(edges_by_x({&body, 1}), check_pair);
}

void check_edges_apart(std::span<const NamedOutline> bodies, const std::string& remedy) {
  for_overlapping(edges_by_x(bodies), [&](const Edge& e, const Edge& f) {
    if (e.outline == f.outline || !segments_meet(e.from, e.to, f.from, f.to)) return;
    const Edge& g = e.outline < f.outline ? e : f;
    const Edge& h = e.outline < f.outline ? f : e;
    throw InputError(
        bodies[h.outline].where,
        fmt::format(
            "bodies \"{}\" and \"{}\" overlap or touch: the edge from {} to {} meets the edge from {} to {}",
            bodies[g.outline].name, bodies[h.outline].name, words(g.from), words(g.to), words(h.from),
            words(h.to)),
        remedy);
  });
}

void check_apart(std::span<const NamedOutline> bodies) {
  const std::string remedy = "move one of them with translation, rotation_deg or scale";
  check_edges_apart(bodies, remedy);
  for (const NamedOutline& inner : bodies)
    for (const NamedOutline& outer : bodies)
      if (&inner != &outer && locate_in_polygon(outer.points, inner.points.front()) == PointPlace::inside)
        throw InputError(inner.where,
                         fmt::format("body \"{}\" lies inside body \"{}\": its point {} does", inner.name,
                                     outer.name, words(inner.points.front())),
                         remedy);
}

void check_inside_far_field(std::span<const NamedOutline> bodies, std::span<const Point2> far_field,
                            const std::string& where) {
  const double diameter = distance(far_field[0], far_field[far_field.size() / 2]);
  for (const NamedOutline& body : bodies) {
    const auto outside = std::ranges::find_if(
        body.points, [&](Point2 p) { return locate_in_polygon(far_field, p) != PointPlace::inside; });
    if (outside == body.points.end()) continue;
    double size = 0;
    for (const Point2 p : body.points) size = std::max(size, distance(p, body.points.front()));
    if (size >= diameter)
      throw InputError(
          where,
          fmt::format("the far field is smaller than body \"{}\": it is {:.6g} wide, the body {:.6g}",
                      body.name, diameter, size),
          "raise farfield.distance (it counts in chords of reference.length)");
    throw InputError(where,
                     fmt::format("body \"{}\" is not inside the far field: its point {} is out", body.name,
                                 words(*outside)),
                     "raise farfield.distance or move the body or farfield.centre");
  }
}

Point2 point_inside(const NamedOutline& body) {
  // Boost.Geometry looks for a good place in rounded arithmetic; whether it is inside is decided exactly.
  boost::geometry::model::polygon<Point2, false, false> polygon;
  polygon.outer().assign(body.points.begin(), body.points.end());
  Point2 seed;
  boost::geometry::point_on_surface(polygon, seed);
  if (is_finite(seed) && locate_in_polygon(body.points, seed) == PointPlace::inside) return seed;
  if (const auto found = inside_by_diagonals(body.points)) return *found;
  throw InputError(body.where, fmt::format("body \"{}\" is too thin: no point lies inside it", body.name),
                   "give it a thickness, or scale it up");
}

}  // namespace leonhard::app
