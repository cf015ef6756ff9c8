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

template <class Points, class Corners>
Fingerprint cell_hash(const Points& points, const Corners& corners) {
  std::array<decltype(point_bits(points[corners[0]])), most_cell_corners> bits;
  const auto end = bits.begin() + static_cast<std::ptrdiff_t>(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) bits[i] = point_bits(points[corners[i]]);
  std::sort(bits.begin(), end);
  Hash128 hash;
  for (auto point = bits.begin(); point != end; ++point) {
    for (const std::uint64_t word : *point) hash.take(word);
  }
  return {hash.hi(), hash.lo()};
}

/// Of all cells; corners_of(i): of cell i.
template <class Points, class CornersOf>
Fingerprint fingerprint_of(const Points& points, std::size_t count, CornersOf corners_of) {
  std::vector<Fingerprint> cells;
  cells.reserve(count);
  for (std::size_t i = 0; i < count; ++i) cells.push_back(cell_hash(points, corners_of(i)));
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

Fingerprint fingerprint(const TriangleMesh& mesh) {
  require_corners_in_range(mesh);
  return fingerprint_of(
      mesh.points, mesh.cell_count(), [&](std::size_t i) -> const auto& { return mesh.corners.flat()[i]; });
}
Fingerprint fingerprint(const TetMesh& mesh) {
  require_corners_in_range(mesh);
  return fingerprint_of(
      mesh.points, mesh.cell_count(), [&](std::size_t i) -> const auto& { return mesh.corners.flat()[i]; });
}
Fingerprint fingerprint(const MixedMesh<2>& mesh) {
  require_ids_in_range(mesh);
  return fingerprint_of(mesh.points, mesh.cell_count(), [&](std::size_t i) { return mesh.corners[i]; });
}
Fingerprint fingerprint(const MixedMesh<3>& mesh) {
  require_ids_in_range(mesh);
  return fingerprint_of(mesh.points, mesh.cell_count(), [&](std::size_t i) { return mesh.corners[i]; });
}

}  // namespace mesh
}  // namespace leonhard
