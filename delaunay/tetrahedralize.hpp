// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/delaunay/tet_algorithm.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {

struct TetrahedralizeOptions {
  Progress progress{};
  TetAlgorithm algorithm = TetAlgorithm::insertion;  ///< the mesh does not depend on it
  unsigned threads = 1;    ///< 0: as many as there are cores; the mesh does not depend on it
  std::uint64_t seed = 1;  ///< of the random part of the insertion order; the mesh does not depend on it
  /// Number the tetrahedra by their vertices, so that the mesh is the same to the last bit for any algorithm, seed and
  /// number of threads. Otherwise they come as they were made, a fifth faster: the same set.
  bool sorted = true;
  /// Refuse, before any work, point sets for which more memory than this is to be expected; 0: no limit.
  std::size_t memory_limit_bytes = 0;
};

struct [[nodiscard]] Tetrahedralization {
  TetrahedralizeOutcome outcome = TetrahedralizeOutcome::done;
  TetMesh mesh;
  /// One an input point: its vertex. Duplicates share one. None unless done.
  std::vector<MaybeId<VertexId>> vertex_of_input;
  /// What was mended, in words: merged points. Empty: nothing.
  std::vector<std::string> repairs;
};

/// The Delaunay tetrahedralisation of points, the whole convex hull filled.
///
/// It depends on the coordinates alone: cospherical ties are broken by kernel::insphere_perturbed, so any order of the
/// input, any algorithm, seed and number of threads gives the same set of tetrahedra, regular grids included. The same
/// points in the same order give the same mesh to the last bit (TetrahedralizeOptions::sorted).
///
/// points   any number, any order, duplicates welcome (they are merged); they become the mesh's
/// returns  vertices numbered in the order of the input points that made them; boundary faces with marker 1
/// throws   InputError: a coordinate that is not finite; more points than ids can number; a memory limit too low
/// Cost O(n) to O(n log n) for points that fill space, O(n^2) where the result is that large (two skew lines).
/// Memory: see expected_bytes.
/// Method: A. Bowyer and D. F. Watson, The Computer Journal 24 (1981); order: Amenta, Choi and Rote (2003);
/// perturbation: Devillers and Teillaud (2011).
Tetrahedralization tetrahedralize(std::vector<Point3> points, const TetrahedralizeOptions& options = {});

/// The memory that tetrahedralize needs at its peak beyond the points themselves, in bytes, for points that fill space
/// (6.8 tetrahedra a point). Points on surfaces need about as much; there are sets that need O(n^2).
[[nodiscard]] std::size_t expected_bytes(std::size_t points);

}  // namespace leonhard::delaunay
