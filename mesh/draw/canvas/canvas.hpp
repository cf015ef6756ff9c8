// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/line_style.hpp"
#include "leonhard/mesh/draw/picture.hpp"

/// What the pictures of this room are painted on: the one place that knows cairo. Not meant for callers of the
/// room. Lengths are pixels of the page, x to the right, y down.
namespace leonhard::draw {

/// A rectangle of the page.
struct Rect {
  double left{}, top{}, width{}, height{};
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
  [[nodiscard]] Rect grown(double by) const { return {left - by, top - by, width + 2 * by, height + 2 * by}; }
};

struct Pen {
  Colour colour;
  double width = 1;  ///< in thin lines: 1 is the thinnest line that prints well, whatever the picture's size
  LineStyle style = LineStyle::solid;
  double opacity = 1;
};

struct TextStyle {
  double size = 1;  ///< in the picture's text size
  bool bold = false;
  double across = 0;     ///< where the anchor is: 0 left end, 0.5 middle, 1 right end
  double down = 0.5;     ///< 0 top, 0.5 middle of the digits, 1 base line
  bool upwards = false;  ///< turned by 90 degrees, reading from bottom to top
  Colour colour{0.1, 0.1, 0.1};
};

/// Pixels, row by row from the top, each 0xAARRGGBB with the colours multiplied by the opacity.
struct Raster {
  int width{}, height{};
  std::vector<std::uint32_t> pixels;
};

[[nodiscard]] std::uint32_t packed(Colour colour);

inline constexpr Colour white{1, 1, 1}, ink{0.1, 0.1, 0.1};

class Canvas {
 public:
  /// A white page. throws InputError for an extension other than .png .svg .pdf or a size out of range
  Canvas(const std::filesystem::path& path, const PictureSize& size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double text_size() const { return text_size_; }  ///< pixels, size 1 of TextStyle
  [[nodiscard]] double thin() const { return thin_; }            ///< pixels, width 1 of a Pen
  [[nodiscard]] bool is_vector() const { return vector_; }
  [[nodiscard]] double dots_per_pixel() const { return dots_per_pixel_; }  ///< resolution of embedded images

  // A path is built by these and used up by stroke or fill.
  void move_to(Point2 p);
  void line_to(Point2 p);
  void close_path();
  void rectangle(const Rect& r);
  void circle(Point2 centre, double radius);
  void stroke(const Pen& pen);
  void fill(Colour colour, double opacity = 1);
  void fill_and_keep(Colour colour);  ///< fill, the path staying for stroke

  void line(Point2 a, Point2 b, const Pen& pen);

  /// UTF-8; what is not valid shows as the replacement character.
  void text(Point2 anchor, const std::string& words, const TextStyle& style);
  [[nodiscard]] double text_width(const std::string& words, const TextStyle& style);

  void image(const Rect& where, const Raster& raster);

  void begin_clip(const Rect& r);
  void end_clip();

  /// What is drawn between the two is embedded as an image in vector formats, at a pixel's resolution: at more,
  /// lines in an image take more space than as vectors. Without effect on PNG.
  void begin_raster(const Rect& r);
  void end_raster();

  /// Write the file, whole or not at all. throws OutputError
  void save();

 private:
  struct Cairo;
  std::filesystem::path path_;
  double width_, height_, text_size_, thin_;
  double dots_per_pixel_ = 1;
  bool vector_ = false;
  std::unique_ptr<Cairo> cairo_;
};

}  // namespace leonhard::draw
