// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace leonhard::draw {

/// A colour in sRGB, each part in [0, 1], as screens and files take it (gamma-encoded).
struct Colour {
  double red{}, green{}, blue{};
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// A colour in CIELAB under the D65 white: `lightness` (L*) in [0, 100], `a` towards red, `b` towards yellow.
/// Distances are near to what the eye sees as differences.
struct LabColour {
  double lightness{}, a{}, b{};
  friend bool operator==(const LabColour&, const LabColour&) = default;
};

/// sRGB (IEC 61966-2-1) to CIELAB (CIE 15) and back. A CIELAB colour that sRGB cannot show is brought in by
/// lowering its chroma at the same lightness and hue.
[[nodiscard]] LabColour to_lab(Colour colour);
[[nodiscard]] Colour to_srgb(LabColour lab);

/// Euclidean distance in CIELAB (CIE76); about 2.3 is just noticeable.
[[nodiscard]] double colour_distance(Colour one, Colour other);

/// A continuous colour map.
///   sequential  dark violet through teal to light yellow; L* rises from 15 to 93, so that a grey print keeps the order
///   diverging   blue through near-white to red; L* alike on both sides, the middle of the range being neutral
///   grey        dark to light grey
enum class ColourMap { sequential, diverging, grey };

/// The colour at `position` in [0, 1] (held to that range). Equal steps of position are equal distances in CIELAB:
/// the maps are formulas in that space, followed by arc length, no tables taken from elsewhere.
[[nodiscard]] Colour colour_at(ColourMap map, double position);

/// `count` >= 1 colours of a map, equally spaced from its first colour to its last.
[[nodiscard]] std::vector<Colour> colours(ColourMap map, std::size_t count);

/// Colours for lines and markers on white, easy to tell apart; the sequence repeats after 8.
[[nodiscard]] Colour line_colour(std::size_t index);

/// Light colours for areas such as parts and regions; any index gives a colour, the first 12 are far apart.
[[nodiscard]] Colour area_colour(std::size_t index);

}  // namespace leonhard::draw
