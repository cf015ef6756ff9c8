// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/order/tet_sort.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "leonhard/delaunay/support/large_vector.hpp"
#include "leonhard/delaunay/support/parallel.hpp"

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

/// Sorts tetrahedra in two steps, neither of which waits for memory: into buckets by their least vertex, in place, each
/// bucket filling up from its beginning (McIlroy, Bostic and McIlroy, "Engineering radix sort", Computing Systems 6,
/// 1993), then every bucket in the cache.
class TetSort {
 public:
  TetSort(GhostTetrahedralization& cells, std::size_t vertices, unsigned threads)
      : corners_(cells.corners.flat()),
        neighbours_(cells.neighbours.flat()),
        buckets_(vertices / vertices_a_bucket + 1),
        threads_(threads) {}

  void run() {
    sort_all_corners();
    find_buckets();
    number_ = large_vector<IdRaw>(corners_.size());
    old_number_ = large_vector<IdRaw>(corners_.size());
    parallel_for_indices(0, corners_.size(), threads_,
                         [&](std::size_t t) { old_number_[t] = static_cast<IdRaw>(t); });
    distribute();
    parallel_for_blocks(buckets_, threads_, [&](std::size_t bucket) { sort_bucket(bucket); });
    const std::size_t real = begins_[buckets_];
    parallel_for_indices(real, corners_.size(), threads_,
                         [&](std::size_t t) { number_[old_number_[t]] = static_cast<IdRaw>(t); });
    release(old_number_);
    corners_.resize(real);
    neighbours_.resize(real);
    parallel_for_indices(0, real, threads_, [&](std::size_t t) {
      for (MaybeId<TetId>& n : neighbours_[t]) {
        const IdRaw behind = number_[(*n).index()];
        n = behind < real ? MaybeId(TetId{behind}) : MaybeId<TetId>();
      }
    });
  }

 private:
  static constexpr std::size_t vertices_a_bucket = 2048;  // some 14,000 tetrahedra: 500 kB

  /// Ghosts and dead ones have a bucket of their own, the last one.
  [[nodiscard]] std::size_t bucket_of(const Corners& c) const {
    return c[0] == ghost ? buckets_ : c[0].index() / vertices_a_bucket;
  }

  void sort_all_corners() {
    parallel_for_indices(0, corners_.size(), threads_, [&](std::size_t t) {
      if (corners_[t][0] != ghost) sort_corners(corners_[t], neighbours_[t]);
    });
  }

  void find_buckets() {
    begins_.assign(buckets_ + 2, 0);
    for (const Corners& c : corners_) ++begins_[bucket_of(c) + 1];
    for (std::size_t b = 0; b <= buckets_; ++b) begins_[b + 1] += begins_[b];
  }

  void swap_places(std::size_t i, std::size_t j) {
    std::swap(corners_[i], corners_[j]);
    std::swap(neighbours_[i], neighbours_[j]);
    std::swap(old_number_[i], old_number_[j]);
  }

  /// Buckets fill up in turns that no processor foresees.
  void fetch(std::size_t place) const {
    __builtin_prefetch(corners_.data() + place, 1);
    __builtin_prefetch(neighbours_.data() + place, 1);
    __builtin_prefetch(old_number_.data() + place, 1);
  }

  void distribute() {
    std::vector<std::size_t> next(begins_.begin(),
                                  begins_.end() - 1);  // all before it are in the right bucket
    for (std::size_t b = 0; b <= buckets_; ++b) {
      for (; next[b] < begins_[b + 1]; ++next[b]) {
        const std::size_t hole = next[b];
        for (std::size_t to = bucket_of(corners_[hole]); to != b; to = bucket_of(corners_[hole])) {
          std::size_t& place = next[to];
          while (bucket_of(corners_[place]) == to) ++place;
          fetch(place + 8);
          swap_places(hole, place++);
        }
      }
    }
  }

  /// What tetrahedra of the same least vertex are sorted by.
  struct Keyed {
    std::array<IdRaw, 3> key;
    std::uint32_t index;
    bool operator<(const Keyed& other) const {
      if (key[0] != other.key[0]) return key[0] < other.key[0];
      if (key[1] != other.key[1]) return key[1] < other.key[1];
      return key[2] < other.key[2];
    }
  };

  /// Insertion sort, since a vertex is the least of some seven; of very many, std::sort.
  static void sort_few(Keyed* begin, Keyed* end) {
    if (end - begin > 40) return std::sort(begin, end);
    for (Keyed* i = begin + 1; i < end; ++i) {
      const Keyed one = *i;
      Keyed* j = i;
      for (; j != begin && one < j[-1]; --j) *j = j[-1];
      *j = one;
    }
  }

  void sort_bucket(std::size_t bucket) {
    const std::size_t begin = begins_[bucket], count = begins_[bucket + 1] - begin;
    const std::size_t first_vertex = bucket * vertices_a_bucket;
    const auto vertex = [&](std::size_t t) { return corners_[begin + t][0].index() - first_vertex; };
    std::array<std::uint32_t, vertices_a_bucket + 1> ends{};
    for (std::size_t t = 0; t < count; ++t) ++ends[vertex(t) + 1];
    for (std::size_t v = 0; v < vertices_a_bucket; ++v) ends[v + 1] += ends[v];
    std::vector<Keyed> sorted(count);
    for (std::size_t t = 0; t < count; ++t) {
      const Corners& c = corners_[begin + t];
      sorted[ends[vertex(t)]++] = {{c[1].raw, std::min(c[2], c[3]).raw, std::max(c[2], c[3]).raw},
                                   static_cast<std::uint32_t>(t)};
    }
    for (std::size_t v = 0; v < vertices_a_bucket; ++v)
      sort_few(sorted.data() + (v == 0 ? 0 : ends[v - 1]), sorted.data() + ends[v]);

    const std::vector<Corners> corners(corners_.begin() + begin, corners_.begin() + begin + count);
    const std::vector<Neighbours> neighbours(neighbours_.begin() + begin,
                                             neighbours_.begin() + begin + count);
    for (std::size_t t = 0; t < count; ++t) {
      const std::uint32_t from = sorted[t].index;
      corners_[begin + t] = corners[from];
      neighbours_[begin + t] = neighbours[from];
      number_[old_number_[begin + from]] = static_cast<IdRaw>(begin + t);
    }
  }

  std::vector<Corners>& corners_;
  std::vector<Neighbours>& neighbours_;
  std::size_t buckets_;  // of real tetrahedra
  unsigned threads_;
  std::vector<std::size_t> begins_;  // of buckets, that of the dead ones, and the end
  std::vector<IdRaw> old_number_, number_;
};

}  // namespace

void sort_and_drop_ghosts(GhostTetrahedralization& cells, std::size_t vertices, unsigned threads) {
  TetSort(cells, vertices, threads).run();
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

}  // namespace leonhard::delaunay
