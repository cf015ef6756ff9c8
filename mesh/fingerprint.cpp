// SPDX-License-Identifier: MIT
#include "leonhard/mesh/fingerprint.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <utility>
#include <vector>

namespace leonhard {

std::string Fingerprint::hex() const {
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (const std::uint64_t half : {hi, lo}) {
    for (int shift = 60; shift >= 0; shift -= 4) text += digits[(half >> shift) & 15];
  }
  return text;
}

namespace mesh {
namespace {

/// A bijection of 64-bit words in which every input bit changes every output bit with probability near a half:
/// Stafford's variant 13 of MurmurHash3's finaliser, as in SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// Two 64-bit states that take in each word in two ways and each other's last value.
class Hash128 {
 public:
  void take(std::uint64_t word) {
    const std::uint64_t before = hi_;
    hi_ = mixed(hi_ ^ word) + 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio: a word 0 changes the state too
    lo_ = mixed(lo_ + std::rotl(word, 32) * 0xd1342543de82ef95U + before);
  }
  [[nodiscard]] Fingerprint value() const { return {hi_, lo_}; }

 private:
  std::uint64_t hi_ = 0x6c656f6e68617264U;  // "leonhard" in ASCII
  std::uint64_t lo_ = 0x45756c65722c2056U;  // "Euler, V"
};

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x);  // -0 as 0
}

Fingerprint cell_hash(const TriangleMesh& mesh, const std::array<VertexId, 3>& corners) {
  using PointBits = std::pair<std::uint64_t, std::uint64_t>;
  std::array<PointBits, 3> bits;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 p = mesh.points[corners[i]];
    bits[i] = {bits_of(p.x), bits_of(p.y)};
  }
  std::sort(bits.begin(), bits.end());
  Hash128 hash;
  for (const auto& [x, y] : bits) {
    hash.take(x);
    hash.take(y);
  }
  return hash.value();
}

}  // namespace

Fingerprint fingerprint(const TriangleMesh& mesh) {
  std::vector<Fingerprint> cells;
  cells.reserve(mesh.triangle_count());
  for (const auto& corners : mesh.corners) cells.push_back(cell_hash(mesh, corners));
  std::sort(cells.begin(), cells.end(), [](const Fingerprint& a, const Fingerprint& b) {
    return a.hi != b.hi ? a.hi < b.hi : a.lo < b.lo;
  });
  Hash128 hash;
  for (const Fingerprint& cell : cells) {
    hash.take(cell.hi);
    hash.take(cell.lo);
  }
  return hash.value();
}

}  // namespace mesh
}  // namespace leonhard
