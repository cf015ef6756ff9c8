// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "leonhard/app/case/case.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::app {

/// Around `at`, edges should be `spacing` long: what delaunay::GradedSizing is built from.
struct SizeSource {
  Point2 at;
  double spacing{};
};

/// The domain of a case, ready for the mesher.
struct DomainGeometry {
  Pslg pslg;                        ///< markers 1..n: the bodies in order; n + 1: "farfield"; names in it
  std::vector<SizeSource> sources;  ///< one a boundary point of the bodies; empty: max_size alone
  double growth = 0;                ///< of the size with the distance to a source
  double max_size = std::numeric_limits<double>::infinity();  ///< of an edge, anywhere
  bool keep_convex_hull = false;                              ///< nothing outside the segments is carved away

  std::vector<std::string> warnings;  ///< what the readers of the bodies' files mended or left out
  std::vector<std::string> body_names;        ///< body i has marker i + 1
  std::vector<std::vector<Point2>> outlines;  ///< of each body, counter-clockwise, as in pslg
  Point2 centre;                              ///< of the far field and of the bodies' box
  double body_extent = 0;                     ///< largest side of the bodies' box
};

/// Bodies and far field, or the domain file, of a case.
///
/// A domain's coordinates are those of its file. Of bodies and their far field, whose points are chosen here, every coordinate is a multiple of a power of two (2^-36 of the size of the bodies), a change below 1e-11
/// of the chord. That leaves spare bits in each double, so that the midpoints at which the mesher splits a
/// segment lie on it exactly, as do the midpoints of the halves, and so on: the mesh's area equals the
/// polygon's in exact arithmetic.
///
/// throws InputError naming the body and the coordinates: too few points, NaN, a point given twice, an
/// outline
///        that crosses itself, bodies that overlap or touch, a body outside the far field, a far field
///        smaller than the body. All by exact predicates.
[[nodiscard]] DomainGeometry make_domain(const Case&);

/// The same of a domain that has been read; the case's domain_file names it in errors.
[[nodiscard]] DomainGeometry make_domain(const Case&, Pslg);

/// Give the markers of a domain file's segments the names of their [boundary.N] sections.
///
/// throws  InputError on a marker without a condition and on a condition without a marker: early, before any meshing
void name_markers(const Case&, Pslg&);

}  // namespace leonhard::app
