// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_data_structures.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/structures/sorted_facet.hpp"
#include "leonhard/mesh/topology.hpp"

namespace leonhard::mesh {
namespace {

constexpr const char* number_them = "number tetrahedra without gaps and give each of them four faces";

/// The faces of one tetrahedron.
struct TetSides {
  std::array<SortedFacet<3>, 4> sides;  ///< directed outwards
  std::size_t count = 0;                ///< may exceed four in a bad structure

  void add(const SortedFacet<3>& face) {
    if (count < 4) sides[count] = face;
    ++count;
  }
  /// The four corners, so that the sides are those of tet_face_corners; none if they are not.
  [[nodiscard]] std::optional<std::array<VertexId, 4>> corners() {
    if (count != 4) return std::nullopt;
    const auto by_corners = [](const SortedFacet<3>& f, const SortedFacet<3>& g) {
      return f.corners < g.corners;
    };
    std::sort(sides.begin(), sides.end(), by_corners);
    const auto& [a, b, c] = sides[0].corners;
    std::array tet{a, b, c, sides[1].corners[2]};
    // The face opposite corner 3 is 0, 2, 1: odd, unless the last two are to change places.
    if (sides[0].even) std::swap(tet[2], tet[3]);
    std::array<SortedFacet<3>, 4> expected;
    for (std::size_t i = 0; i < 4; ++i) expected[i] = sorted_facet(outward_facet(tet, i));
    std::sort(expected.begin(), expected.end(), by_corners);
    const auto same = [](const SortedFacet<3>& f, const SortedFacet<3>& g) {
      return f.corners == g.corners && f.even == g.even;
    };
    if (!std::equal(sides.begin(), sides.end(), expected.begin(), same)) return std::nullopt;
    return tet;
  }
};

PerId<TetId, TetSides> sides_by_tet(const FaceStructure& faces) {
  PerId<TetId, TetSides> tets;
  for (const FaceId f : faces.corners.ids()) {
    for (const std::size_t side : {0, 1}) {
      const MaybeId<TetId> t = faces.sides[f][side];
      if (!t) continue;
      if ((*t).index() >= 2 * faces.face_count())
        throw InputError("faces", "tetrahedron " + std::to_string((*t).raw) + " is one of too many",
                         number_them);
      if (!tets.contains(*t)) tets.resize((*t).index() + 1);
      tets[*t].add({faces.corners[f], side == 0});
    }
  }
  return tets;
}

}  // namespace

TetMesh tet_mesh(const FaceStructure& faces, const PerId<VertexId, Point3>& points, Marker marker) {
  PerId<TetId, TetSides> tets = sides_by_tet(faces);
  PerId<TetId, std::array<VertexId, 4>> corners;
  corners.reserve(tets.size());
  for (const TetId t : tets.ids()) {
    const auto abcd = tets[t].corners();
    if (!abcd) {
      throw InputError(
          "faces", "the sides of tetrahedron " + std::to_string(t.raw) + " are not the four of four vertices",
          number_them);
    }
    corners.push_back(*abcd);
  }
  std::vector<MarkedFace> boundary;
  for (const FaceId f : faces.corners.ids()) {
    if (faces.is_boundary(f)) boundary.push_back({faces.corners[f], marker});
  }
  return make_tet_mesh(points, std::move(corners), std::move(boundary), {}, "faces");
}

}  // namespace leonhard::mesh
