// SPDX-License-Identifier: MIT
#include "leonhard/mesh/words.hpp"

#include <array>
#include <charconv>

namespace leonhard::mesh {
namespace {

/// "(0, 0), (1, 0)".
template <class Mesh, class Corners>
std::string place_words(const Mesh& mesh, const Corners& corners) {
  std::string places;
  for (const VertexId v : corners) {
    if (!places.empty()) places += ", ";
    places += mesh.points.contains(v) ? words(mesh.points[v]) : std::string("no such vertex");
  }
  return places;
}

template <class Corners>
std::string id_words(const Corners& corners, const char* between) {
  std::string ids;
  for (const VertexId v : corners) {
    if (!ids.empty()) ids += between;
    ids += std::to_string(v.raw);
  }
  return ids;
}

template <class Mesh>
std::string vertex_words(const Mesh& mesh, VertexId v) {
  std::string text = "vertex " + std::to_string(v.raw);
  if (mesh.points.contains(v)) text += " at " + words(mesh.points[v]);
  return text;
}

template <class Mesh>
std::string edge_words(const Mesh& mesh, VertexId from, VertexId to) {
  std::string text = "edge " + std::to_string(from.raw) + "-" + std::to_string(to.raw);
  if (mesh.points.contains(from) && mesh.points.contains(to)) {
    text += " from " + words(mesh.points[from]) + " to " + words(mesh.points[to]);
  }
  return text;
}

template <class Mesh, class Corners>
std::string face_words(const Mesh& mesh, const Corners& corners) {
  return "face " + id_words(corners, "-") + " at " + place_words(mesh, corners);
}

template <class Mesh, class Corners>
std::string cell_words(const char* kind, IdRaw number, const Mesh& mesh, const Corners& corners) {
  return kind + (" " + std::to_string(number)) + " (vertices " + id_words(corners, ", ") + " at " +
         place_words(mesh, corners) + ")";
}

}  // namespace

std::string words(double value) {
  std::array<char, 32> text{};  // the longest shortest form, -2.2250738585072014e-308, has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string words(Point2 p) { return "(" + words(p.x) + ", " + words(p.y) + ")"; }
std::string words(const Point3& p) { return "(" + words(p.x) + ", " + words(p.y) + ", " + words(p.z) + ")"; }

template <int Dim>
std::string words(const SimplexMesh<Dim>& mesh, VertexId v) {
  return vertex_words(mesh, v);
}

template <int Dim>
std::string words(const SimplexMesh<Dim>& mesh, VertexId from, VertexId to) {
  return edge_words(mesh, from, to);
}

template <int Dim>
std::string words(const SimplexMesh<Dim>& mesh, const typename SimplexMesh<Dim>::FacetCorners& facet) {
  if constexpr (Dim == 2) return words(mesh, facet[0], facet[1]);
  return face_words(mesh, facet);
}

template <int Dim>
std::string words(const SimplexMesh<Dim>& mesh, typename SimplexMesh<Dim>::CellId cell) {
  return cell_words(Simplex<Dim>::cell, cell.raw, mesh, mesh.corners[cell]);
}

template <int Dim>
std::string words(const MixedMesh<Dim>& mesh, VertexId v) {
  return vertex_words(mesh, v);
}

template <int Dim>
std::string words(const MixedMesh<Dim>& mesh, const MixedFacet<Dim>& facet) {
  if constexpr (Dim == 2) return edge_words(mesh, facet[0], facet[1]);
  return face_words(mesh, facet);
}

template <int Dim>
std::string words(const MixedMesh<Dim>& mesh, CellId cell) {
  return cell_words(mesh.shape(cell).name, cell.raw, mesh, mesh.corners_of(cell));
}

template std::string words(const SimplexMesh<2>&, VertexId);
template std::string words(const SimplexMesh<3>&, VertexId);
template std::string words(const SimplexMesh<2>&, VertexId, VertexId);
template std::string words(const SimplexMesh<3>&, VertexId, VertexId);
template std::string words<2>(const SimplexMesh<2>&, const SimplexMesh<2>::FacetCorners&);
template std::string words<3>(const SimplexMesh<3>&, const SimplexMesh<3>::FacetCorners&);
template std::string words<2>(const SimplexMesh<2>&, TriangleId);
template std::string words<3>(const SimplexMesh<3>&, TetId);
template std::string words(const MixedMesh<2>&, VertexId);
template std::string words(const MixedMesh<3>&, VertexId);
template std::string words(const MixedMesh<2>&, const MixedFacet<2>&);
template std::string words(const MixedMesh<3>&, const MixedFacet<3>&);
template std::string words(const MixedMesh<2>&, CellId);
template std::string words(const MixedMesh<3>&, CellId);

}  // namespace leonhard::mesh
