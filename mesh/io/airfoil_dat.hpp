// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard {

/// An airfoil section as a closed counter-clockwise loop without a repeated last point, in Selig order: from
/// the trailing edge along the upper side to the leading edge and back along the lower side.
///
/// Sharp: points.front() is the trailing edge. Blunt: points.front() is the upper corner of the base and the
/// edge points.back() -> points.front() belongs to the base (it is the whole base unless the base has points
/// of its own).
struct AirfoilCoordinates {
  std::string name{};  ///< the file's first line, or the file's name without extension
  std::vector<Point2> points{};
  bool blunt_trailing_edge = false;
  std::vector<std::string> warnings{};  ///< points merged, columns left out, a thick base
};

namespace io {

/// Read airfoil coordinates from a .dat file, in Selig's order (trailing edge, upper side, leading edge,
/// lower side; a closed curve may start anywhere, either way round) or Lednicer's (point counts, upper and
/// lower side, each from the leading edge), detected by the first line of numbers: two whole numbers
/// above 1.5 to which the last point does not come back are counts, or a name ("0012 64") where they do not fit and the points
/// that follow are in Selig's order; and by the order alone where the counts are left out.
///
/// Up to two lines of words may come before the points. Columns are separated by blanks, commas or semicolons; those behind y
/// are left out, which a warning tells. Numbers may have Fortran's exponents (1.0D+00), lines may end with CR alone. A point
/// that repeats the one before is merged with it, which a warning tells.
///
/// The trailing edge is the end of larger x. An open end there is a blunt base, of whatever thickness; a closed curve's
/// trailing edge is blunt if two corners sharper than 45 degrees lie within 5 % of the chord.
///
/// throws InputError naming file and line: missing or empty file, letters among numbers, NaN, fewer than 5
/// points, counts that do not fit, curve open away from the trailing edge, curve that crosses or touches itself (decided
/// exactly); several elements
[[nodiscard]] AirfoilCoordinates read_airfoil(const std::filesystem::path& path);

/// All elements of a file, which lines "999 999" part (as MSES's files have them).
[[nodiscard]] std::vector<AirfoilCoordinates> read_airfoils(const std::filesystem::path& path);

/// The same from text; source names it in errors.
[[nodiscard]] AirfoilCoordinates parse_airfoil(std::string_view text, const std::string& source);
[[nodiscard]] std::vector<AirfoilCoordinates> parse_airfoils(std::string_view text,
                                                             const std::string& source);

}  // namespace io
}  // namespace leonhard
