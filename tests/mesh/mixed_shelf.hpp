// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/mesh/mixed_mesh.hpp"

/// A shelf of meshes of mixed cells picked by property, with what is known of each beforehand.
namespace leonhard::mixed_shelf {

using Corners = std::vector<std::size_t>;

struct Cell {
  CellKind kind;
  Corners corners;
};

/// The facets of a cell, directed outwards, written out by hand.
inline std::vector<Corners> facets_of(const Cell& cell) {
  const Corners& c = cell.corners;
  switch (cell.kind) {
    case CellKind::triangle:
      return {{c[0], c[1]}, {c[1], c[2]}, {c[2], c[0]}};
    case CellKind::quadrilateral:
      return {{c[0], c[1]}, {c[1], c[2]}, {c[2], c[3]}, {c[3], c[0]}};
    case CellKind::tetrahedron:
      return {{c[0], c[2], c[1]}, {c[0], c[1], c[3]}, {c[1], c[2], c[3]}, {c[2], c[0], c[3]}};
    case CellKind::pyramid:
      return {{c[3], c[2], c[1], c[0]},
              {c[0], c[1], c[4]},
              {c[1], c[2], c[4]},
              {c[2], c[3], c[4]},
              {c[3], c[0], c[4]}};
    case CellKind::prism:
      return {{c[2], c[1], c[0]},
              {c[3], c[4], c[5]},
              {c[0], c[1], c[4], c[3]},
              {c[1], c[2], c[5], c[4]},
              {c[2], c[0], c[3], c[5]}};
    case CellKind::hexahedron:
      return {{c[3], c[2], c[1], c[0]}, {c[4], c[5], c[6], c[7]}, {c[0], c[1], c[5], c[4]},
              {c[1], c[2], c[6], c[5]}, {c[2], c[3], c[7], c[6]}, {c[3], c[0], c[4], c[7]}};
  }
  return {};
}

inline std::vector<VertexId> typed(const Corners& corners) {
  std::vector<VertexId> ids;
  for (const std::size_t c : corners) ids.push_back(VertexId::from(c));
  return ids;
}

/// The facets of one cell alone, by a map over sorted vertices: what the library finds by buckets.
template <int Dim>
std::vector<MarkedMixedFacet<Dim>> lone_facets(const std::vector<Cell>& cells, Marker marker) {
  std::map<Corners, std::vector<Corners>> given;
  for (const Cell& cell : cells) {
    for (const Corners& facet : facets_of(cell)) {
      Corners sorted = facet;
      std::sort(sorted.begin(), sorted.end());
      given[sorted].push_back(facet);
    }
  }
  std::vector<MarkedMixedFacet<Dim>> lone;
  for (const auto& entry : given)
    if (entry.second.size() == 1)
      lone.push_back({MixedFacet<Dim>(std::span<const VertexId>(typed(entry.second[0]))), marker});
  return lone;
}

template <int Dim>
MixedMesh<Dim> build(const std::vector<typename Simplex<Dim>::Point>& points,
                     const std::vector<Cell>& cells) {
  MixedMesh<Dim> mesh;
  mesh.points = PerId<VertexId, typename Simplex<Dim>::Point>(points);
  for (const Cell& cell : cells) mesh.add_cell(cell.kind, typed(cell.corners));
  mesh.boundary = lone_facets<Dim>(cells, 1);
  mesh.vertex_markers.resize(points.size(), 0);
  mesh.marker_names = {{1, "wall"}};
  return mesh;
}

/// One cell of a kind, of unit edges, by its corners.
inline std::vector<Point3> unit_corners(CellKind kind) {
  switch (kind) {
    case CellKind::tetrahedron:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case CellKind::pyramid:
      return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    case CellKind::prism:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    default:
      return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  }
}
inline MixedMesh<3> single(CellKind kind) {
  const std::vector<Point3> points = unit_corners(kind);
  Corners corners(points.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = i;
  return build<3>(points, {{kind, corners}});
}

/// nx by ny unit squares. split(i, j) says whether a square is two triangles.
inline MixedMesh<2> plane_grid(std::size_t nx, std::size_t ny,
                               const std::function<bool(std::size_t, std::size_t)>& split) {
  std::vector<Point2> points;
  std::vector<Cell> cells;
  for (std::size_t j = 0; j <= ny; ++j)
    for (std::size_t i = 0; i <= nx; ++i) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = c - 1;
      if (split(i, j)) {
        cells.push_back({CellKind::triangle, {a, b, c}});
        cells.push_back({CellKind::triangle, {a, c, d}});
      } else {
        cells.push_back({CellKind::quadrilateral, {a, b, c, d}});
      }
    }
  }
  return build<2>(points, cells);
}

/// How a cube of a box is filled.
enum class Filling {
  hexahedron,
  prisms,  ///< two, one above the other's diagonal in each horizontal face
  star,    ///< pyramids and tetrahedra about its centre
  nothing
};

/// Unit cubes, filled each its own way; above and below prisms only prisms, stars or nothing.
class Box {
 public:
  Box(std::size_t nx, std::size_t ny, std::size_t nz,
      std::function<Filling(std::size_t, std::size_t, std::size_t)> filling)
      : n_{nx, ny, nz}, filling_(std::move(filling)) {
    for (std::size_t k = 0; k <= nz; ++k)
      for (std::size_t j = 0; j <= ny; ++j)
        for (std::size_t i = 0; i <= nx; ++i)
          points_.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
    for (std::size_t k = 0; k < nz; ++k)
      for (std::size_t j = 0; j < ny; ++j)
        for (std::size_t i = 0; i < nx; ++i) fill(i, j, k);
  }

  /// Vertices that no cell has are left out.
  [[nodiscard]] MixedMesh<3> mesh() const {
    std::map<std::size_t, std::size_t> new_of_old;
    std::vector<Cell> cells = cells_;
    for (const Cell& cell : cells)
      for (const std::size_t v : cell.corners) new_of_old.emplace(v, 0);
    std::vector<Point3> points;
    for (auto& entry : new_of_old) {
      entry.second = points.size();
      points.push_back(points_[entry.first]);
    }
    for (Cell& cell : cells)
      for (std::size_t& v : cell.corners) v = new_of_old.at(v);
    return build<3>(points, cells);
  }

 private:
  [[nodiscard]] std::size_t vertex(std::size_t i, std::size_t j, std::size_t k) const {
    return (k * (n_[1] + 1) + j) * (n_[0] + 1) + i;
  }
  [[nodiscard]] bool has_prisms(std::size_t i, std::size_t j, std::size_t k) const {
    return k < n_[2] && filling_(i, j, k) == Filling::prisms;
  }
  void fill(std::size_t i, std::size_t j, std::size_t k) {
    const auto v = [&](std::size_t x, std::size_t y, std::size_t z) { return vertex(i + x, j + y, k + z); };
    const Cell cube{
        CellKind::hexahedron,
        {v(0, 0, 0), v(1, 0, 0), v(1, 1, 0), v(0, 1, 0), v(0, 0, 1), v(1, 0, 1), v(1, 1, 1), v(0, 1, 1)}};
    const Corners& c = cube.corners;
    if (filling_(i, j, k) == Filling::nothing) return;
    if (filling_(i, j, k) == Filling::hexahedron) {
      cells_.push_back(cube);
    } else if (filling_(i, j, k) == Filling::prisms) {
      cells_.push_back({CellKind::prism, {c[0], c[1], c[2], c[4], c[5], c[6]}});
      cells_.push_back({CellKind::prism, {c[0], c[2], c[3], c[4], c[6], c[7]}});
    } else {
      star(cube, {k > 0 && has_prisms(i, j, k - 1), has_prisms(i, j, k + 1)});
    }
  }
  /// split  whether the lower and the upper face are two triangles, along the diagonal that prisms take
  void star(const Cell& cube, std::array<bool, 2> split) {
    const std::size_t centre = points_.size();
    points_.push_back(points_[cube.corners[0]] + Vec3{0.5, 0.5, 0.5});
    const std::vector<Corners> faces = facets_of(cube);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      Corners q = faces[f];
      std::reverse(q.begin(), q.end());  // seen from the centre
      if (f < 2 && split[f]) {
        // Corners 0 and 2 of the cube are on the diagonal, and 4 and 6.
        while (q[0] != cube.corners[f == 0 ? 0 : 4]) std::rotate(q.begin(), q.begin() + 1, q.end());
        cells_.push_back({CellKind::tetrahedron, {q[0], q[1], q[2], centre}});
        cells_.push_back({CellKind::tetrahedron, {q[0], q[2], q[3], centre}});
      } else {
        q.push_back(centre);
        cells_.push_back({CellKind::pyramid, q});
      }
    }
  }

  std::array<std::size_t, 3> n_;
  std::function<Filling(std::size_t, std::size_t, std::size_t)> filling_;
  std::vector<Point3> points_;
  std::vector<Cell> cells_;
};

inline MixedMesh<3> box(std::size_t nx, std::size_t ny, std::size_t nz, Filling filling) {
  return Box(nx, ny, nz, [filling](std::size_t, std::size_t, std::size_t) { return filling; }).mesh();
}

/// All four kinds of cells: two columns of hexahedra, one of prisms with a star in the middle, one of stars.
inline MixedMesh<3> mixture() {
  return Box(2, 2, 3,
             [](std::size_t i, std::size_t j, std::size_t k) {
               if (j == 0) return Filling::hexahedron;
               if (i == 0) return k == 1 ? Filling::star : Filling::prisms;
               return Filling::star;
             })
      .mesh();
}

/// Every point moved at random by at most `most` in each direction, then scaled and shifted.
template <int Dim>
MixedMesh<Dim> shaken(MixedMesh<Dim> mesh, unsigned seed, double most = 0.1, double scale = 1,
                      typename Simplex<Dim>::Vector shift = {}) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-most, most);
  for (auto& p : mesh.points) {
    p.x += move(random);
    p.y += move(random);
    if constexpr (Dim == 3) p.z += move(random);
    p = typename Simplex<Dim>::Point{} + (scale * (p - typename Simplex<Dim>::Point{}) + shift);
  }
  return mesh;
}

template <int Dim>
struct Entry {
  std::string name;
  MixedMesh<Dim> mesh;
  double measure;  ///< area or volume
};

template <int Dim>
std::vector<Entry<Dim>> all();

template <>
inline std::vector<Entry<2>> all<2>() {
  const auto none = [](std::size_t, std::size_t) { return false; };
  const auto some = [](std::size_t i, std::size_t j) { return (i + 2 * j) % 3 == 0; };
  const auto ends = [](std::size_t i, std::size_t) { return i == 0 || i == 4; };
  return {{"single quadrilateral", plane_grid(1, 1, none), 1},
          {"quadrilaterals", plane_grid(4, 3, none), 12},
          {"triangles", plane_grid(3, 3, [](std::size_t, std::size_t) { return true; }), 9},
          {"triangles strewn among quadrilaterals", plane_grid(5, 4, some), 20},
          {"quadrilaterals between triangles", plane_grid(5, 2, ends), 10}};
}

template <>
inline std::vector<Entry<3>> all<3>() {
  return {{"single tetrahedron", single(CellKind::tetrahedron), 1.0 / 6},
          {"single pyramid", single(CellKind::pyramid), 1.0 / 3},
          {"single prism", single(CellKind::prism), 0.5},
          {"single hexahedron", single(CellKind::hexahedron), 1},
          {"hexahedra", box(3, 2, 2, Filling::hexahedron), 12},
          {"prisms", box(2, 3, 2, Filling::prisms), 12},
          {"pyramids", box(2, 2, 2, Filling::star), 8},
          {"all kinds", mixture(), 12}};
}

}  // namespace leonhard::mixed_shelf
