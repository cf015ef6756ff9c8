// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/index_raster.hpp"

#include <algorithm>
#include <cmath>

namespace leonhard::draw {
namespace {

constexpr std::uint16_t empty = 0xFFFF;

int samples_for(double pixels) {
  constexpr double most = 100e6;  // samples, two bytes each
  return std::clamp(static_cast<int>(std::sqrt(most / pixels)), 1, 3);
}

// Where the edge crosses the horizontal at y. Ends ordered by coordinates: the two triangles of an edge get the
// same bits.
double crossing(Point2 a, Point2 b, double y) {
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
  return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
}

}  // namespace

IndexRaster::IndexRaster(const Rect& area, double dots)
    : width_(std::max(1, static_cast<int>(std::lround(area.width * dots)))),
      height_(std::max(1, static_cast<int>(std::lround(area.height * dots)))),
      samples_(samples_for(double(width_) * height_)),
      origin_{area.left, area.top},
      per_page_(dots * samples_),
      index_(std::size_t(width_) * samples_ * height_ * samples_, empty) {}

// Calls paint(row, first, last) for the samples first <= i < last of each row whose centres lie in the triangle.
template <class Paint>
void IndexRaster::scan(const std::array<Point2, 3>& corners, Paint paint) {
  const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const double rows = double(height_) * samples_, columns = double(width_) * samples_;
  const auto bound = [](double v, double most) {
    return static_cast<std::int64_t>(std::ceil(std::clamp(v, 0.0, most)));
  };
  const std::int64_t first_row = bound(low - 0.5, rows), last_row = bound(high - 0.5, rows);
  for (std::int64_t row = first_row; row < last_row; ++row) {
    const double y = static_cast<double>(row) + 0.5;
    std::array<double, 2> x{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 a = corners[i], b = corners[(i + 1) % 3];
      if ((a.y <= y) != (b.y <= y) && found < 2) x[found++] = crossing(a, b, y);
    }
    if (found < 2) continue;
    if (x[0] > x[1]) std::swap(x[0], x[1]);
    const std::int64_t first = bound(x[0] - 0.5, columns), last = bound(x[1] - 0.5, columns);
    if (first < last) paint(row, first, last);
  }
}

void IndexRaster::fill(const std::array<Point2, 3>& corners, std::uint16_t index) {
  std::array<Point2, 3> p{};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = {(corners[i].x - origin_.x) * per_page_, (corners[i].y - origin_.y) * per_page_};
  }
  scan(p, [&](std::int64_t row, std::int64_t first, std::int64_t last) {
    const auto begin = index_.begin() + row * width_ * samples_;
    std::fill(begin + first, begin + last, index);
  });
}

void IndexRaster::fill(const std::array<Point2, 3>& corners, const std::array<double, 3>& values,
                       std::span<const double> levels) {
  std::array<Point2, 3> p{};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = {(corners[i].x - origin_.x) * per_page_, (corners[i].y - origin_.y) * per_page_};
  }
  const auto index_at = [&](double value) {
    return std::ranges::upper_bound(levels, value) - levels.begin();
  };
  const double least = std::ranges::min(values), most = std::ranges::max(values);
  if (index_at(least) == index_at(most)) return fill(corners, static_cast<std::uint16_t>(index_at(least)));

  const Vec2 u = p[1] - p[0], v = p[2] - p[0];
  const double area = cross(u, v), du = values[1] - values[0], dv = values[2] - values[0];
  const Vec2 gradient{(du * v.y - dv * u.y) / area, (dv * u.x - du * v.x) / area};
  scan(p, [&](std::int64_t row, std::int64_t first, std::int64_t last) {
    // Straight along the row: from level to level without asking at each sample.
    const auto value_at = [&](std::int64_t i) {
      const Vec2 to = Point2{static_cast<double>(i) + 0.5, static_cast<double>(row) + 0.5} - p[0];
      return std::clamp(values[0] + dot(gradient, to), least, most);  // slivers: rounding must not overshoot
    };
    auto index = index_at(value_at(first));
    const auto begin = index_.begin() + row * width_ * samples_;
    for (std::int64_t i = first; i < last; ++i) {
      const double value = value_at(i);
      while (index < std::ssize(levels) && value >= levels[index]) ++index;
      while (index > 0 && value < levels[index - 1]) --index;
      begin[i] = static_cast<std::uint16_t>(index);
    }
  });
}

Raster IndexRaster::resolve(std::span<const Colour> colours) const {
  std::vector<std::array<std::uint32_t, 3>> parts;
  for (const Colour c : colours) {
    const std::uint32_t word = packed(c);
    parts.push_back({word >> 16 & 0xFF, word >> 8 & 0xFF, word & 0xFF});
  }
  Raster raster{width_, height_, std::vector<std::uint32_t>(std::size_t(width_) * height_)};
  const std::uint32_t all = static_cast<std::uint32_t>(samples_ * samples_);
  const std::size_t stride = std::size_t(width_) * samples_;
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      std::uint32_t red = 0, green = 0, blue = 0, covered = 0;
      for (int s = 0; s < samples_; ++s) {
        const std::uint16_t* sample =
            &index_[(std::size_t(row) * samples_ + s) * stride + std::size_t(column) * samples_];
        for (int t = 0; t < samples_; ++t) {
          if (sample[t] == empty) continue;
          const auto& part = parts[sample[t]];
          red += part[0], green += part[1], blue += part[2], ++covered;
        }
      }
      const auto mean = [all](std::uint32_t sum) { return (sum + all / 2) / all; };
      raster.pixels[std::size_t(row) * width_ + column] =
          mean(255 * covered) << 24 | mean(red) << 16 | mean(green) << 8 | mean(blue);
    }
  }
  return raster;
}

}  // namespace leonhard::draw
