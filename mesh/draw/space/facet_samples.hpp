// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <array>
#include <cmath>

#include "leonhard/mesh/draw/canvas/convex_scan.hpp"
#include "leonhard/mesh/draw/space/tet_scene.hpp"

namespace leonhard::draw {

/// A quantity linear on the page.
struct PageLinear {
  double constant = 0, by_x = 0, by_y = 0;
  [[nodiscard]] double at(double x, double y) const { return constant + by_x * x + by_y * y; }
};

/// A facet in the samples of an image: outline, nearness and field as functions of the sample.
class FacetSamples {
 public:
  /// origin, per_page  of the image on the page; samples a page pixel
  FacetSamples(const Facet& facet, Point2 origin, double per_page, bool is_perspective)
      : count_(facet.count) {
    for (std::size_t i = 0; i < count_; ++i) {
      outline_[i] = {(facet.corners[i].x - origin.x) * per_page, (facet.corners[i].y - origin.y) * per_page};
    }
    choose_base();
    nearness_ = linear([&](std::size_t i) { return facet.corners[i].nearness; });
    // In perspective value x nearness is linear on the page, the value is not.
    weight_ = is_perspective ? nearness_ : PageLinear{1, 0, 0};
    value_ = linear([&](std::size_t i) {
      return facet.corners[i].value * (is_perspective ? facet.corners[i].nearness : 1.0);
    });
  }

  [[nodiscard]] std::span<const Point2> outline() const { return {outline_.data(), count_}; }
  [[nodiscard]] const PageLinear& nearness() const { return nearness_; }
  [[nodiscard]] double value(double x, double y) const { return value_.at(x, y) / weight_.at(x, y); }

  /// The distance from the line through edge i, positive inside.
  [[nodiscard]] PageLinear distance_from(std::size_t edge) const {
    const Point2 a = outline_[edge], b = outline_[(edge + 1) % count_];
    const double length = distance(a, b);
    if (length == 0) return {1e9, 0, 0};
    // The page's y points down: inside is to the right of the edge.
    const Vec2 inwards{(b.y - a.y) / length, -(b.x - a.x) / length};
    return {-(inwards.x * a.x + inwards.y * a.y), inwards.x, inwards.y};
  }

 private:
  // The three corners that span the most: sections have corners that coincide.
  void choose_base() {
    double most = -1;
    for (std::size_t skip = count_ == 4 ? 0 : 3; skip < 4; ++skip) {
      std::array<std::size_t, 3> candidate{};
      for (std::size_t i = 0, n = 0; i < count_; ++i) {
        if (i != skip) candidate[n++] = i;
      }
      const double area = std::abs(cross(outline_[candidate[1]] - outline_[candidate[0]],
                                         outline_[candidate[2]] - outline_[candidate[0]]));
      if (area > most) most = area, base_ = candidate;
    }
  }
  template <class Value>
  [[nodiscard]] PageLinear linear(Value value) const {
    const Point2 o = outline_[base_[0]];
    const Vec2 u = outline_[base_[1]] - o, v = outline_[base_[2]] - o;
    const double area = cross(u, v), first = value(base_[0]);
    if (area == 0) return {first, 0, 0};
    const double du = value(base_[1]) - first, dv = value(base_[2]) - first;
    const double by_x = (du * v.y - dv * u.y) / area, by_y = (dv * u.x - du * v.x) / area;
    return {first - by_x * o.x - by_y * o.y, by_x, by_y};
  }

  std::array<Point2, 4> outline_;
  std::array<std::size_t, 3> base_{};
  std::size_t count_;
  PageLinear nearness_, value_, weight_;
};

}  // namespace leonhard::draw
