// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_topology.hpp"

#include <cstddef>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/tet_invariants.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/half_faces.hpp"

namespace leonhard::mesh {
namespace {

void refuse(const std::optional<std::string>& problem, const std::string& source, const char* remedy) {
  if (problem) throw InputError(source, *problem, remedy);
}

constexpr const char* correct_cells = "correct the list of tetrahedra";

/// Moves faces that are no boundary faces but lie between two tetrahedra to the interfaces.
void take_interfaces(TetMesh& mesh, const BoundaryFaces& boundary, const HalfFaceTable& table) {
  std::vector<MarkedFace> rest;
  rest.reserve(mesh.boundary.size());
  for (const MarkedFace& face : mesh.boundary) {
    const auto ascending = sorted_face(face.corners).corners;
    const bool is_interface = !boundary.find(ascending) && table.find(ascending).size() == 2;
    (is_interface ? mesh.interfaces : rest).push_back(face);
  }
  mesh.boundary = std::move(rest);
}

/// Turns listed boundary faces outwards; those that are no boundary faces stay as they are.
/// returns  which of boundary.faces() are listed
std::vector<bool> turn_outwards(std::vector<MarkedFace>& faces, const BoundaryFaces& boundary) {
  std::vector<bool> listed(boundary.faces().size(), false);
  for (MarkedFace& face : faces) {
    const SortedFace sorted = sorted_face(face.corners);
    const auto at = boundary.find(sorted.corners);
    if (!at) continue;
    listed[*at] = true;
    if (boundary.faces()[*at].sorted.even != sorted.even) std::swap(face.corners[1], face.corners[2]);
  }
  return listed;
}

void add_unlisted(TetMesh& mesh, const BoundaryFaces& boundary, const std::vector<bool>& listed,
                  Marker marker) {
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (!listed[i]) mesh.boundary.push_back({boundary.faces()[i].sorted.directed(), marker});
  }
}

}  // namespace

void build_neighbours(TetMesh& mesh) {
  refuse(broken_corner(mesh), "", correct_cells);
  const HalfFaceTable table = half_face_table(mesh);
  refuse(broken_face(mesh, table), "", correct_cells);
  mesh.neighbours = neighbours_of(mesh, table);
}

std::vector<MarkedFace> boundary_faces(const TetMesh& mesh, Marker marker) {
  require_ids_in_range(mesh);
  const BoundaryFaces boundary(mesh);
  std::vector<MarkedFace> faces;
  faces.reserve(boundary.faces().size());
  for (const auto& face : boundary.faces()) faces.push_back({face.sorted.directed(), marker});
  return faces;
}

TetMesh make_tet_mesh(PerId<VertexId, Point3> points, PerId<TetId, std::array<VertexId, 4>> corners,
                      std::vector<MarkedFace> faces, std::map<Marker, std::string> names, std::string source,
                      const MarkedFaceRules& rules) {
  TetMesh mesh;
  mesh.points = std::move(points);
  mesh.corners = std::move(corners);
  mesh.boundary = std::move(faces);
  mesh.marker_names = std::move(names);
  mesh.vertex_markers.resize(mesh.vertex_count(), 0);
  mesh.regions.resize(mesh.tet_count(), 0.0);

  refuse(broken_point(mesh), source, "correct its coordinates");
  refuse(broken_corner(mesh), source, "correct the tetrahedron's vertices");
  refuse(unused_vertex(mesh), source, "remove the vertex or restore the tetrahedra about it");
  refuse(broken_orientation(mesh), source,
         "list its vertices so that the fourth lies where the first three turn counter-clockwise, or move "
         "one so that "
         "it has a volume");
  const HalfFaceTable table = half_face_table(mesh);
  refuse(broken_face(mesh, table), source, correct_cells);
  mesh.neighbours = neighbours_of(mesh, table);

  const BoundaryFaces boundary(mesh);
  if (rules.take_interfaces) take_interfaces(mesh, boundary, table);
  const std::vector<bool> listed = turn_outwards(mesh.boundary, boundary);
  if (rules.unlisted_boundary) add_unlisted(mesh, boundary, listed, *rules.unlisted_boundary);
  refuse(broken_boundary(mesh, boundary), source,
         "every boundary face needs exactly one marker; if the face should not be on the boundary, a "
         "tetrahedron is "
         "missing or two vertices stand for one");
  return mesh;
}

}  // namespace leonhard::mesh
