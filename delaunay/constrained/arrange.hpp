// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/delaunay/crossings.hpp"
#include "leonhard/delaunay/input_segments.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::delaunay {

/// A graph without crossings made from one that has some.
struct Arrangement {
  Pslg graph;                         ///< the input's points come first, those of crossings after them
  std::vector<SegmentId> segment_of;  ///< one a segment of graph: the input's, of which it is a part
  std::vector<Crossing> crossings;    ///< points that were added, by input segments, each place once for each pair
  std::vector<SegmentId> skipped;     ///< segments left out
};

/// Crossings become points. A rounded point bends the segments through it, which can make new crossings, of pieces: these are
/// split in turn until none is left. No point of the input moves; a piece is farther from its segment than the errors of the
/// crossings on it only by those of the rounds before, of which there is one as a rule.
///
/// throws  InputError if there are more than five million crossings, or, naming two segments, if more rounds are needed than
///         were ever seen
/// The points do not depend on the order of the segments.
/// Method: boxes in a tree, signs by orient2d, the order of the crossings along a segment by their unrounded coordinates.
[[nodiscard]] Arrangement split_crossings(const Pslg& pslg, const Progress& progress);

/// Segments are left out, the later of each two that cross, until none crosses.
[[nodiscard]] Arrangement skip_crossings(const Pslg& pslg, const Progress& progress);

/// throws  InputError that lists all crossings, a hundred with their places
[[noreturn]] void refuse_crossings(const Pslg& pslg, const Progress& progress);

/// Says in words what was done.
void note_crossings(const Arrangement& arrangement, std::vector<std::string>& repairs);

}  // namespace leonhard::delaunay
