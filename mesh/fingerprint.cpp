// SPDX-License-Identifier: MIT
#include "leonhard/mesh/fingerprint.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/hash128.hpp"

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

std::array<std::uint64_t, 2> point_bits(const Point2& p) { return {bits_of(p.x), bits_of(p.y)}; }
std::array<std::uint64_t, 3> point_bits(const Point3& p) {
  return {bits_of(p.x), bits_of(p.y), bits_of(p.z)};
}

template <class Points, std::size_t N>
Fingerprint cell_hash(const Points& points, const std::array<VertexId, N>& corners) {
  std::array<decltype(point_bits(points[corners[0]])), N> bits;
  for (std::size_t i = 0; i < N; ++i) bits[i] = point_bits(points[corners[i]]);
  std::sort(bits.begin(), bits.end());
  Hash128 hash;
  for (const auto& point : bits) {
    for (const std::uint64_t word : point) hash.take(word);
  }
  return {hash.hi(), hash.lo()};
}

template <class Mesh>
Fingerprint fingerprint_of(const Mesh& mesh) {
  require_corners_in_range(mesh);
  std::vector<Fingerprint> cells;
  cells.reserve(mesh.corners.size());
  for (const auto& corners : mesh.corners) cells.push_back(cell_hash(mesh.points, corners));
  std::sort(cells.begin(), cells.end(), [](const Fingerprint& a, const Fingerprint& b) {
    return a.hi != b.hi ? a.hi < b.hi : a.lo < b.lo;
  });
  Hash128 hash;
  for (const Fingerprint& cell : cells) {
    hash.take(cell.hi);
    hash.take(cell.lo);
  }
  return {hash.hi(), hash.lo()};
}

}  // namespace

Fingerprint fingerprint(const TriangleMesh& mesh) { return fingerprint_of(mesh); }
Fingerprint fingerprint(const TetMesh& mesh) { return fingerprint_of(mesh); }

}  // namespace mesh
}  // namespace leonhard
