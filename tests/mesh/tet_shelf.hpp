// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/topology.hpp"

/// A shelf of tetrahedral meshes picked by property, with what is known of each beforehand.
namespace leonhard::tet_shelf {

using Corners = std::array<std::size_t, 4>;
using Face = std::array<std::size_t, 3>;
using Cube = std::array<int, 3>;  ///< a unit cube of the lattice, by its lowest corner

inline Face from_smallest(Face f) {
  std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return f;
}

/// The faces of a positive tetrahedron, counter-clockwise from outside, written out by hand.
inline std::array<Face, 4> faces_of(const Corners& t) {
  const auto& [a, b, c, d] = t;
  return {Face{b, c, d}, Face{a, d, c}, Face{a, b, d}, Face{a, c, b}};
}

/// The faces that one tetrahedron only has, by a set: what the library finds by sorting.
inline std::vector<MarkedFace> lone_faces(const std::vector<Corners>& tets, Marker marker) {
  std::set<Face> directed;
  for (const Corners& t : tets) {
    for (const Face& f : faces_of(t)) directed.insert(from_smallest(f));
  }
  std::vector<MarkedFace> lone;
  for (const auto& [a, b, c] : directed) {
    if (!directed.contains({a, c, b}))
      lone.push_back({{VertexId::from(a), VertexId::from(b), VertexId::from(c)}, marker});
  }
  return lone;
}

inline PerId<TetId, std::array<VertexId, 4>> typed(const std::vector<Corners>& tets) {
  PerId<TetId, std::array<VertexId, 4>> corners;
  for (const auto& [a, b, c, d] : tets)
    corners.push_back({VertexId::from(a), VertexId::from(b), VertexId::from(c), VertexId::from(d)});
  return corners;
}

inline TetMesh build(std::vector<Point3> points, const std::vector<Corners>& tets) {
  return mesh::make_tet_mesh(PerId<VertexId, Point3>(std::move(points)), typed(tets), lone_faces(tets, 1),
                             {{1, "wall"}}, "shelf");
}

/// Cubes of the lattice, six tetrahedra each, which match from cube to cube: a tetrahedron for each order of the axes,
/// along which its corners climb from the lowest to the highest corner (H. W. Kuhn, 1960).
inline TetMesh cubes(const std::vector<Cube>& list, double shake = 0, unsigned seed = 1) {
  std::map<Cube, std::size_t> number;
  std::vector<Point3> points;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-shake, shake);
  const auto vertex = [&](const Cube& at) {
    const auto [entry, is_new] = number.emplace(at, points.size());
    if (is_new) points.push_back({at[0] + move(random), at[1] + move(random), at[2] + move(random)});
    return entry->second;
  };
  std::vector<Corners> tets;
  for (const Cube& cube : list) {
    std::array<std::size_t, 3> axes{0, 1, 2};
    bool even = true;
    do {
      Corners t{};
      Cube at = cube;
      t[0] = vertex(at);
      for (std::size_t i = 0; i < 3; ++i) {
        ++at[axes[i]];
        t[i + 1] = vertex(at);
      }
      even = (axes[1] == (axes[0] + 1) % 3);  // the cyclic orders
      if (!even) std::swap(t[2], t[3]);
      tets.push_back(t);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  return build(std::move(points), tets);
}

/// All cubes of a box but those left out.
inline std::vector<Cube> box_without(int nx, int ny, int nz, const std::vector<Cube>& out = {}) {
  std::vector<Cube> list;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const Cube cube{i, j, k};
        if (std::find(out.begin(), out.end(), cube) == out.end()) list.push_back(cube);
      }
    }
  }
  return list;
}

inline TetMesh box(int nx, int ny, int nz) { return cubes(box_without(nx, ny, nz)); }

/// A box of n cubes a side, each lattice point moved by at most 0.05 in each direction: a tetrahedron's determinant,
/// 1 at first, stays above 0.
inline TetMesh shaken_box(int n, unsigned seed) { return cubes(box_without(n, n, n), 0.05, seed); }

/// The cube's corners 0..7 with bits x, y, z.
inline std::vector<Point3> cube_corners() {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
}

/// A torus of 7 x 7 x 3 cubes with its hole in the middle and a cavity that runs round it: a hollow tyre.
inline TetMesh hollow_torus() {
  std::vector<Cube> out{{3, 3, 0}, {3, 3, 1}, {3, 3, 2}};
  for (int i = 1; i <= 5; ++i) {
    for (int j = 1; j <= 5; ++j) {
      if (i == 1 || i == 5 || j == 1 || j == 5) out.push_back({i, j, 1});
    }
  }
  return cubes(box_without(7, 7, 3, out));
}

struct Entry {
  std::string name;
  TetMesh mesh;
  /// Counted as if pinched edges and vertices were opened by a hair's breadth (see TetEulerAccount).
  std::size_t components, handles, cavities;
  std::size_t vertex_pinches, edge_pinches, extra_sheets;
};

inline std::vector<Entry> all() {
  const std::vector<Point3> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  return {
      {"single tetrahedron", build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), 1, 0, 0, 0,
       0, 0},
      {"two tetrahedra",
       build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}}), 1, 0, 0,
       0, 0, 0},
      {"octahedron of four about an inner edge",
       build(octahedron, {{4, 5, 2, 0}, {4, 5, 1, 2}, {4, 5, 3, 1}, {4, 5, 0, 3}}), 1, 0, 0, 0, 0, 0},
      {"cube of five",
       build(cube_corners(), {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}}), 1, 0, 0,
       0, 0, 0},
      {"cube of six", box(1, 1, 1), 1, 0, 0, 0, 0, 0},
      {"box", box(3, 2, 4), 1, 0, 0, 0, 0, 0},
      {"shaken box", shaken_box(4, 1), 1, 0, 0, 0, 0, 0},
      {"solid torus", cubes(box_without(3, 3, 1, {{1, 1, 0}})), 1, 1, 0, 0, 0, 0},
      {"double torus", cubes(box_without(5, 3, 1, {{1, 1, 0}, {3, 1, 0}})), 1, 2, 0, 0, 0, 0},
      {"hollow ball", cubes(box_without(3, 3, 3, {{1, 1, 1}})), 1, 0, 1, 0, 0, 0},
      {"hollow torus", hollow_torus(), 1, 2, 1, 0, 0, 0},
      {"two components, one of them hollow", cubes([] {
         auto list = box_without(3, 3, 3, {{1, 1, 1}});
         list.push_back({5, 0, 0});
         return list;
       }()),
       2, 0, 1, 0, 0, 0},
      {"a ball within the cavity of another", cubes([] {
         auto list = box_without(5, 5, 5, box_without(5, 5, 5));
         for (const Cube& c : box_without(5, 5, 5)) {
           const bool in_shell =
               *std::min_element(c.begin(), c.end()) == 0 || *std::max_element(c.begin(), c.end()) == 4;
           if (in_shell || c == Cube{2, 2, 2}) list.push_back(c);
         }
         return list;
       }()),
       2, 0, 1, 0, 0, 0},
      {"two balls that touch at a vertex", cubes({{0, 0, 0}, {1, 1, 1}}), 2, 0, 0, 1, 0, 0},
      {"two balls that touch along an edge", cubes({{0, 0, 0}, {1, 1, 0}}), 2, 0, 0, 2, 1, 0},
      {"ring of four balls that touch along edges", cubes({{1, 0, 0}, {0, 1, 0}, {2, 1, 0}, {1, 2, 0}}), 4, 0,
       0, 8, 4, 0},
      {"cavities that touch at a vertex", cubes(box_without(4, 4, 4, {{1, 1, 1}, {2, 2, 2}})), 1, 0, 2, 0, 0,
       1},
      {"cavities that touch along an edge, which opens between them",
       cubes(box_without(4, 4, 3, {{1, 1, 1}, {2, 2, 1}})), 1, 0, 1, 0, 1, 0},
      {"a cavity that touches a notch at a vertex", cubes(box_without(3, 3, 3, {{0, 0, 0}, {1, 1, 1}})), 1, 0,
       1, 0, 0, 1},
      {"a torus closed at an edge",
       cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 1, 0}}), 1, 0, 0, 2, 1,
       0},
  };
}

}  // namespace leonhard::tet_shelf
