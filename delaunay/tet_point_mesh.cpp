// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tet_point_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "leonhard/delaunay/large_vector.hpp"
#include "leonhard/delaunay/parallel.hpp"

namespace leonhard::delaunay {
namespace {

using Corners = std::array<VertexId, 4>;
using Neighbours = std::array<MaybeId<TetId>, 4>;
constexpr VertexId ghost = GhostTetrahedralization::ghost;

/// Compare-exchange of corners with their neighbours; whether they changed places.
bool order_two(Corners& c, Neighbours& n, unsigned i, unsigned j) {
  if (c[i] < c[j]) return false;
  std::swap(c[i], c[j]);
  std::swap(n[i], n[j]);
  return true;
}

/// Corners in rising order but for the last two, which keep the tetrahedron positive.
void sort_corners(Corners& c, Neighbours& n) {
  bool odd = false;
  odd ^= order_two(c, n, 0, 1);
  odd ^= order_two(c, n, 2, 3);
  odd ^= order_two(c, n, 0, 2);
  odd ^= order_two(c, n, 1, 3);
  odd ^= order_two(c, n, 1, 2);
  if (odd) {
    std::swap(c[2], c[3]);
    std::swap(n[2], n[3]);
  }
}

/// The order of sort_and_drop_ghosts among tetrahedra of the same least vertex.
bool comes_before(const Corners& a, const Corners& b) {
  const auto rest = [](const Corners& c) {
    return std::array{c[1], std::min(c[2], c[3]), std::max(c[2], c[3])};
  };
  return rest(a) < rest(b);
}

/// The numbers of all real tetrahedra in the order in which they are to come.
std::vector<TetId> sorted_numbers(const GhostTetrahedralization& cells, std::size_t vertices, unsigned threads) {
  std::vector<IdRaw> begins(vertices + 1, 0);
  for (const Corners& c : cells.corners)
    if (c[0] != ghost) ++begins[c[0].index() + 1];
  for (std::size_t v = 0; v < vertices; ++v) begins[v + 1] += begins[v];
  auto numbers = large_vector<TetId>(begins[vertices]);
  {
    std::vector<IdRaw> next(begins.begin(), begins.end() - 1);
    for (const TetId t : cells.corners.ids())
      if (cells.corners[t][0] != ghost) numbers[next[cells.corners[t][0].index()]++] = t;
  }
  parallel_for_indices(0, vertices, threads, [&](std::size_t v) {
    std::sort(numbers.begin() + begins[v], numbers.begin() + begins[v + 1],
              [&](TetId a, TetId b) { return comes_before(cells.corners[a], cells.corners[b]); });
  });
  return numbers;
}

/// sorted[i] = values[from[i]] for all i, in place: along the cycles of the permutation. `from` may leave values out, which
/// are lost, but all of it lies below values.size().
template <class T>
void permute(std::vector<T>& values, const std::vector<TetId>& from) {
  std::vector<bool> done(from.size(), false);
  // A chain that begins at a place whose value nobody wants: its end takes a value from beyond the sorted part.
  const auto follow = [&](std::size_t start) {
    const T first = values[start];
    std::size_t i = start;
    while (true) {
      done[i] = true;
      const std::size_t next = from[i].index();
      if (next == start || next >= from.size()) {
        values[i] = next == start ? first : values[next];
        return;
      }
      values[i] = values[next];
      i = next;
    }
  };
  std::vector<bool> wanted(from.size(), false);
  for (const TetId t : from)
    if (t.index() < from.size()) wanted[t.index()] = true;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!wanted[i]) follow(i);
  for (std::size_t i = 0; i < from.size(); ++i)
    if (!done[i]) follow(i);
  values.resize(from.size());
}

}  // namespace

void sort_and_drop_ghosts(GhostTetrahedralization& cells, std::vector<TetId> dead, std::size_t vertices,
                          unsigned threads) {
  auto& corners = cells.corners.flat();
  auto& neighbours = cells.neighbours.flat();
  for (const TetId t : dead) corners[t.index()].fill(ghost);
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    if (corners[t][0] != ghost) sort_corners(corners[t], neighbours[t]);
  });
  std::vector<TetId> numbers = sorted_numbers(cells, vertices, threads);
  auto new_number = large_vector<MaybeId<TetId>>(corners.size());
  parallel_for_indices(0, numbers.size(), threads,
                       [&](std::size_t i) { new_number[numbers[i].index()] = TetId::from(i); });
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    if (corners[t][0] == ghost) return;
    for (MaybeId<TetId>& n : neighbours[t]) n = new_number[(*n).index()];
  });
  release(new_number);
  parallel_invoke(threads, [&] { permute(corners, numbers); }, [&] { permute(neighbours, numbers); });
}

namespace {

/// One an input point: its vertex in the mesh.
std::vector<MaybeId<VertexId>> vertices_of_input(const SortedOrigin& origin) {
  const std::size_t n = origin.sorted_index.size();
  std::vector<MaybeId<VertexId>> vertex_of(n);
  if (origin.first_input.size() == n) {
    for (std::size_t i = 0; i < n; ++i) vertex_of[i] = VertexId::from(i);
    return vertex_of;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = origin.first_input[origin.sorted_index[i]];
    vertex_of[i] = first == i ? VertexId::from(count++) : *vertex_of[first];
  }
  return vertex_of;
}

}  // namespace

TetPointMesh to_mesh(GhostTetrahedralization cells, SortedOrigin origin, std::vector<Point3> input,
                     unsigned threads) {
  TetPointMesh result;
  TetMesh& mesh = result.mesh;
  result.vertex_of_input = vertices_of_input(origin);
  release(origin.sorted_index);
  std::vector<std::uint32_t> number_of = std::move(origin.first_input);
  const std::size_t vertices = number_of.size();
  if (vertices < input.size()) {
    for (std::uint32_t& i : number_of) i = (*result.vertex_of_input[i]).raw;
    std::size_t next = 0;
    for (std::size_t i = 0; i < input.size(); ++i)
      if ((*result.vertex_of_input[i]).index() == next) input[next++] = input[i];
    input.resize(vertices);
  }
  mesh.points.flat() = std::move(input);
  mesh.corners = std::move(cells.corners);
  mesh.neighbours = std::move(cells.neighbours);
  auto& corners = mesh.corners.flat();
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    for (VertexId& v : corners[t]) v = VertexId{number_of[v.index()]};
  });
  for (const TetId t : mesh.corners.ids()) {
    for (unsigned face = 0; face < 4; ++face) {
      if (mesh.neighbours[t][face]) continue;
      const auto [i, j, k] = tet_face_corners[face];
      mesh.boundary.push_back({{mesh.corners[t][i], mesh.corners[t][j], mesh.corners[t][k]}, 1});
    }
  }
  mesh.regions.resize(mesh.tet_count(), 0);
  mesh.vertex_markers.resize(vertices, 0);
  return result;
}

}  // namespace leonhard::delaunay
