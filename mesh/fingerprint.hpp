// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// A 128-bit name for a mesh as a set of cells.
struct Fingerprint {
  std::uint64_t hi{}, lo{};
  /// 32 hexadecimal digits, hi first, lower case.
  [[nodiscard]] std::string hex() const;
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

namespace mesh {

/// The mesh's fingerprint: each cell is hashed from the sorted bit patterns of its corners'
/// coordinates (-0 taken as 0), the hashes are sorted and hashed in that order. So the numbering of vertices and cells
/// and the order of a cell's corners do not enter; neither do markers, names and neighbours. Not a defence against someone
/// who constructs collisions. throws InputError on a corner that is no vertex. Cost O(cells log cells).
[[nodiscard]] Fingerprint fingerprint(const TriangleMesh& mesh);
[[nodiscard]] Fingerprint fingerprint(const TetMesh& mesh);
[[nodiscard]] Fingerprint fingerprint(const MixedMesh<2>& mesh);
[[nodiscard]] Fingerprint fingerprint(const MixedMesh<3>& mesh);

}  // namespace mesh
}  // namespace leonhard
