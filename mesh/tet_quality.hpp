// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

/// Figures of one tetrahedron.
struct TetQuality {
  double min_dihedral_deg{}, max_dihedral_deg{};  ///< angles between faces, degrees
  double volume{};                                ///< unit of the coordinates, cubed
  double shortest_edge{}, longest_edge{};         ///< unit of the coordinates
  double aspect_ratio{};       ///< circumradius / (3 inradius): 1 for the regular one, infinite for the flat
  double radius_edge_ratio{};  ///< circumradius / shortest edge: sqrt(6)/4 for the regular one
};

/// Figures of a mesh's tetrahedra. Of a mesh without any all are 0 and the lists empty.
struct TetMeshQuality {
  struct Named {
    TetId tet;
    Point3 centroid;
    TetQuality figures;
  };

  double min_dihedral_deg{}, max_dihedral_deg{};  ///< over all edges of all tetrahedra, degrees
  double mean_min_dihedral_deg{};                 ///< mean over tetrahedra of their smallest angle, degrees
  std::array<std::size_t, 18>
      dihedral_histogram{};  ///< angles in [10 i, 10 i + 10) degrees, six a tetrahedron
  std::vector<Named> worst;  ///< tetrahedra of smallest angle, the smallest first
  double min_volume{}, max_volume{}, mean_volume{}, total_volume{};
  double shortest_edge{}, longest_edge{};
  double max_aspect_ratio{};       ///< circumradius / (3 inradius), 1 for the regular one
  double max_radius_edge_ratio{};  ///< circumradius / shortest edge
  /// Largest ratio >= 1 of the cube roots of the volumes of two tetrahedra that share a face: how fast the edge length
  /// grows. 1 where no two share one.
  double max_size_growth{};
  std::array<MaybeId<TetId>, 2> fastest_growth;  ///< smaller and larger tetrahedron of that pair
};

namespace mesh {

/// Figures of the positive tetrahedron abcd. Coordinates are scaled first, so that no finite one overflows or underflows
/// on the way to an angle or a ratio (a volume may). Where it is flat the differences and products are made in
/// double-double arithmetic, so that slivers down to 1e-15 of the cube of their edges keep all their digits, and thinner
/// ones some. Good for ratios of edges up to 1e100.
///
/// Formulas, with the outward face normals n_i (twice the areas) and D = 6 volume: the angle at edge ij, which lies on
/// the faces opposite k and l, is atan2(|ij| D, -n_k . n_l); the inradius is D / (|n_0| + .. + |n_3|), the circumradius
/// | |u|^2 v x w + |v|^2 w x u + |w|^2 u x v | / (2 D) with the edges u, v, w from a.
[[nodiscard]] TetQuality tet_quality(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Quality figures of a mesh with neighbours.
///
/// worst_count  how many tetrahedra to name in `worst` (ties go to the smaller id)
/// throws       InputError as quality of triangles does
/// Cost O(tetrahedra), some tenths of a microsecond each.
[[nodiscard]] TetMeshQuality quality(const TetMesh& mesh, std::size_t worst_count = 5);

}  // namespace mesh
}  // namespace leonhard
