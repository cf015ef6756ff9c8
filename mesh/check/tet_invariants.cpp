// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/tet_invariants.hpp"

#include <algorithm>

#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/check/invariants_impl.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

std::string neighbour_words(MaybeId<TetId> t) {
  return t ? "tetrahedron " + std::to_string((*t).raw) : std::string("none");
}

std::string entry_words(const TetMesh& mesh, const char* array, std::size_t entry, const MarkedFace& face) {
  return std::string(array) + " entry " + std::to_string(entry) + ", " + words(mesh, face.corners) +
         ", marker " + std::to_string(face.marker) + ",";
}

}  // namespace

std::optional<std::string> broken_sizes(const TetMesh& mesh) {
  return detail::broken_sizes(mesh, "tetrahedra");
}

std::optional<std::string> broken_point(const TetMesh& mesh) { return detail::broken_point(mesh); }

std::optional<std::string> broken_corner(const TetMesh& mesh) { return detail::broken_corner(mesh); }

std::optional<std::string> unused_vertex(const TetMesh& mesh) {
  return detail::unused_vertex(mesh, "tetrahedron");
}

std::optional<std::string> broken_orientation(const TetMesh& mesh) {
  for (const TetId t : mesh.corners.ids()) {
    const auto& [a, b, c, d] = mesh.corners[t];
    const Sign side = kernel::orient3d(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
    if (side == Sign::zero) return words(mesh, t) + " has volume zero";
    if (side == Sign::negative) return words(mesh, t) + " is turned over: its volume is negative";
  }
  return std::nullopt;
}

std::optional<std::string> broken_neighbour(const TetMesh& mesh, const HalfFaceTable& table) {
  const auto truth = neighbours_of(mesh, table);
  for (const TetId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (mesh.neighbours[t][i] == truth[t][i]) continue;
      return words(mesh, t) + " names " + neighbour_words(mesh.neighbours[t][i]) + " as neighbour " +
             std::to_string(i) + ", but behind " + words(mesh, outward_face(mesh.corners[t], i)) +
             " there is " + neighbour_words(truth[t][i]);
    }
  }
  return std::nullopt;
}

BoundaryFaces::BoundaryFaces(const TetMesh& mesh) {
  for (const TetId t : mesh.neighbours.ids()) {
    for (std::uint8_t side = 0; side < 4; ++side) {
      if (!mesh.neighbours[t][side])
        faces_.push_back({sorted_face(outward_face(mesh.corners[t], side)), t, side});
    }
  }
  std::sort(faces_.begin(), faces_.end(),
            [](const Face& a, const Face& b) { return a.sorted.corners < b.sorted.corners; });
}

std::optional<std::size_t> BoundaryFaces::find(const std::array<VertexId, 3>& ascending) const {
  const auto at = std::partition_point(faces_.begin(), faces_.end(),
                                       [&](const Face& f) { return f.sorted.corners < ascending; });
  if (at == faces_.end() || at->sorted.corners != ascending) return std::nullopt;
  return static_cast<std::size_t>(at - faces_.begin());
}

std::optional<std::string> broken_boundary(const TetMesh& mesh, const BoundaryFaces& faces) {
  constexpr std::size_t never = static_cast<std::size_t>(-1);
  std::vector<std::size_t> listed_as(faces.faces().size(), never);
  for (std::size_t entry = 0; entry < mesh.boundary.size(); ++entry) {
    const MarkedFace& face = mesh.boundary[entry];
    const SortedFace sorted = sorted_face(face.corners);
    const auto at = faces.find(sorted.corners);
    if (!at) return entry_words(mesh, "boundary", entry, face) + " is no boundary face of the mesh";
    if (faces.faces()[*at].sorted.even != sorted.even)
      return entry_words(mesh, "boundary", entry, face) + " has a normal that points into the mesh";
    if (listed_as[*at] != never) {
      return entry_words(mesh, "boundary", entry, face) + " is there already as entry " +
             std::to_string(listed_as[*at]);
    }
    listed_as[*at] = entry;
  }
  const auto missing = std::find(listed_as.begin(), listed_as.end(), never);
  if (missing == listed_as.end()) return std::nullopt;
  const auto& face = faces.faces()[static_cast<std::size_t>(missing - listed_as.begin())];
  return "boundary " + words(mesh, face.sorted.directed()) + " of tetrahedron " +
         std::to_string(face.tet.raw) + " has no marker";
}

std::optional<std::string> broken_interface(const TetMesh& mesh, const HalfFaceTable& table) {
  for (std::size_t entry = 0; entry < mesh.interfaces.size(); ++entry) {
    const MarkedFace& face = mesh.interfaces[entry];
    if (table.find(sorted_face(face.corners).corners).size() != 2) {
      return entry_words(mesh, "interfaces", entry, face) + " does not lie between two tetrahedra";
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::mesh
