// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "leonhard/mesh/draw/canvas/canvas.hpp"

namespace leonhard::draw {

/// The part of the segment ab in a rectangle, or none (Liang and Barsky, ACM TOG 3 (1984) 1-22). Rounding may
/// move an end by an ulp: good for pictures, not for geometry.
[[nodiscard]] inline std::optional<std::pair<Point2, Point2>> clip_segment(Point2 a, Point2 b,
                                                                           const Rect& r) {
  double enter = 0, leave = 1;
  const Vec2 d = b - a;
  const auto keep = [&](double rate, double room) {
    if (rate == 0) return room >= 0;
    const double t = room / rate;
    if (rate < 0) enter = std::max(enter, t);
    if (rate > 0) leave = std::min(leave, t);
    return enter <= leave;
  };
  const bool hits = keep(-d.x, a.x - r.left) && keep(d.x, r.right() - a.x) && keep(-d.y, a.y - r.top) &&
                    keep(d.y, r.bottom() - a.y);
  if (!hits) return std::nullopt;
  return std::pair{enter == 0 ? a : a + enter * d, leave == 1 ? b : a + leave * d};
}

/// Adds segments to a canvas' path, joined where one starts at the end of the last. Each is cut to a rectangle
/// first: a close-up may place vertices millions of pixels away, beyond what cairo's numbers hold.
class LineWriter {
 public:
  LineWriter(Canvas& canvas, const Rect& safe) : canvas_(canvas), safe_(safe) {}

  void segment(Point2 a, Point2 b) {
    const auto inside = clip_segment(a, b, safe_);
    if (!inside) return;
    if (count_ == 0 || last_ != inside->first) canvas_.move_to(inside->first);
    canvas_.line_to(inside->second);
    last_ = inside->second;
    ++count_;
  }
  /// Segments added since the last restart.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// To be called after the canvas' path was used up.
  void restart() { count_ = 0; }

 private:
  Canvas& canvas_;
  Rect safe_;
  Point2 last_;  ///< where the path ends, if count_ > 0
  std::size_t count_ = 0;
};

}  // namespace leonhard::draw
