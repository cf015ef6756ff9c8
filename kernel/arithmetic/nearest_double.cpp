// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/nearest_double.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leonhard::kernel {
namespace {

/// numerator / denominator 2^-shift rounded to an integer, ties to even; both positive.
mpz_class rounded_quotient(mpz_class numerator, mpz_class denominator, long shift) {
  if (shift < 0) numerator <<= static_cast<mp_bitcnt_t>(-shift);
  if (shift > 0) denominator <<= static_cast<mp_bitcnt_t>(shift);
  mpz_class quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const int to_half = cmp(mpz_class(2 * remainder), denominator);
  if (to_half > 0 || (to_half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) ++quotient;
  return quotient;
}

/// The exponent of the highest bit of the quotient of two positive integers.
long highest_bit(const mpz_class& numerator, const mpz_class& denominator) {
  const auto bits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const long upper = bits(numerator) - bits(denominator);  // this or one less
  const auto shifted = [](const mpz_class& n, long by) {
    return mpz_class(n << static_cast<mp_bitcnt_t>(std::max(by, 0L)));
  };
  return shifted(numerator, -upper) >= shifted(denominator, upper) ? upper : upper - 1;
}

}  // namespace

double nearest_double(const mpz_class& numerator, const mpz_class& denominator, int exponent) {
  const int sign = sgn(numerator) * sgn(denominator);
  if (sign == 0) return 0;
  const mpz_class n = abs(numerator), d = abs(denominator);
  // The last of 53 bits, or the last of a subnormal number.
  const long last = std::max(highest_bit(n, d) + exponent - 52, -1074L);
  if (last > 1023 - 52) return sign * std::numeric_limits<double>::infinity();
  const double mantissa = rounded_quotient(n, d, last - exponent).get_d();  // at most 2^53, so exact
  return sign * std::ldexp(mantissa, static_cast<int>(last));
}

}  // namespace leonhard::kernel
