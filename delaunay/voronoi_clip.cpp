// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/voronoi_clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "leonhard/delaunay/plane/window_clip.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// A polygon that never turns right and has one lexicographic maximum goes round once: it is convex.
void check_window(std::span<const Point2> window) {
  const std::size_t n = window.size();
  if (n < 3) throw InputError("window", "a window has three corners or more", "give a convex polygon");
  std::size_t left_turns = 0, rises = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 a = window[i], b = window[(i + 1) % n], c = window[(i + 2) % n];
    if (!is_finite(a)) throw InputError("window", "the corner " + mesh::words(a) + " is not finite");
    const Sign turn = is_finite(b) && is_finite(c) ? kernel::orient2d(a, b, c) : Sign::zero;
    if (turn == Sign::negative || a == b)
      throw InputError("window",
                       "the polygon is not convex and counter-clockwise at its corner " + mesh::words(b),
                       "give the corners of a convex polygon in counter-clockwise order, each once");
    if (turn == Sign::positive) ++left_turns;
    if (a < b && c < b) ++rises;
  }
  if (left_turns < 3 || rises != 1)
    throw InputError("window", "the polygon is not convex", "give the corners of a convex polygon");
}

Point2 scaled(Point2 p, int exponent) { return {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent)}; }

/// The power of two that brings every coordinate below 1 in size.
int shrinking_exponent(const VoronoiDiagram& diagram, std::span<const Point2> window) {
  double largest = std::numeric_limits<double>::denorm_min();
  for (const std::span<const Point2> points : {std::span<const Point2>(diagram.sites.flat()), window})
    for (const Point2 p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return -std::ilogb(largest) - 1;
}

/// A corner of a cell in the making, and the line of the side from it to the next corner: a side of the window, by its number,
/// or a bisector, by that number of sides and its place in the cell.
struct CutCorner {
  Vec2 at;
  std::size_t line;
};

/// Twice the area of a polygon.
double twice_area(std::span<const CutCorner> polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(polygon[i].at - polygon[0].at, polygon[i + 1].at - polygon[0].at);
  return sum;
}

/// The part of a convex polygon that is nearer to the origin than to `neighbour`; `line` numbers the bisector, `cut` is room to
/// work in.
void cut_by_bisector(std::vector<CutCorner>& polygon, Vec2 neighbour, std::size_t line,
                     std::vector<CutCorner>& cut) {
  const int exponent = std::ilogb(std::max(std::abs(neighbour.x), std::abs(neighbour.y)));
  const Vec2 normal{std::scalbn(neighbour.x, -exponent), std::scalbn(neighbour.y, -exponent)};
  const Vec2 middle = 0.5 * neighbour;
  const auto inside = [&](Vec2 p) { return dot(normal, middle - p); };
  cut.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const CutCorner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = inside(p.at), at_q = inside(q.at);
    if (at_p >= 0) cut.push_back({p.at, at_p == 0 && at_q < 0 ? line : p.line});
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
      cut.push_back({p.at + at_p / (at_p - at_q) * (q.at - p.at), at_p > 0 ? line : p.line});
  }
  std::swap(polygon, cut);
}

class Clipper {
 public:
  /// sides      what each side is called in `crossings`
  /// crossings  of edges of the diagram with sides, found before and now
  Clipper(const VoronoiDiagram& diagram, std::span<const Point2> window, std::span<const std::size_t> sides,
          WindowCrossings& crossings)
      : diagram_(diagram),
        window_(window),
        sides_(sides),
        crossings_(crossings),
        exponent_(shrinking_exponent(diagram, window)) {
    for (const Point2 corner : window) small_window_.push_back(scaled(corner, exponent_));
  }

  ClippedVoronoi clip() {
    result_.first_corner.push_back(0);
    for (const VertexId site : diagram_.sites.ids()) {
      cut_out(site);
      if (polygon_.size() >= 3)
        add_corners(site);
      else
        add_vertices(site);
      // Scaled back in two steps: twice the exponent may be beyond what one power of two holds.
      const double area = polygon_.size() < 3 ? 0 : 0.5 * std::max(0.0, twice_area(polygon_));
      result_.area.push_back(std::scalbn(std::scalbn(area, -exponent_), -exponent_));
      result_.first_corner.push_back(result_.corners.size());
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool in_window(const VoronoiDiagram::Vertex& vertex) const {
    if (!std::isfinite(vertex.error)) return false;
    for (std::size_t i = 0; i < window_.size(); ++i)
      if (kernel::orient2d(window_[i], window_[(i + 1) % window_.size()], vertex.at) == Sign::negative)
        return false;
    return true;
  }

  /// The cell about its site, where differences of near coordinates lose nothing.
  void cut_out(VertexId site) {
    const Point2 origin = scaled(diagram_.sites[site], exponent_);
    polygon_.clear();
    for (std::size_t i = 0; i < small_window_.size(); ++i) polygon_.push_back({small_window_[i] - origin, i});
    const auto cell = diagram_.cell(site);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      if (polygon_.empty()) return;
      const Vec2 neighbour = scaled(diagram_.sites[diagram_.across(cell[k], site)], exponent_) - origin;
      if (neighbour != Vec2{})
        cut_by_bisector(polygon_, neighbour, window_.size() + k,
                        room_);  // zero: lost beside the largest number
    }
    // Of corners at one place the last one stays, whose side goes on.
    std::vector<CutCorner>& corners = room_;
    corners.clear();
    for (const CutCorner& corner : polygon_) {
      if (!corners.empty() && corners.back().at == corner.at) corners.pop_back();
      corners.push_back(corner);
    }
    while (corners.size() > 1 && corners.back().at == corners.front().at) corners.pop_back();
    std::swap(polygon_, room_);
  }

  /// The corners as both cells at a side have them: vertices of the diagram, corners of the window, and crossings of an edge with
  /// a side of the window, which are found once.
  void add_corners(VertexId site) {
    const Point2 origin = scaled(diagram_.sites[site], exponent_);
    const std::size_t first = result_.corners.size();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const std::size_t before = polygon_[i == 0 ? polygon_.size() - 1 : i - 1].line,
                        after = polygon_[i].line;
      places_of(site, before, after, scaled(origin + polygon_[i].at, -exponent_));
      result_.corners.insert(result_.corners.end(), places_.begin(), places_.end());
    }
    drop_repeated(first);
  }

  /// The corners of a cell in the window that is smaller than the rounding of its neighbours' places.
  void add_vertices(VertexId site) {
    if (diagram_.is_unbounded(site)) return;
    const std::vector<VoronoiVertexId> corners = diagram_.cell_vertices(site);
    if (!std::all_of(corners.begin(), corners.end(),
                     [&](VoronoiVertexId v) { return in_window(diagram_.vertices[v]); }))
      return;
    const std::size_t first = result_.corners.size();
    for (const VoronoiVertexId v : corners) result_.corners.push_back(diagram_.vertices[v].at);
    drop_repeated(first);
  }

  /// Of corners at one place one stays; a cell that is thinner than doubles tell keeps them all, so that it has a place.
  void drop_repeated(std::size_t first) {
    auto& corners = result_.corners;
    const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(first);
    shared_.assign(begin, corners.end());
    shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
    while (shared_.size() > 1 && shared_.back() == shared_.front()) shared_.pop_back();
    if (shared_.size() < 3) return;
    corners.resize(first);
    corners.insert(corners.end(), shared_.begin(), shared_.end());
  }

  /// Where the line `before` meets the line `after`, into places_; several vertices of the diagram where edges between them are
  /// shorter than rounding.
  void places_of(VertexId site, std::size_t before, std::size_t after, Point2 rounded) {
    const std::size_t sides = window_.size();
    const auto cell = diagram_.cell(site);
    places_.assign(1, rounded);
    if (before < sides && after < sides) {
      if (after == (before + 1) % sides) places_[0] = window_[after];
    } else if (before >= sides && after >= sides) {
      std::vector<Point2> chain;
      for (std::size_t k = before - sides; k != after - sides; k = (k + 1) % cell.size()) {
        const MaybeId<VoronoiVertexId> vertex = common_vertex(cell[k], cell[(k + 1) % cell.size()]);
        if (!vertex || !in_window(diagram_.vertices[*vertex])) return;
        chain.push_back(diagram_.vertices[*vertex].at);
      }
      places_ = std::move(chain);
    } else {
      const VoronoiEdgeId edge = cell[std::max(before, after) - sides];
      const std::size_t side = std::min(before, after);
      const Point2 a = window_[side], b = window_[(side + 1) % sides];
      if (a.x == b.x) rounded.x = a.x;
      if (a.y == b.y) rounded.y = a.y;
      places_[0] = crossings_.emplace(std::pair(edge, sides_[side]), rounded).first->second;
    }
  }

  [[nodiscard]] MaybeId<VoronoiVertexId> common_vertex(VoronoiEdgeId a, VoronoiEdgeId b) const {
    for (const auto end : diagram_.edges[a].ends)
      if (end && (end == diagram_.edges[b].ends[0] || end == diagram_.edges[b].ends[1])) return end;
    return {};
  }

  const VoronoiDiagram& diagram_;
  std::span<const Point2> window_;
  std::span<const std::size_t> sides_;
  WindowCrossings& crossings_;
  int exponent_;
  std::vector<Point2> small_window_;
  std::vector<CutCorner> polygon_, room_;  ///< of the cell in hand, scaled, about its site
  std::vector<Point2> places_, shared_;
  ClippedVoronoi result_;
};

}  // namespace

ClippedVoronoi clip_to_window(const VoronoiDiagram& diagram, std::span<const Point2> window,
                              std::span<const std::size_t> sides, WindowCrossings& crossings) {
  check_window(window);
  return Clipper(diagram, window, sides, crossings).clip();
}

ClippedVoronoi clip(const VoronoiDiagram& diagram, std::span<const Point2> window) {
  std::vector<std::size_t> sides(window.size());
  std::iota(sides.begin(), sides.end(), std::size_t{0});
  WindowCrossings crossings;
  return clip_to_window(diagram, window, sides, crossings);
}

std::array<Point2, 4> box_window(Point2 low, Point2 high) {
  if (!is_finite(low) || !is_finite(high) || !(low.x < high.x && low.y < high.y))
    throw InputError("window", mesh::words(low) + " to " + mesh::words(high) + " is no box",
                     "give the lower left corner, then the upper right one");
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

std::array<Point2, 4> window_about(std::span<const Point2> points, double margin) {
  if (points.empty()) return box_window({0, 0}, {1, 1});
  Point2 low = points.front(), high = low;
  for (const Point2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double by = margin * std::max(high.x - low.x, high.y - low.y);
  if (by == 0) by = margin;
  constexpr double limit = std::numeric_limits<double>::max();
  const auto beyond = [&](double value, double step, double end) {
    return std::clamp(step < 0 ? std::min(value + step, std::nextafter(value, end))
                               : std::max(value + step, std::nextafter(value, end)),
                      -limit, limit);
  };
  return box_window({beyond(low.x, -by, -limit), beyond(low.y, -by, -limit)},
                    {beyond(high.x, by, limit), beyond(high.y, by, limit)});
}

}  // namespace leonhard::delaunay
