// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "leonhard/kernel/sign.hpp"

#ifndef __SIZEOF_INT128__
#error "leonhard: needs a compiler with __int128, such as GCC or clang for a 64-bit processor"
#endif

/// Integers of a fixed number of 64-bit limbs, for determinants of integer coordinates: no memory, and no loop whose
/// length depends on the data.
namespace leonhard::kernel {

namespace detail {

__extension__ using Uint128 = unsigned __int128;
__extension__ using Int128 = __int128;

inline std::uint64_t low_half(Uint128 x) { return static_cast<std::uint64_t>(x); }
inline std::uint64_t high_half(Uint128 x) { return static_cast<std::uint64_t>(x >> 64); }

}  // namespace detail

/// A signed integer of 64 * Limbs bits in two's complement.
///
/// A product has room for every value. Sums and differences wrap around, so that a sum which fits is right whatever
/// its partial sums did.
template <std::size_t Limbs>
class WideInteger {
 public:
  WideInteger() = default;
  explicit WideInteger(std::int64_t value) {
    limbs_.fill(static_cast<std::uint64_t>(value >> 63));
    limbs_[0] = static_cast<std::uint64_t>(value);
  }
  explicit WideInteger(detail::Int128 value) {
    static_assert(Limbs == 2);
    limbs_ = {detail::low_half(static_cast<detail::Uint128>(value)),
              detail::high_half(static_cast<detail::Uint128>(value))};
  }

  /// Least significant first.
  [[nodiscard]] std::uint64_t limb(std::size_t i) const { return limbs_[i]; }
  [[nodiscard]] std::uint64_t& limb(std::size_t i) { return limbs_[i]; }

  [[nodiscard]] bool is_negative() const { return static_cast<std::int64_t>(limbs_[Limbs - 1]) < 0; }

  [[nodiscard]] Sign sign() const {
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs_) any |= limb;
    return is_negative() ? Sign::negative : any == 0 ? Sign::zero : Sign::positive;
  }

  /// The number of bits but for the sign: of the value if it is not negative, else of -value - 1.
  [[nodiscard]] int bit_width() const {
    const std::uint64_t sign_bits = is_negative() ? ~std::uint64_t{0} : 0;
    for (std::size_t i = Limbs; i-- > 0;)
      if (const std::uint64_t limb = limbs_[i] ^ sign_bits; limb != 0)
        return static_cast<int>(64 * i) + static_cast<int>(std::bit_width(limb));
    return 0;
  }

  /// Multiplies by 2^places, modulo 2^(64 Limbs); 0 <= places < 64 Limbs.
  void shift_left(int places) {
    const auto limbs = static_cast<std::size_t>(places / 64);
    const int bits = places % 64;
    for (std::size_t i = Limbs; i-- > 0;) {
      const std::uint64_t upper = i >= limbs ? limbs_[i - limbs] : 0;
      const std::uint64_t lower = i >= limbs + 1 ? limbs_[i - limbs - 1] : 0;
      limbs_[i] = bits == 0 ? upper : upper << bits | lower >> (64 - bits);
    }
  }

  /// Multiplies a value of which only the first Used limbs are not 0; the product must fit.
  template <std::size_t Used>
  void multiply(std::uint64_t factor) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < Used; ++i) {
      const detail::Uint128 partial = detail::Uint128{limbs_[i]} * factor + carry;
      limbs_[i] = detail::low_half(partial);
      carry = detail::high_half(partial);
    }
    if constexpr (Used < Limbs) limbs_[Used] = carry;
  }

 private:
  std::array<std::uint64_t, Limbs> limbs_;
};

namespace detail {

/// Subtracts value & mask from x at limb `from` on, modulo 2^(64 N).
template <std::size_t N, std::size_t M>
void subtract(WideInteger<N>& x, const WideInteger<M>& value, std::size_t from, std::uint64_t mask) {
  std::uint64_t borrow = 0;
  for (std::size_t i = from; i < N; ++i) {
    const std::uint64_t term = i - from < M ? value.limb(i - from) & mask : 0;
    const Uint128 difference = Uint128{x.limb(i)} - term - borrow;
    x.limb(i) = low_half(difference);
    borrow = high_half(difference) & 1;
  }
}

}  // namespace detail

template <std::size_t N>
[[nodiscard]] WideInteger<N> operator+(const WideInteger<N>& x, const WideInteger<N>& y) {
  WideInteger<N> sum;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const detail::Uint128 partial = detail::Uint128{x.limb(i)} + y.limb(i) + carry;
    sum.limb(i) = detail::low_half(partial);
    carry = detail::high_half(partial);
  }
  return sum;
}

template <std::size_t N>
[[nodiscard]] WideInteger<N> operator-(const WideInteger<N>& x, const WideInteger<N>& y) {
  WideInteger<N> difference = x;
  detail::subtract(difference, y, 0, ~std::uint64_t{0});
  return difference;
}

/// The product of the limbs as unsigned numbers; then, as a negative x stands for x + 2^(64 N), less y 2^(64 N), and the
/// same with x and y exchanged.
template <std::size_t N, std::size_t M>
[[nodiscard]] WideInteger<N + M> operator*(const WideInteger<N>& x, const WideInteger<M>& y) {
  WideInteger<N + M> product(std::int64_t{0});
  for (std::size_t j = 0; j < M; ++j) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const detail::Uint128 partial = detail::Uint128{x.limb(i)} * y.limb(j) + product.limb(i + j) + carry;
      product.limb(i + j) = detail::low_half(partial);
      carry = detail::high_half(partial);
    }
    product.limb(j + N) = carry;
  }
  detail::subtract(product, y, N, x.is_negative() ? ~std::uint64_t{0} : 0);
  detail::subtract(product, x, M, y.is_negative() ? ~std::uint64_t{0} : 0);
  return product;
}

}  // namespace leonhard::kernel
