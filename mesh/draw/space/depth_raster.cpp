// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/space/depth_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/mesh/draw/space/facet_samples.hpp"

namespace leonhard::draw {
namespace {

int samples_for(double pixels) {
  constexpr double most = 50e6;  // samples, eight bytes each
  return std::clamp(static_cast<int>(std::sqrt(most / pixels)), 1, 3);
}

// The edges of a facet that are drawn, as distances from them.
struct Lines {
  struct Line {
    PageLinear distance;
    float width;  // samples, on this facet's side
  };
  std::array<Line, 4> lines;
  std::size_t count = 0;

  // How much of a sample is covered by a line, whose width may be less than a sample's.
  [[nodiscard]] float coverage(double x, double y) const {
    float most = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto d = static_cast<float>(lines[i].distance.at(x, y));
      const float covered = std::min(d + 0.5F, lines[i].width) - std::max(d - 0.5F, 0.0F);
      most = std::max(most, covered);
    }
    return std::min(most, 1.0F);
  }
};

Lines lines_of(const Facet& facet, const FacetSamples& samples, const FacetPaint& paint, double per_page) {
  Lines result;
  if (!paint.show_lines) return result;
  for (std::size_t i = 0; i < facet.count; ++i) {
    const double sides = facet.lines[i] == FacetLine::outline ? 1.4 : 2;  // an outline has no other side
    const double width = line_width(facet, i, paint.thin) * paint.thin * per_page / sides;
    if (width > 0.01) result.lines[result.count++] = {samples.distance_from(i), static_cast<float>(width)};
  }
  return result;
}

std::uint32_t blend(std::uint32_t under, std::uint32_t over, float share) {
  const auto part = [&](int shift) {
    const float a = static_cast<float>(under >> shift & 0xFF), b = static_cast<float>(over >> shift & 0xFF);
    return static_cast<std::uint32_t>(a + share * (b - a) + 0.5F) << shift;
  };
  return 0xFF000000U | part(16) | part(8) | part(0);
}

}  // namespace

DepthRaster::DepthRaster(const Rect& area, double dots)
    : width_(std::max(1, static_cast<int>(std::lround(area.width * dots)))),
      height_(std::max(1, static_cast<int>(std::lround(area.height * dots)))),
      samples_(samples_for(double(width_) * height_)),
      origin_{area.left, area.top},
      per_page_(dots * samples_),
      nearness_(std::size_t(width_) * samples_ * height_ * samples_, -std::numeric_limits<float>::infinity()),
      colour_(nearness_.size(), 0) {}

void DepthRaster::fill(const Facet& facet, const FacetPaint& paint) {
  const FacetSamples samples(facet, origin_, per_page_, paint.is_perspective);
  const Lines lines = lines_of(facet, samples, paint, per_page_);
  const double light = brightness(facet);
  const std::uint32_t line = packed(paint.line);
  std::size_t index = facet.colour;
  std::uint32_t colour = packed(lit(paint.colours[index], light));
  const PageLinear& nearness = samples.nearness();
  const std::int64_t columns = std::int64_t{width_} * samples_, rows = std::int64_t{height_} * samples_;
  const auto shade = [&](double x, double y) {
    if (paint.levels.empty()) return;
    const double value = samples.value(x, y);
    const std::size_t before = index;
    while (index < paint.levels.size() && value >= paint.levels[index]) ++index;
    while (index > 0 && value < paint.levels[index - 1]) --index;
    if (index != before) colour = packed(lit(paint.colours[index], light));
  };
  scan_convex(samples.outline(), rows, columns, [&](std::int64_t row, std::int64_t first, std::int64_t last) {
    const double y = static_cast<double>(row) + 0.5;
    for (std::int64_t i = first; i < last; ++i) {
      const double x = static_cast<double>(i) + 0.5;
      const auto near = static_cast<float>(nearness.at(x, y));
      const std::size_t at = static_cast<std::size_t>(row * columns + i);
      if (near <= nearness_[at]) continue;
      nearness_[at] = near;
      shade(x, y);
      const float covered = lines.coverage(x, y);
      colour_[at] = covered > 0 ? blend(colour, line, covered) : colour;
    }
  });
}

Raster DepthRaster::resolve() const {
  Raster raster{width_, height_, std::vector<std::uint32_t>(std::size_t(width_) * height_)};
  const auto all = static_cast<std::uint32_t>(samples_ * samples_);
  const std::size_t stride = std::size_t(width_) * samples_;
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      std::uint32_t red = 0, green = 0, blue = 0, covered = 0;
      for (int s = 0; s < samples_; ++s) {
        const std::uint32_t* sample =
            &colour_[(std::size_t(row) * samples_ + s) * stride + std::size_t(column) * samples_];
        for (int t = 0; t < samples_; ++t) {
          if (sample[t] == 0) continue;
          red += sample[t] >> 16 & 0xFF, green += sample[t] >> 8 & 0xFF, blue += sample[t] & 0xFF, ++covered;
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
