// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/structures/half_faces.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

/// The invariants of TetMesh one by one, each in words for the first place where it is broken. `validate` and
/// `make_tet_mesh` ask the same ones. A function may rely on those declared before it.
namespace leonhard::mesh {

/// One entry per vertex or tetrahedron in each array that has to have one.
[[nodiscard]] std::optional<std::string> broken_sizes(const TetMesh& mesh);

/// Every coordinate is finite.
[[nodiscard]] std::optional<std::string> broken_point(const TetMesh& mesh);

/// Every corner is a vertex, no tetrahedron names one twice.
[[nodiscard]] std::optional<std::string> broken_corner(const TetMesh& mesh);

/// Every vertex has a tetrahedron.
[[nodiscard]] std::optional<std::string> unused_vertex(const TetMesh& mesh);

/// Every tetrahedron is positive, by exact orient3d.
[[nodiscard]] std::optional<std::string> broken_orientation(const TetMesh& mesh);

/// mesh.neighbours says what the table of half-faces says.
[[nodiscard]] std::optional<std::string> broken_neighbour(const TetMesh& mesh, const HalfFaceTable& table);

/// The faces of mesh.neighbours without a tetrahedron behind, each with the mesh on the inside.
class BoundaryFaces {
 public:
  struct Face {
    SortedFace sorted;  ///< counter-clockwise from outside, if directed
    TetId tet;
    std::uint8_t side;  ///< opposite corners[tet][side]
  };
  explicit BoundaryFaces(const TetMesh& mesh);

  /// Sorted by their vertices in ascending order.
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  /// Index in faces() of the face with these vertices, ascending. Cost O(log boundary).
  [[nodiscard]] std::optional<std::size_t> find(const std::array<VertexId, 3>& ascending) const;

 private:
  std::vector<Face> faces_;
};

/// mesh.boundary has each boundary face once, its normal pointing outwards.
[[nodiscard]] std::optional<std::string> broken_boundary(const TetMesh& mesh, const BoundaryFaces& faces);

/// mesh.interfaces has faces between two tetrahedra only.
[[nodiscard]] std::optional<std::string> broken_interface(const TetMesh& mesh, const HalfFaceTable& table);

}  // namespace leonhard::mesh
