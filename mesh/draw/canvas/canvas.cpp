// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

enum class Format { png, svg, pdf };

constexpr double points_per_pixel = 72.0 / 200.0;  // PDF: 200 pixels to the inch
constexpr double cap_height = 0.73;                // of the text size, DejaVu Sans

std::string lower(std::string s) {
  std::ranges::transform(s, s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

Format format_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  if (extension == ".png") return Format::png;
  if (extension == ".svg") return Format::svg;
  if (extension == ".pdf") return Format::pdf;
  throw InputError(path.string(),
                   extension.empty() ? "a picture's file name needs an extension that says its format"
                                     : "'" + extension + "' is no picture format of this program",
                   "name it .png, .svg or .pdf");
}

void check_size(const PictureSize& size) {
  for (const int pixels : {size.width, size.height}) {
    if (pixels < 64 || pixels > 8192) {
      throw InputError(
          "picture size",
          std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels is out of range",
          "give each between 64 and 8192");
    }
  }
  if (!(size.scale >= 0.2 && size.scale <= 5)) {
    throw InputError("picture scale", mesh::words(size.scale) + " is out of range", "give 0.2 to 5");
  }
}

// The length of the valid UTF-8 sequence at the front, 0 if there is none (RFC 3629: no overlong forms, no
// surrogates, nothing beyond U+10FFFF).
std::size_t utf8_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0U; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool bad = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F);
    return follows(1) && follows(2) && !bad ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool bad = (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
    return follows(1) && follows(2) && follows(3) && !bad ? 4 : 0;
  }
  return 0;
}

// cairo refuses invalid UTF-8 for good, and names in mesh files are any bytes.
std::string printable(std::string_view words) {
  std::string result;
  while (!words.empty()) {
    const std::size_t length = utf8_length(words);
    result += length > 0 ? words.substr(0, length) : words[0] == '\t' ? " " : "\xEF\xBF\xBD";
    words.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

cairo_status_t append(void* closure, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

// cairo numbers surfaces and images through the whole process; the same picture is to be the same file. Numbers
// them from 1 within the file. The characters before a name occur in no embedded image (base64).
std::string with_own_numbers(const std::string& svg) {
  std::map<std::string, std::size_t> number;
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = svg.find_first_of("\"#"); at != std::string::npos;
       at = svg.find_first_of("\"#", at + 1)) {
    for (const std::string_view kind : {"surface", "image"}) {
      if (svg.compare(at + 1, kind.size(), kind) != 0) continue;
      const std::size_t digits = at + 1 + kind.size();
      const std::size_t end = std::min(svg.find_first_not_of("0123456789", digits), svg.size());
      if (end == digits) continue;
      const auto [entry, is_new] = number.emplace(svg.substr(at + 1, end - at - 1), number.size() + 1);
      result += svg.substr(done, digits - done) + std::to_string(entry->second);
      done = end;
    }
  }
  return result + svg.substr(done);
}

void set_font(cairo_t* context, double size, bool bold) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

// Unhinted: text is as wide in every format and at every size.
void prepare(cairo_t* context) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
}

void set_source(cairo_t* context, Colour c, double opacity) {
  if (opacity >= 1) {
    cairo_set_source_rgb(context, c.red, c.green, c.blue);
  } else {
    cairo_set_source_rgba(context, c.red, c.green, c.blue, opacity);
  }
}

}  // namespace

std::uint32_t packed(Colour colour) {
  // As cairo rounds, so that an area filled with the colour has the very same pixels.
  const auto byte = [](double v) {
    return static_cast<std::uint32_t>(std::clamp(v, 0.0, 1.0) * 65535 + 0.5) >> 8;
  };
  return 0xFF000000U | byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

struct Canvas::Cairo {
  Format format;
  std::string bytes;  // what the surface streams into; outlives it
  cairo_surface_t* surface = nullptr;
  cairo_t* page = nullptr;
  cairo_surface_t* layer_surface = nullptr;
  cairo_t* layer = nullptr;
  Rect layer_rect;

  [[nodiscard]] cairo_t* current() const { return layer != nullptr ? layer : page; }
  void drop_layer() {
    if (layer != nullptr) cairo_destroy(layer);
    if (layer_surface != nullptr) cairo_surface_destroy(layer_surface);
    layer = nullptr;
    layer_surface = nullptr;
  }
  void finish() {
    drop_layer();
    if (page != nullptr) cairo_destroy(page);
    if (surface != nullptr) cairo_surface_destroy(surface);
    page = nullptr;
    surface = nullptr;
  }
  ~Cairo() { finish(); }
};

Canvas::Canvas(const std::filesystem::path& path, const PictureSize& size)
    : path_(path), width_(size.width), height_(size.height), cairo_(std::make_unique<Cairo>()) {
  cairo_->format = format_of(path);
  check_size(size);
  vector_ = cairo_->format != Format::png;
  const double grown = size.scale * std::sqrt(width_ * height_ / (1600.0 * 1000.0));
  text_size_ = 23 * grown;
  thin_ = std::max(grown, vector_ ? 0.1 : 0.7);
  constexpr double most_dots = 32e6;  // of an embedded image: 128 MB while drawing
  if (vector_) dots_per_pixel_ = std::min(2.0, std::sqrt(most_dots / (width_ * height_)));

  if (cairo_->format == Format::png) {
    cairo_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height);
  } else if (cairo_->format == Format::svg) {
    cairo_->surface = cairo_svg_surface_create_for_stream(append, &cairo_->bytes, width_, height_);
    cairo_svg_surface_set_document_unit(cairo_->surface, CAIRO_SVG_UNIT_PX);
  } else {
    cairo_->surface = cairo_pdf_surface_create_for_stream(append, &cairo_->bytes, width_ * points_per_pixel,
                                                          height_ * points_per_pixel);
    // The date of creation would make two equal pictures differ.
    cairo_pdf_surface_set_metadata(cairo_->surface, CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
  }
  cairo_->page = cairo_create(cairo_->surface);
  if (cairo_->format == Format::pdf) cairo_scale(cairo_->page, points_per_pixel, points_per_pixel);
  prepare(cairo_->page);
  rectangle({0, 0, width_, height_});
  fill(white);
}

Canvas::~Canvas() = default;

void Canvas::move_to(Point2 p) { cairo_move_to(cairo_->current(), p.x, p.y); }
void Canvas::line_to(Point2 p) { cairo_line_to(cairo_->current(), p.x, p.y); }
void Canvas::close_path() { cairo_close_path(cairo_->current()); }
void Canvas::rectangle(const Rect& r) {
  cairo_rectangle(cairo_->current(), r.left, r.top, r.width, r.height);
}

void Canvas::circle(Point2 centre, double radius) {
  cairo_new_sub_path(cairo_->current());
  cairo_arc(cairo_->current(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
}

void Canvas::stroke(const Pen& pen) {
  cairo_t* context = cairo_->current();
  const double w = pen.width * thin_;
  set_source(context, pen.colour, pen.opacity);
  cairo_set_line_width(context, w);
  const double unit = std::max(w, 1.5 * thin_);
  const std::array<double, 4> dashed{5 * unit, 3.5 * unit}, dotted{0.01 * unit, 2.5 * unit},
      dash_dotted{6 * unit, 3 * unit, 0.01 * unit, 3 * unit};
  switch (pen.style) {
    case LineStyle::none:
    case LineStyle::solid:
      cairo_set_dash(context, nullptr, 0, 0);
      break;
    case LineStyle::dashed:
      cairo_set_dash(context, dashed.data(), 2, 0);
      break;
    case LineStyle::dotted:
      cairo_set_dash(context, dotted.data(), 2, 0);
      break;
    case LineStyle::dash_dotted:
      cairo_set_dash(context, dash_dotted.data(), 4, 0);
      break;
  }
  if (pen.style == LineStyle::none) {
    cairo_new_path(context);
  } else {
    cairo_stroke(context);
  }
}

void Canvas::fill(Colour colour, double opacity) {
  set_source(cairo_->current(), colour, opacity);
  cairo_fill(cairo_->current());
}

void Canvas::fill_and_keep(Colour colour) {
  set_source(cairo_->current(), colour, 1);
  cairo_fill_preserve(cairo_->current());
}

void Canvas::line(Point2 a, Point2 b, const Pen& pen) {
  move_to(a);
  line_to(b);
  stroke(pen);
}

void Canvas::text(Point2 anchor, const std::string& words, const TextStyle& style) {
  cairo_t* context = cairo_->current();
  const double size = style.size * text_size_;
  const std::string shown = printable(words);
  cairo_save(context);
  set_font(context, size, style.bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context, shown.c_str(), &extents);
  cairo_translate(context, anchor.x, anchor.y);
  if (style.upwards) cairo_rotate(context, -std::numbers::pi / 2);
  cairo_move_to(context, -style.across * extents.x_advance, (1 - style.down) * cap_height * size);
  set_source(context, style.colour, 1);
  cairo_show_text(context, shown.c_str());
  cairo_restore(context);
  cairo_new_path(context);
}

double Canvas::text_width(const std::string& words, const TextStyle& style) {
  cairo_t* context = cairo_->current();
  cairo_save(context);
  set_font(context, style.size * text_size_, style.bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context, printable(words).c_str(), &extents);
  cairo_restore(context);
  return extents.x_advance;
}

void Canvas::image(const Rect& where, const Raster& raster) {
  assert(raster.pixels.size() == static_cast<std::size_t>(raster.width) * raster.height);
  cairo_surface_t* source = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.width, raster.height);
  cairo_surface_flush(source);
  unsigned char* data = cairo_image_surface_get_data(source);
  const int stride = cairo_image_surface_get_stride(source);
  for (int row = 0; data != nullptr && row < raster.height; ++row) {
    const auto* first =
        reinterpret_cast<const unsigned char*>(raster.pixels.data() + std::size_t(row) * raster.width);
    std::copy_n(first, 4 * std::size_t(raster.width), data + std::size_t(row) * stride);
  }
  cairo_surface_mark_dirty(source);
  cairo_t* context = cairo_->current();
  cairo_save(context);
  cairo_translate(context, where.left, where.top);
  cairo_scale(context, where.width / raster.width, where.height / raster.height);
  cairo_set_source_surface(context, source, 0, 0);
  // Only PNG pixels lie on page pixels and need no interpolation; elsewhere the viewer smooths.
  cairo_pattern_set_filter(cairo_get_source(context), vector_ ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
  cairo_paint(context);
  cairo_restore(context);
  cairo_surface_destroy(source);
}

void Canvas::begin_clip(const Rect& r) {
  cairo_save(cairo_->current());
  rectangle(r);
  cairo_clip(cairo_->current());
}

void Canvas::end_clip() { cairo_restore(cairo_->current()); }

void Canvas::begin_raster(const Rect& r) {
  if (!vector_) return;
  cairo_->layer_rect = r;
  cairo_->layer_surface = cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(std::ceil(r.width)), static_cast<int>(std::ceil(r.height)));
  cairo_->layer = cairo_create(cairo_->layer_surface);
  prepare(cairo_->layer);
  cairo_translate(cairo_->layer, -r.left, -r.top);
}

void Canvas::end_raster() {
  if (cairo_->layer == nullptr) return;
  cairo_t* page = cairo_->page;
  cairo_set_source_surface(page, cairo_->layer_surface, cairo_->layer_rect.left, cairo_->layer_rect.top);
  cairo_paint(page);
  cairo_->drop_layer();
}

void Canvas::save() {
  const cairo_status_t drawn = cairo_status(cairo_->page);
  cairo_status_t encoded = CAIRO_STATUS_SUCCESS;
  if (cairo_->format == Format::png) {
    encoded = cairo_surface_write_to_png_stream(cairo_->surface, append, &cairo_->bytes);
  }
  cairo_surface_finish(cairo_->surface);
  for (const cairo_status_t status : {drawn, encoded, cairo_surface_status(cairo_->surface)}) {
    if (status != CAIRO_STATUS_SUCCESS) throw OutputError(path_, cairo_status_to_string(status));
  }
  cairo_->finish();
  const bool svg = cairo_->format == Format::svg;
  io::write_file_atomically(path_, svg ? with_own_numbers(cairo_->bytes) : cairo_->bytes);
}

}  // namespace leonhard::draw
