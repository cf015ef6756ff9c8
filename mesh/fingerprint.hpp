// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// A 128-bit name for a mesh as a set of triangles.
struct Fingerprint {
  std::uint64_t hi{}, lo{};
  /// 32 hexadecimal digits, hi first, lower case.
  [[nodiscard]] std::string hex() const;
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

namespace mesh {

/// The mesh's fingerprint: each triangle is hashed from the sorted bit patterns of its corners' coordinates
/// (-0 taken as 0), the hashes are sorted and hashed in that order. So the numbering of
/// vertices and triangles and the corner a triangle starts with do not enter; neither do markers, names and
/// neighbours. Not a defence against someone who constructs collisions. Cost O(triangles log triangles).
[[nodiscard]] Fingerprint fingerprint(const TriangleMesh& mesh);

}  // namespace mesh
}  // namespace leonhard
