// SPDX-License-Identifier: MIT
#include "leonhard/mesh/exact_sum.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <vector>

namespace leonhard::mesh {
namespace {

__extension__ using Wide = unsigned __int128;

/// |x| = mantissa 2^exponent.
struct Parts {
  std::uint64_t mantissa;
  int exponent;
};

constexpr int no_number = 0x7ff;

[[noreturn, gnu::cold, gnu::noinline]] void throw_not_finite(double x) {
  throw InputError("ExactSum", words(x) + " in a product", "give finite numbers");
}

/// throws  InputError if x is NaN or infinite
Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (field == 0) return {fraction, -1074};
  if (field == no_number) [[unlikely]]
    throw_not_finite(x);
  return {fraction | (std::uint64_t{1} << 52), field - 1075};
}

constexpr std::uint32_t additions_before_carry = std::uint32_t{1} << 29;

}  // namespace

void ExactSum::add_product(double a, double b) {
  const Parts p = parts_of(a), q = parts_of(b);
  const Wide product = static_cast<Wide>(p.mantissa) * q.mantissa;
  const auto shift = static_cast<unsigned>(p.exponent + q.exponent - lowest_exponent);
  const bool negative = std::signbit(a) != std::signbit(b);

  // The product, 106 bits, moved up by less than a digit: 137 bits, five digits.
  const unsigned up = shift % 32;
  const Wide low = product << up;
  const std::uint64_t high = static_cast<std::uint64_t>(product >> 96) >> (32 - up);
  std::int64_t* digit = digits_.data() + shift / 32;
  for (int i = 0; i < 4; ++i) {
    const auto part = static_cast<std::int64_t>(static_cast<std::uint32_t>(low >> (32 * i)));
    digit[i] += negative ? -part : part;
  }
  digit[4] += negative ? -static_cast<std::int64_t>(high) : static_cast<std::int64_t>(high);

  count_addition();
}

void ExactSum::add_product(double a, double b, double c) {
  const Parts p = parts_of(a), q = parts_of(b), r = parts_of(c);
  const Wide first_two = static_cast<Wide>(p.mantissa) * q.mantissa;
  const auto shift = static_cast<unsigned>(p.exponent + q.exponent + r.exponent - lowest_exponent);
  const std::int64_t sign = (std::signbit(a) != std::signbit(b)) != std::signbit(c) ? -1 : 1;

  // The product, 159 bits, as low + 2^64 high, and each part moved up by less than a digit: 117 and 95 bits become 148
  // and 126, so five digits and four.
  const unsigned up = shift % 32;
  const Wide low = static_cast<Wide>(static_cast<std::uint64_t>(first_two)) * r.mantissa;
  const Wide high = (first_two >> 64) * r.mantissa << up;
  const Wide low_up = low << up;
  const std::uint64_t low_top = static_cast<std::uint64_t>(low >> 96) >> (32 - up);
  std::int64_t* digit = digits_.data() + shift / 32;
  const auto part = [](Wide number, int i) {
    return static_cast<std::int64_t>(static_cast<std::uint32_t>(number >> (32 * i)));
  };
  digit[0] += sign * part(low_up, 0);
  digit[1] += sign * part(low_up, 1);
  digit[2] += sign * (part(low_up, 2) + part(high, 0));
  digit[3] += sign * (part(low_up, 3) + part(high, 1));
  digit[4] += sign * (static_cast<std::int64_t>(low_top) + part(high, 2));
  digit[5] += sign * part(high, 3);
  count_addition();
}

void ExactSum::add_determinant(const Point3& p, const Point3& q, const Point3& r) {
  add_product(p.x, q.y, r.z);
  add_product(p.y, q.z, r.x);
  add_product(p.z, q.x, r.y);
  add_product(-p.z, q.y, r.x);
  add_product(-p.y, q.x, r.z);
  add_product(-p.x, q.z, r.y);
}

void ExactSum::count_addition() {
  if (++additions_ == additions_before_carry) {
    digits_ = carried(digits_);
    additions_ = 1;
  }
}

ExactSum::Digits ExactSum::carried(Digits digits) {
  for (std::size_t i = 0; i + 1 < digit_count; ++i) {
    const std::int64_t carry = digits[i] >> 32;  // rounds down, so the rest is in [0, 2^32)
    digits[i] -= carry * (std::int64_t{1} << 32);
    digits[i + 1] += carry;
  }
  return digits;
}

Sign ExactSum::sign() const {
  const Digits digits = carried(digits_);
  if (digits.back() < 0) return Sign::negative;
  return std::any_of(digits.begin(), digits.end(), [](std::int64_t d) { return d != 0; }) ? Sign::positive
                                                                                          : Sign::zero;
}

mpq_class ExactSum::value() const {
  const bool negative = sign() == Sign::negative;
  Digits digits = digits_;
  if (negative) std::transform(digits.begin(), digits.end(), digits.begin(), std::negate<>());
  digits = carried(digits);

  mpz_class magnitude;
  std::vector<std::uint32_t> low(digits.begin(), digits.end() - 1);
  mpz_import(magnitude.get_mpz_t(), low.size(), -1, sizeof(std::uint32_t), 0, 0, low.data());
  mpz_class top = static_cast<long>(digits.back());
  top <<= 32 * (digit_count - 1);
  magnitude += top;

  mpq_class value(negative ? mpz_class(-magnitude) : magnitude);
  value >>= static_cast<mp_bitcnt_t>(-lowest_exponent);
  return value;
}

}  // namespace leonhard::mesh
