// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

#include "leonhard/kernel/point.hpp"

/// What fuzz targets share: bytes read as numbers, and findings printed as C++ to be moved into a test.
namespace leonhard::fuzzing {

/// Reads an input from its front; past the end it reads zeros.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size(); }

  template <class T>
  [[nodiscard]] T take() {
    T value{};
    const std::size_t count = std::min(sizeof(T), bytes_.size());
    std::memcpy(&value, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
    return value;
  }

  /// Any finite double; NaN and infinities lose an exponent bit.
  [[nodiscard]] double finite() {
    const auto bits = take<std::uint64_t>();
    const double value = std::bit_cast<double>(bits);
    return std::isfinite(value) ? value : std::bit_cast<double>(bits & ~(std::uint64_t{1} << 62));
  }

  /// A small integer of one byte: makes repeated, collinear and cocircular points likely.
  [[nodiscard]] double small() { return take<std::int8_t>(); }

  /// A small multiple of 0.1, a few units in the last place off: makes nearly collinear and cocircular points.
  [[nodiscard]] double nearly_tenths() {
    const double tenths = 0.1 * small();
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(tenths) + take<std::uint8_t>() % 4);
  }

  /// A small integer times any power of two: makes ties of mixed exponents.
  [[nodiscard]] double apart() {
    const double integer = small();
    return std::ldexp(integer, take<std::uint16_t>() % 2090 - 1074);
  }

  /// A number of one kind: 0 finite, 1 small, 2 nearly_tenths, repeated below 192; apart from there on.
  [[nodiscard]] double coordinate(unsigned kind) {
    if (kind >= 192) return apart();
    return kind % 3 == 0 ? finite() : kind % 3 == 1 ? small() : nearly_tenths();
  }

  /// A point whose coordinates are of one kind.
  [[nodiscard]] Point2 point(unsigned kind) {
    const double x = coordinate(kind);
    return {x, coordinate(kind)};
  }
  [[nodiscard]] Point3 point3(unsigned kind) {
    const double x = coordinate(kind), y = coordinate(kind);
    return {x, y, coordinate(kind)};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// Ends the program, so that libFuzzer keeps the input, after printing the points as C++ source.
[[noreturn]] inline void report(const char* broken, std::span<const Point2> points) {
  std::fprintf(stderr, "\n%s\n  const std::vector<Point2> points{", broken);
  for (const Point2 p : points) std::fprintf(stderr, "{%a, %a}, ", p.x, p.y);
  std::fprintf(stderr, "};\n");
  std::abort();
}
[[noreturn]] inline void report(const char* broken, std::span<const Point3> points) {
  std::fprintf(stderr, "\n%s\n  const std::vector<Point3> points{", broken);
  for (const Point3& p : points) std::fprintf(stderr, "{%a, %a, %a}, ", p.x, p.y, p.z);
  std::fprintf(stderr, "};\n");
  std::abort();
}

}  // namespace leonhard::fuzzing
