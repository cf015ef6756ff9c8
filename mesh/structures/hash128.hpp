// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace leonhard::mesh {

/// A bijection of 64-bit words in which every input bit changes every output bit with probability near a half:
/// Stafford's variant 13 of MurmurHash3's finaliser, as in SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t z) {
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
  [[nodiscard]] std::uint64_t hi() const { return hi_; }
  [[nodiscard]] std::uint64_t lo() const { return lo_; }

 private:
  std::uint64_t hi_ = 0x6c656f6e68617264U;  // "leonhard" in ASCII
  std::uint64_t lo_ = 0x45756c65722c2056U;  // "Euler, V"
};

/// The bits of a coordinate, -0 taken as 0.
[[nodiscard]] inline std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x);
}

}  // namespace leonhard::mesh
