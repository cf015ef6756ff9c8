// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// Figures of one triangle.
struct TriangleQuality {
  double min_angle_deg{}, max_angle_deg{};  ///< degrees
  double area{};                            ///< unit of the coordinates, squared
  double aspect_ratio{};       ///< circumradius / (2 inradius): 1 for the equilateral, infinite for the flat
  double radius_edge_ratio{};  ///< circumradius / shortest edge: 1/sqrt(3) for the equilateral
};

/// Figures of a mesh's triangles. Of a mesh without triangles all are 0 and the lists empty.
struct MeshQuality {
  struct Named {
    TriangleId triangle;
    Point2 centroid;
    TriangleQuality figures;
  };

  double min_angle_deg{}, max_angle_deg{};        ///< over all corners, degrees
  double mean_min_angle_deg{};                    ///< mean over triangles of their smallest angle, degrees
  std::array<std::size_t, 18> angle_histogram{};  ///< corners with angle in [10 i, 10 i + 10) degrees
  std::vector<Named> worst;                       ///< triangles of smallest angle, the smallest first
  double min_area{}, max_area{}, mean_area{}, total_area{};
  double max_aspect_ratio{};       ///< circumradius / (2 inradius), 1 for the equilateral
  double max_radius_edge_ratio{};  ///< circumradius / shortest edge
  /// Largest ratio >= 1 of the square roots of the areas of two triangles that share an edge: how fast the
  /// edge length grows. 1 where no two triangles share one.
  double max_size_growth{};
  std::array<MaybeId<TriangleId>, 2> fastest_growth;  ///< smaller and larger triangle of that pair
};

namespace mesh {

/// Figures of the triangle abc, counter-clockwise. Angles are atan2 of cross and dot product, so that small
/// and flat ones keep their digits; coordinates are scaled first, so that no finite triangle overflows or
/// underflows on the way to an angle or a ratio (an area may).
[[nodiscard]] TriangleQuality triangle_quality(Point2 a, Point2 b, Point2 c);

/// Quality figures of a mesh with neighbours.
///
/// worst_count  how many triangles to name in `worst` (ties go to the smaller id)
/// throws       InputError for an id out of range or an array of the wrong size (require_ids_in_range). Figures of triangles
///              that are flat or turned round, or have NaN coordinates, mean nothing
/// Cost O(triangles).
[[nodiscard]] MeshQuality quality(const TriangleMesh& mesh, std::size_t worst_count = 5);

}  // namespace mesh
}  // namespace leonhard
