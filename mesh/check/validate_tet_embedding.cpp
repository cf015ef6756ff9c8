// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/box_tree.hpp"
#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/check/triangle_contact.hpp"
#include "leonhard/mesh/disjoint_sets.hpp"
#include "leonhard/mesh/structures/boundary_sides.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

template <std::size_t N>
std::array<Point3, N> places(const TetMesh& mesh, const std::array<VertexId, N>& corners) {
  std::array<Point3, N> p;
  std::transform(corners.begin(), corners.end(), p.begin(), [&](VertexId v) { return mesh.points[v]; });
  return p;
}

template <std::size_t N>
Box3 box_of(const std::array<Point3, N>& p) {
  Box3 box;
  for (const Point3& q : p) box.include(q);
  return box;
}

/// Two boundary faces that cross or touch, in words.
std::optional<std::string> faces_in_contact(const TetMesh& mesh) {
  std::vector<Point3> first_corners;
  first_corners.reserve(mesh.boundary.size());
  for (const MarkedFace& face : mesh.boundary) first_corners.push_back(mesh.points[face.corners[0]]);
  const auto order = kernel::hilbert_order(first_corners);
  std::vector<Box3> boxes;
  boxes.reserve(order.size());
  for (const auto f : order) boxes.push_back(box_of(places(mesh, mesh.boundary[f].corners)));

  std::optional<std::string> problem;
  BoxTree(boxes).for_each_meeting_pair_until([&](std::size_t i, std::size_t j) {
    const auto& p = mesh.boundary[order[i]].corners;
    const auto& q = mesh.boundary[order[j]].corners;
    if (!in_contact(places(mesh, p), places(mesh, q))) return false;
    problem = "boundary " + words(mesh, p) + " and boundary " + words(mesh, q) +
              " cross or touch elsewhere than in common corners and edges";
    return true;
  });
  return problem;
}

/// Classes of boundary faces joined across edges that two faces have.
DisjointSets patches_of(const TetMesh& mesh) {
  DisjointSets patches(mesh.boundary.size());
  const auto sides = boundary_sides(mesh);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
      ++end;
    if (end - begin == 2) patches.join(sides[begin].face, sides[begin + 1].face);
  }
  return patches;
}

/// A place just inside a boundary face: from the corner a of its tetrahedron infinitesimally towards b, infinitesimally
/// less towards c, and less again towards d, abc being the face.
struct InnerPlace {
  std::array<Point3, 4> abcd;
  VertexId a;
  TetId tet;
};

/// One place for each patch of the boundary.
std::vector<InnerPlace> inner_places(const TetMesh& mesh) {
  DisjointSets patches = patches_of(mesh);
  const BoundaryFacets<3> faces(mesh);
  std::vector<InnerPlace> result;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (patches.find(f) != f) continue;
    const auto& [a, b, c] = mesh.boundary[f].corners;
    const auto& face = faces.facets()[*faces.find(sorted_facet(std::array{a, b, c}).corners)];
    const VertexId d = mesh.corners[face.cell][face.side];
    result.push_back({places(mesh, std::array{a, b, c, d}), a, face.cell});
  }
  return result;
}

/// Does the tetrahedron hold the place? The side of a face on which it lies is that of the first of a, b, c, d that is
/// not in the face's plane.
bool holds(const std::array<Point3, 4>& tet, const InnerPlace& place) {
  return std::all_of(tet_face_corners.begin(), tet_face_corners.end(), [&](const auto& face) {
    for (const Point3& p : place.abcd) {
      const Sign side = kernel::orient3d(tet[face[0]], tet[face[1]], tet[face[2]], p);
      if (side != Sign::zero) return side == Sign::negative;
    }
    return false;  // not reached: a, b, c, d lie in no one plane
  });
}

/// Two tetrahedra that hold a place just inside the boundary, in words.
std::optional<std::string> covered_twice(const TetMesh& mesh) {
  std::vector<InnerPlace> inner = inner_places(mesh);
  std::vector<Point3> corners;
  for (const InnerPlace& place : inner) corners.push_back(place.abcd[0]);
  std::vector<InnerPlace> ordered;
  std::vector<Box3> boxes;
  for (const auto i : kernel::hilbert_order(corners)) {
    ordered.push_back(inner[i]);
    boxes.push_back({corners[i], corners[i]});
  }
  const BoxTree tree(boxes);
  std::optional<std::string> problem;
  for (const TetId t : mesh.corners.ids()) {
    const auto p = places(mesh, mesh.corners[t]);
    tree.for_each_meeting(box_of(p), [&](std::size_t i) {
      const InnerPlace& place = ordered[i];
      if (problem || place.tet == t || !holds(p, place)) return;
      problem = words(mesh, t) + " and " + words(mesh, place.tet) + " overlap near " + words(mesh, place.a);
    });
    if (problem) break;
  }
  return problem;
}

}  // namespace

std::optional<std::string> validate_embedding(const TetMesh& mesh) {
  if (auto problem = faces_in_contact(mesh)) return problem;
  return covered_twice(mesh);
}

}  // namespace leonhard::mesh
