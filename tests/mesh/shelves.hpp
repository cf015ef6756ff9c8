// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "tests/mesh/shelf.hpp"
#include "tests/mesh/tet_shelf.hpp"

TYPE_TO_STRING_AS("TriangleMesh", leonhard::TriangleMesh);
TYPE_TO_STRING_AS("TetMesh", leonhard::TetMesh);

/// The shelves of the plane and of space under common names, for claims about both kinds of meshes.
namespace leonhard::shelves {

template <class Mesh>
constexpr bool is_plane = std::is_same_v<Mesh, TriangleMesh>;
template <class Mesh>
using Kind = Simplex<is_plane<Mesh> ? 2 : 3>;

template <class Mesh>
auto all() {
  if constexpr (is_plane<Mesh>) {
    return shelf::all();
  } else {
    return tet_shelf::all();
  }
}

/// n squares or cubes a side.
template <class Mesh>
Mesh regular(int n) {
  if constexpr (is_plane<Mesh>) {
    return shelf::grid(static_cast<std::size_t>(n), static_cast<std::size_t>(n));
  } else {
    return tet_shelf::box(n, n, n);
  }
}

/// The same with every point moved a little.
template <class Mesh>
Mesh shaken(int n, unsigned seed) {
  if constexpr (is_plane<Mesh>) {
    return shelf::shaken_grid(static_cast<std::size_t>(n), seed);
  } else {
    return tet_shelf::shaken_box(n, seed);
  }
}

inline PerId<VertexId, VertexId> random_permutation(std::size_t count, unsigned seed) {
  PerId<VertexId, VertexId> permutation;
  for (std::size_t i = 0; i < count; ++i) permutation.push_back(VertexId::from(i));
  std::shuffle(permutation.begin(), permutation.end(), std::mt19937(seed));
  return permutation;
}

}  // namespace leonhard::shelves
