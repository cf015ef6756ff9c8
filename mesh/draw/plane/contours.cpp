// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/plane/contours.hpp"

#include <algorithm>
#include <deque>

namespace leonhard::draw {
namespace {

// One level's lines, followed from triangle to triangle through the edges they cross.
class Tracer {
 public:
  Tracer(const MeshScene& scene, std::span<const double> values, double level)
      : scene_(scene), values_(values), level_(level), done_(scene.mesh().triangle_count()) {}

  std::vector<std::vector<Point2>> all() {
    std::vector<std::vector<Point2>> lines;
    for (const TriangleId t : scene_.visible()) {
      if (!done_[t] && is_crossed(t)) lines.push_back(through(t));
    }
    return lines;
  }

 private:
  [[nodiscard]] bool above(VertexId v) const { return values_[v.index()] >= level_; }

  [[nodiscard]] bool is_crossed(TriangleId t) const {
    const auto& [a, b, c] = scene_.mesh().corners[t];
    return above(a) != above(b) || above(b) != above(c);
  }
  // Is the edge opposite corner i crossed, and where.
  [[nodiscard]] bool is_crossed(TriangleId t, std::size_t i) const {
    const auto& corners = scene_.mesh().corners[t];
    return above(corners[(i + 1) % 3]) != above(corners[(i + 2) % 3]);
  }
  [[nodiscard]] Point2 crossing(TriangleId t, std::size_t i) const {
    const auto& corners = scene_.mesh().corners[t];
    VertexId a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
    if (b < a) std::swap(a, b);  // the same bits from both sides
    const double ua = values_[a.index()], ub = values_[b.index()];
    return scene_.page(a) + (level_ - ua) / (ub - ua) * (scene_.page(b) - scene_.page(a));
  }

  // The whole line through a triangle: out through one crossed edge as far as it goes, then through the other.
  std::vector<Point2> through(TriangleId start) {
    std::array<std::size_t, 2> ends{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_crossed(start, i)) ends[found++] = i;
    }
    done_[start] = 1;
    std::deque<Point2> line{crossing(start, ends[0]), crossing(start, ends[1])};
    follow(start, ends[1], [&](Point2 p) { line.push_back(p); });
    follow(start, ends[0], [&](Point2 p) { line.push_front(p); });
    return {line.begin(), line.end()};
  }

  template <class Add>
  void follow(TriangleId t, std::size_t leaving, Add add) {
    for (;;) {
      const MaybeId<TriangleId> next = scene_.mesh().neighbours[t][leaving];
      if (!next || !scene_.is_visible(*next) || done_[*next]) return;
      const auto& back = scene_.mesh().neighbours[*next];
      for (std::size_t i = 0; i < 3; ++i) {
        if (back[i] != MaybeId<TriangleId>(t) && is_crossed(*next, i)) leaving = i;
      }
      t = *next;
      done_[t] = 1;
      add(crossing(t, leaving));
    }
  }

  const MeshScene& scene_;
  std::span<const double> values_;
  double level_;
  PerId<TriangleId, char> done_;
};

struct Corner {
  Point2 at;
  double value;
};

// The part of a polygon where sign * (value - bound) >= 0.
std::vector<Corner> keep(const std::vector<Corner>& polygon, double bound, double sign) {
  std::vector<Corner> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double sa = sign * (a.value - bound), sb = sign * (b.value - bound);
    if (sa >= 0) result.push_back(a);
    if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0))
      result.push_back({a.at + (sa / (sa - sb)) * (b.at - a.at), bound});
  }
  return result;
}

}  // namespace

std::vector<std::vector<Point2>> contour(const MeshScene& scene, std::span<const double> values,
                                         double level) {
  return Tracer(scene, values, level).all();
}

std::vector<Point2> band_of(const std::array<Point2, 3>& corners, const std::array<double, 3>& values,
                            double low, double high) {
  std::vector<Corner> polygon;
  for (std::size_t i = 0; i < 3; ++i) polygon.push_back({corners[i], values[i]});
  polygon = keep(keep(polygon, low, 1), high, -1);
  std::vector<Point2> result;
  for (const Corner& corner : polygon) result.push_back(corner.at);
  return result;
}

}  // namespace leonhard::draw
