// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/mesh/draw/canvas/canvas.hpp"
#include "leonhard/mesh/draw/space/tet_scene.hpp"

namespace leonhard::draw {

/// How facets become colours.
struct FacetPaint {
  std::span<const Colour> colours;  ///< Facet::colour is an index of these
  std::span<const double>
      levels;  ///< of the field; if any, colour i is for values with i levels at or below them
  Colour line;
  double thin = 1;  ///< Canvas::thin()
  bool show_lines = true;
  bool is_perspective = false;
};

/// Facets as pixels, the nearest in front: a z-buffer with several samples a pixel, averaged at the end. Lines belong to
/// the facets whose edges they are (J. A. Baerentzen, S. L. Nielsen, M. Gjoel and B. D. Larsen, Computers & Graphics 32
/// (2008): wireframe by distance), so that what hides a facet hides its lines and nothing shines through.
class DepthRaster {
 public:
  /// area  of the page; dots  image pixels a page pixel
  DepthRaster(const Rect& area, double dots);

  void fill(const Facet& facet, const FacetPaint& paint);

  /// The picture, transparent where there is no facet.
  [[nodiscard]] Raster resolve() const;

 private:
  int width_, height_, samples_;  ///< of the image; samples a pixel in each direction
  Point2 origin_;
  double per_page_;                    ///< samples a page pixel
  std::vector<float> nearness_;        ///< one a sample, of the nearest facet so far
  std::vector<std::uint32_t> colour_;  ///< 0xFFRRGGBB, 0 where there is none
};

}  // namespace leonhard::draw
