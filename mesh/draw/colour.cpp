// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/colour.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace leonhard::draw {
namespace {

constexpr double white_x = 0.95047, white_z = 1.08883;  // D65, Y = 1
constexpr double delta = 6.0 / 29.0;                    // where CIELAB's cube root meets its straight part

double decode_gamma(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
double encode_gamma(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }
double compress(double t) {
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29.0;
}
double expand(double t) { return t > delta ? t * t * t : 3 * delta * delta * (t - 4.0 / 29.0); }

Colour linear_rgb(LabColour lab) {
  const double fy = (lab.lightness + 16) / 116;
  const double x = white_x * expand(fy + lab.a / 500), y = expand(fy), z = white_z * expand(fy - lab.b / 200);
  return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
          0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

bool in_gamut(Colour linear) {
  constexpr double slack = 1e-4;  // the matrices are rounded: white itself is off by 1e-5
  const auto fits = [](double v) { return v >= -slack && v <= 1 + slack; };
  return fits(linear.red) && fits(linear.green) && fits(linear.blue);
}

LabColour from_polar(double lightness, double chroma, double hue_deg) {
  const double hue = hue_deg * std::numbers::pi / 180;
  return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

// The path of the sequential map: lightness and hue run straight, the chroma keeps inside sRGB, which is
// narrowest in the teal of the middle.
LabColour sequential_path(double t) {
  return from_polar(15 + 78 * t, 45 - 105 * t + 140 * t * t, 308 - 208 * t);
}

// Straight from each end to the neutral: even by construction, the arms nearly equally long (70 and 74).
LabColour diverging_path(double t) {
  const LabColour neutral{96, 0, 0}, blue = from_polar(38, 39, 275), red = from_polar(42, 50, 32);
  const LabColour& end = t < 0.5 ? blue : red;
  const double s = std::abs(2 * t - 1);
  return {neutral.lightness + s * (end.lightness - neutral.lightness), s * end.a, s * end.b};
}

double lab_distance(LabColour p, LabColour q) {
  return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b);
}

// The parameter of the sequential path at a fraction of its length. 256 chords are within 1e-4 of the arc.
double sequential_parameter(double fraction) {
  constexpr int chords = 256;
  std::array<double, chords + 1> length{};
  for (int i = 1; i <= chords; ++i) {
    length[i] = length[i - 1] +
                lab_distance(sequential_path((i - 1.0) / chords), sequential_path(double(i) / chords));
  }
  const double wanted = fraction * length[chords];
  const auto above = std::upper_bound(length.begin() + 1, length.end() - 1, wanted);
  const auto i = static_cast<int>(above - length.begin());
  return (i - 1 + (wanted - length[i - 1]) / (length[i] - length[i - 1])) / chords;
}

}  // namespace

LabColour to_lab(Colour colour) {
  const double r = decode_gamma(colour.red), g = decode_gamma(colour.green), b = decode_gamma(colour.blue);
  const double fx = compress((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / white_x);
  const double fy = compress(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double fz = compress((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / white_z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Colour to_srgb(LabColour lab) {
  lab.lightness = std::clamp(lab.lightness, 0.0, 100.0);
  double inside = 1;
  if (!in_gamut(linear_rgb(lab))) {
    double outside = 1;
    inside = 0;
    for (int step = 0; step < 30; ++step) {
      const double middle = (inside + outside) / 2;
      (in_gamut(linear_rgb({lab.lightness, middle * lab.a, middle * lab.b})) ? inside : outside) = middle;
    }
  }
  const Colour linear = linear_rgb({lab.lightness, inside * lab.a, inside * lab.b});
  const auto encode = [](double v) { return std::clamp(encode_gamma(std::max(v, 0.0)), 0.0, 1.0); };
  return {encode(linear.red), encode(linear.green), encode(linear.blue)};
}

double colour_distance(Colour one, Colour other) { return lab_distance(to_lab(one), to_lab(other)); }

Colour colour_at(ColourMap map, double position) {
  const double t = std::clamp(position, 0.0, 1.0);
  switch (map) {
    case ColourMap::sequential:
      return to_srgb(sequential_path(sequential_parameter(t)));
    case ColourMap::diverging:
      return to_srgb(diverging_path(t));
    case ColourMap::grey:
      return to_srgb({15 + 78 * t, 0, 0});
  }
  return {};
}

std::vector<Colour> colours(ColourMap map, std::size_t count) {
  assert(count > 0);
  std::vector<Colour> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = colour_at(map, count == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return result;
}

Colour line_colour(std::size_t index) {
  static constexpr std::array<std::array<double, 3>, 8> lightness_chroma_hue{{
      {42, 45, 272},  // blue
      {56, 75, 45},   // vermilion
      {52, 48, 150},  // green
      {38, 58, 315},  // purple
      {68, 70, 80},   // amber
      {60, 36, 215},  // sky
      {42, 62, 8},    // crimson
      {35, 0, 0},     // charcoal
  }};
  const auto [lightness, chroma, hue] = lightness_chroma_hue[index % lightness_chroma_hue.size()];
  return to_srgb(from_polar(lightness, chroma, hue));
}

Colour area_colour(std::size_t index) {
  // Twelve hues in steps of five twelfths of the circle, light and less light in turn; then somewhat darker again.
  static constexpr std::array<double, 2> lightness{89, 77};
  const double darker = 6 * static_cast<double>(index / 12 % 3);
  const double hue = 240 + 150 * static_cast<double>(index % 12);
  return to_srgb(from_polar(lightness[index % 2] - darker, 28, hue));
}

}  // namespace leonhard::draw
