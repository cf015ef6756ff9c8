// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tet_point_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "leonhard/delaunay/in_place_permutation.hpp"
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

/// Sort numbers of tetrahedra of the same least vertex by their other vertices: insertion sort, since a vertex is the least
/// of some seven; of very many, std::sort.
class SmallSort {
 public:
  void operator()(TetId* begin, TetId* end, const Corners* corners) {
    keyed_.clear();
    for (const TetId* t = begin; t != end; ++t) {
      const Corners& c = corners[t->index()];
      keyed_.push_back({{c[1].raw, std::min(c[2].raw, c[3].raw), std::max(c[2].raw, c[3].raw)}, *t});
    }
    if (keyed_.size() > 40) {
      std::sort(keyed_.begin(), keyed_.end());
    } else {
      for (std::size_t i = 1; i < keyed_.size(); ++i) {
        const Keyed one = keyed_[i];
        std::size_t j = i;
        for (; j > 0 && one < keyed_[j - 1]; --j) keyed_[j] = keyed_[j - 1];
        keyed_[j] = one;
      }
    }
    for (const Keyed& one : keyed_) *begin++ = one.tet;
  }

 private:
  struct Keyed {
    std::array<IdRaw, 3> key;
    TetId tet;
    bool operator<(const Keyed& other) const {
      if (key[0] != other.key[0]) return key[0] < other.key[0];
      if (key[1] != other.key[1]) return key[1] < other.key[1];
      return key[2] < other.key[2];
    }
  };
  std::vector<Keyed> keyed_;
};

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
  constexpr std::size_t block_size = std::size_t{1} << 13;
  parallel_for_blocks((vertices + block_size - 1) / block_size, threads, [&](std::size_t block) {
    SmallSort sort;
    const std::size_t end = std::min((block + 1) * block_size, vertices);
    for (std::size_t v = block * block_size; v < end; ++v)
      sort(numbers.data() + begins[v], numbers.data() + begins[v + 1], cells.corners.flat().data());
  });
  return numbers;
}

/// The number that each tetrahedron gets: real ones in the order of sort_and_drop_ghosts, the others after them.
std::vector<IdRaw> new_numbers(const GhostTetrahedralization& cells, std::size_t vertices, unsigned threads) {
  const std::vector<TetId> sorted = sorted_numbers(cells, vertices, threads);
  auto number = large_vector<IdRaw>(cells.tet_count());
  parallel_for_indices(0, sorted.size(), threads,
                       [&](std::size_t i) { number[sorted[i].index()] = static_cast<IdRaw>(i); });
  auto next = static_cast<IdRaw>(sorted.size());
  for (const TetId t : cells.corners.ids())
    if (cells.is_ghost(t)) number[t.index()] = next++;
  return number;
}

}  // namespace

void sort_and_drop_ghosts(GhostTetrahedralization& cells, std::size_t vertices,
                          unsigned threads) {
  auto& corners = cells.corners.flat();
  auto& neighbours = cells.neighbours.flat();
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    if (corners[t][0] != ghost) sort_corners(corners[t], neighbours[t]);
  });
  std::vector<IdRaw> number = new_numbers(cells, vertices, threads);
  const auto ghosts = static_cast<std::size_t>(
      std::count_if(corners.begin(), corners.end(), [](const Corners& c) { return c[0] == ghost; }));
  const std::size_t real = corners.size() - ghosts;
  parallel_for_indices(0, corners.size(), threads, [&](std::size_t t) {
    if (corners[t][0] == ghost) return;
    for (MaybeId<TetId>& n : neighbours[t]) {
      const IdRaw behind = number[(*n).index()];
      n = behind < real ? MaybeId(TetId{behind}) : MaybeId<TetId>();
    }
  });
  permute_in_place(number, threads, corners, neighbours);
  corners.resize(real);
  neighbours.resize(real);
}

void drop_ghosts(GhostTetrahedralization& cells) {
  std::vector<TetId> dead;
  for (const TetId t : cells.corners.ids()) {
    if (!cells.is_ghost(t)) continue;
    dead.push_back(t);
    if (cells.corners[t][1] == ghost) continue;
    for (const MaybeId<TetId> behind : cells.neighbours[t]) {
      if (!behind) continue;  // a ghost that is gone already
      auto& back = cells.neighbours[*behind];
      std::replace(back.begin(), back.end(), MaybeId(t), MaybeId<TetId>());
    }
    cells.neighbours[t].fill({});
  }
  cells.erase(std::move(dead));
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
