// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/integer_predicates.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "leonhard/kernel/arithmetic/wide_integer.hpp"

namespace leonhard::kernel::integer {
namespace {

// ---- coordinates as integers ----

constexpr int coordinate_bits = 61;  // so that differences are below 2^62

constexpr int exponent_bias = 1023, fraction_bits = 52;

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + exponent_bias) << fraction_bits);
}

/// The numbers times the power of two that brings the largest below 2^61, if that makes all of them integers.
template <std::size_t Count>
[[gnu::always_inline]] inline bool to_integers(std::array<double, Count> numbers,
                                               std::array<std::int64_t, Count>& integers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  if (largest < 0x1p-900) {  // so that the scale below is a normal number
    if (largest == 0) {
      integers.fill(0);
      return true;
    }
    for (double& x : numbers) x *= 0x1p200;
    largest *= 0x1p200;
  }
  const int exponent =
      static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> fraction_bits) - exponent_bias;
  const int shift = coordinate_bits - 1 - exponent;
  const double scale = power_of_two(shift), inverse = power_of_two(-shift);
  bool exact = true;
  for (std::size_t i = 0; i < Count; ++i) {
    integers[i] = static_cast<std::int64_t>(numbers[i] * scale);
    exact &=
        static_cast<double>(integers[i]) * inverse == numbers[i];  // false if the product underflowed, too
  }
  return exact;
}

// ---- products ----

using detail::Int128;

Int128 product(std::int64_t x, std::int64_t y) { return Int128{x} * y; }

WideInteger<4> product(Int128 x, Int128 y) { return WideInteger<2>(x) * WideInteger<2>(y); }

Int128 sum_of_products(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t w) {
  return product(x, y) + product(z, w);
}
Int128 difference_of_products(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t w) {
  return product(x, y) - product(z, w);
}

}  // namespace

std::optional<Sign> orient2d(const Point2& a, const Point2& b, const Point2& c) {
  std::array<std::int64_t, 6> p;
  if (!to_integers(std::array{a.x, a.y, b.x, b.y, c.x, c.y}, p)) return std::nullopt;
  return sign_of(difference_of_products(p[0] - p[4], p[3] - p[5], p[1] - p[5], p[2] - p[4]));
}

std::optional<Sign> incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  std::array<std::int64_t, 8> p;
  if (!to_integers(std::array{a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y}, p)) return std::nullopt;
  std::array<std::int64_t, 6> vectors{p[0] - p[6], p[1] - p[7], p[2] - p[6],
                                      p[3] - p[7], p[4] - p[6], p[5] - p[7]};
  const auto [ux, uy, vx, vy, wx, wy] = vectors;
  const Int128 uu = sum_of_products(ux, ux, uy, uy), vv = sum_of_products(vx, vx, vy, vy),
               ww = sum_of_products(wx, wx, wy, wy);
  const Int128 uv = difference_of_products(ux, vy, uy, vx), vw = difference_of_products(vx, wy, vy, wx),
               wu = difference_of_products(wx, uy, wy, ux);
  return (product(uu, vw) + product(vv, wu) + product(ww, uv)).sign();
}

std::optional<Sign> orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  std::array<std::int64_t, 12> p;
  if (!to_integers(std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z}, p))
    return std::nullopt;
  std::array<std::int64_t, 9> vectors{p[3] - p[0], p[4] - p[1], p[5] - p[2],  p[6] - p[0], p[7] - p[1],
                                      p[8] - p[2], p[9] - p[0], p[10] - p[1], p[11] - p[2]};
  const auto [ux, uy, uz, vx, vy, vz, wx, wy, wz] = vectors;
  const WideInteger<2> yz(difference_of_products(uy, vz, uz, vy)), zx(difference_of_products(uz, vx, ux, vz)),
      xy(difference_of_products(ux, vy, uy, vx));
  return (yz * WideInteger<1>(wx) + zx * WideInteger<1>(wy) + xy * WideInteger<1>(wz)).sign();
}

std::optional<Sign> insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                             const Point3& e) {
  std::array<std::int64_t, 15> p;
  if (!to_integers(std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z}, p))
    return std::nullopt;
  std::array<std::int64_t, 12> vectors;
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = p[i] - p[12 + i % 3];
  const auto [ux, uy, uz, vx, vy, vz, wx, wy, wz, tx, ty, tz] = vectors;
  const WideInteger<2> uv(difference_of_products(ux, vy, uy, vx)), vw(difference_of_products(vx, wy, vy, wx)),
      wt(difference_of_products(wx, ty, wy, tx)), tu(difference_of_products(tx, uy, ty, ux)),
      uw(difference_of_products(ux, wy, uy, wx)), vt(difference_of_products(vx, ty, vy, tx));
  const WideInteger<1> u_z(uz), v_z(vz), w_z(wz), t_z(tz);
  const auto square = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return WideInteger<2>(sum_of_products(x, x, y, y) + product(z, z));
  };
  return ((wt * v_z - vt * w_z + vw * t_z) * square(ux, uy, uz) -
          (wt * u_z + tu * w_z + uw * t_z) * square(vx, vy, vz) +
          (vt * u_z + tu * v_z + uv * t_z) * square(wx, wy, wz) -
          (vw * u_z - uw * v_z + uv * w_z) * square(tx, ty, tz))
      .sign();
}

}  // namespace leonhard::kernel::integer
