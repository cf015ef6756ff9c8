// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/point.hpp"

/// Easy and hard points on which predicates are timed.
namespace leonhard::benching {

using Random = std::mt19937_64;
constexpr std::size_t point_count = 4096;  // a power of two
constexpr std::size_t call_count = 4096;

inline double unit(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

/// Points that fit the second-level cache, and calls of predicates as indices of Count of them, at random: as a mesher
/// reaches them.
template <class Point, std::size_t Count>
struct Input {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, Count>> calls;
};

template <class Point, std::size_t Count>
using NamedInputs = std::vector<std::pair<std::string, Input<Point, Count>>>;

/// Calls that name no point twice.
template <std::size_t Count>
std::vector<std::array<std::uint32_t, Count>> random_calls(std::size_t calls, std::size_t points,
                                                           Random& random) {
  constexpr auto count = static_cast<std::uint32_t>(Count);
  std::uniform_int_distribution<std::uint32_t> any(0, static_cast<std::uint32_t>(points / count) - 1);
  std::vector<std::array<std::uint32_t, Count>> drawn(calls);
  for (auto& call : drawn)
    for (std::uint32_t j = 0; j < count; ++j) call[j] = count * any(random) + j;  // so they differ
  return drawn;
}

/// Points drawn one after another.
template <class Point, std::size_t Count, class Draw>
Input<Point, Count> random_input(Draw draw) {
  Random random(1);
  Input<Point, Count> input;
  for (std::size_t i = 0; i < point_count; ++i) input.points.push_back(draw(random));
  input.calls = random_calls<Count>(call_count, point_count, random);
  return input;
}

/// A number of any binary exponent that doubles have.
inline double any_exponent(Random& random) {
  return std::ldexp(unit(random), std::uniform_int_distribution<int>(-1074, 1024)(random));
}

/// The same, if a few small factors make no subnormal number and no infinity of it.
inline double normal_of_any_exponent(Random& random) {
  return std::ldexp(1 + unit(random), std::uniform_int_distribution<int>(-1000, 1000)(random));
}

/// An integer below `end`.
inline double small_integer(Random& random, int end) {
  return std::uniform_int_distribution<int>(0, end - 1)(random);
}

// ---- the plane ----

/// Cells of a 64 x 64 grid of the given spacing: each call asks about the four corners of one cell, always a tie of
/// incircle.
inline Input<Point2, 4> grid_cells(double origin, double spacing) {
  Input<Point2, 4> input;
  for (std::uint32_t row = 0; row < 64; ++row)
    for (std::uint32_t column = 0; column < 64; ++column)
      input.points.push_back({origin + spacing * column, origin + spacing * row});
  for (std::uint32_t row = 0; row + 1 < 64; ++row)
    for (std::uint32_t column = 0; column + 1 < 64; ++column) {
      const std::uint32_t first = row * 64 + column;
      input.calls.push_back({first, first + 1, first + 65, first + 64});
    }
  return input;
}

inline NamedInputs<Point2, 4> inputs_of_the_plane() {
  const auto drawn = [](auto draw) { return random_input<Point2, 4>(draw); };
  return {
      {"uniform", drawn([](Random& r) {
         return Point2{unit(r), unit(r)};
       })},
      {"integer_points", drawn([](Random& r) {
         return Point2{small_integer(r, 8), small_integer(r, 8)};
       })},
      {"integer_grid", grid_cells(0, 1)},
      {"tenths_grid", grid_cells(1.0 / 3, 0.1)},
      {"tiny_grid", grid_cells(0, 0x1p-1074)},
      {"line", drawn([](Random& r) {
         const double t = unit(r);
         return Point2{t, 0.1 * t};
       })},
      {"circle", drawn([](Random& r) {
         const double angle_rad = 6.283185307179586 * unit(r);
         return Point2{std::cos(angle_rad), std::sin(angle_rad)};
       })},
      {"mixed_exponents", drawn([](Random& r) {
         return Point2{any_exponent(r), any_exponent(r)};
       })},
      {"mixed_line", drawn([](Random& r) {
         const double x = normal_of_any_exponent(r);
         return Point2{x, 4 * x};
       })},
  };
}

// ---- space ----

/// Cells of a 16 x 16 x 16 grid of the given spacing: each call asks about five corners of one cell, four of them in
/// one face: always a tie, of orient3d and of insphere.
inline Input<Point3, 5> grid_cells_of_space(double origin, double spacing) {
  constexpr std::uint32_t side = 16;
  Input<Point3, 5> input;
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t z = 0; z < side; ++z)
        input.points.push_back({origin + spacing * x, origin + spacing * y, origin + spacing * z});
  for (std::uint32_t x = 0; x + 1 < side; ++x)
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t z = 0; z + 1 < side; ++z) {
        const std::uint32_t first = (x * side + y) * side + z;
        input.calls.push_back({first, first + 1, first + side, first + side + 1, first + side * side});
      }
  return input;
}

inline NamedInputs<Point3, 5> inputs_of_space() {
  const auto drawn = [](auto draw) { return random_input<Point3, 5>(draw); };
  return {
      {"uniform", drawn([](Random& r) {
         return Point3{unit(r), unit(r), unit(r)};
       })},
      {"integer_points", drawn([](Random& r) {
         return Point3{small_integer(r, 4), small_integer(r, 4), small_integer(r, 4)};
       })},
      {"integer_grid", grid_cells_of_space(0, 1)},
      {"tenths_grid", grid_cells_of_space(1.0 / 3, 0.1)},
      {"tiny_grid", grid_cells_of_space(0, 0x1p-1074)},
      {"plane", drawn([](Random& r) {
         const double x = unit(r), y = unit(r);
         return Point3{x, y, 0.1 * x + 0.3 * y};
       })},
      {"sphere", drawn([](Random& r) {
         const Vec3 v{unit(r) - 0.5, unit(r) - 0.5, unit(r) - 0.5};
         return Point3{} + (1 / norm(v)) * v;
       })},
      {"mixed_exponents", drawn([](Random& r) {
         return Point3{any_exponent(r), any_exponent(r), any_exponent(r)};
       })},
      {"mixed_plane", drawn([](Random& r) {
         const double x = normal_of_any_exponent(r);
         return Point3{x, normal_of_any_exponent(r), 4 * x};
       })},
  };
}

}  // namespace leonhard::benching
