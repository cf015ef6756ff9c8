// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::delaunay {

/// What becomes of segments that cross at a point in which neither ends.
enum class Crossings {
  reject,  ///< an InputError that lists all of them
  split,   ///< each crossing becomes a point, rounded to doubles, and both segments pass through it
  skip     ///< of two segments that cross the later one is left out, unless it crosses only such as are left out
};

/// As users name them.
inline constexpr std::array<std::pair<std::string_view, Crossings>, 3> named_crossings{
    {{"split", Crossings::split}, {"reject", Crossings::reject}, {"skip", Crossings::skip}}};

/// A crossing of two segments.
struct Crossing {
  std::size_t one, other;  ///< indices into Pslg::segments, one < other
  Point2 point;            ///< nearest to the crossing
  double error;            ///< of each coordinate at most, a bound
};

/// All pairs of segments that cross at a point in which neither ends, exactly, in ascending order. A segment that ends on
/// another one, or overlaps it, does not cross it.
///
/// throws  InputError if a segment's end is no point or a coordinate is not finite
/// Cost O(n log n) and the pairs of segments whose boxes along the axes meet.
[[nodiscard]] std::vector<Crossing> find_crossings(const Pslg& pslg, const Progress& progress = {});

}  // namespace leonhard::delaunay
