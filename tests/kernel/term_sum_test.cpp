// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/term_sum.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

template <std::size_t Degree, std::size_t Count, std::size_t Factors>
mpq_class exact_sum(const std::array<k::Term<Degree>, Count>& terms,
                    const std::array<double, Factors>& numbers) {
  mpq_class sum = 0;
  for (const auto& term : terms) {
    mpq_class product = term.is_negative ? -1 : 1;
    for (const std::uint8_t factor : term.factors) product *= mpq_class(numbers[factor]);
    sum += product;
  }
  return sum;
}

template <std::size_t Degree, std::size_t Count, std::size_t Factors>
Sign sign(const std::array<k::Term<Degree>, Count>& terms, const std::array<double, Factors>& numbers) {
  std::array<k::WideDouble, Factors> factors;
  for (std::size_t i = 0; i < Factors; ++i) factors[i] = k::wide(numbers[i]);
  return k::sign_of_sum(terms, factors);
}

/// Random terms. Half of the time the second half of them are the first half's with the opposite signs, their factors
/// in another order: a tie, or nearly one if one term is another.
template <std::size_t Degree, std::size_t Count>
std::array<k::Term<Degree>, Count> any_terms(Random& random, int factors) {
  std::array<k::Term<Degree>, Count> terms{};
  for (auto& term : terms) {
    for (auto& factor : term.factors) factor = static_cast<std::uint8_t>(integer(random, 0, factors - 1));
    term.is_negative = integer(random, 0, 1) == 1;
  }
  if (integer(random, 0, 1) == 1) {
    for (std::size_t i = 0; i < Count / 2; ++i) {
      terms[Count / 2 + i] = terms[i];
      terms[Count / 2 + i].is_negative = !terms[i].is_negative;
      std::ranges::shuffle(terms[Count / 2 + i].factors, random);
    }
    if (integer(random, 0, 1) == 1)
      terms[0].factors[0] = static_cast<std::uint8_t>(integer(random, 0, factors - 1));
  }
  return terms;
}

template <std::size_t Degree, std::size_t Count>
void check_any_sums(int calls) {
  Random random(91);
  constexpr std::size_t factors = 7;
  int ties = 0;
  calls = scaled_calls(calls);
  for (int i = 0; i < calls; ++i) {
    const auto terms = any_terms<Degree, Count>(random, factors);
    const int spread = std::array{0, 3, 60, 1000}[static_cast<std::size_t>(integer(random, 0, 3))];
    const int middle = integer(random, spread - 1074, 1024 - spread);
    std::array<double, factors> numbers;
    for (double& x : numbers) x = any_exponent(random, middle - spread, middle + spread);
    if (integer(random, 0, 3) == 0) numbers[0] = 0;
    const Sign truth = leonhard::sign_of(exact_sum(terms, numbers));
    CAPTURE(i);
    REQUIRE(sign(terms, numbers) == truth);
    ties += truth == Sign::zero;
  }
  CHECK(ties > calls / 20);
  CHECK(ties < calls / 2);
}

}  // namespace

TEST_CASE("signs_of_sums_of_terms_agree_with_rational_arithmetic") {
  check_any_sums<1, 12>(4'000);
  check_any_sums<2, 18>(4'000);
  check_any_sums<4, 72>(1'000);
  check_any_sums<5, 480>(300);
}

TEST_CASE("a_sum_of_terms_is_not_decided_while_the_rest_can_turn_it") {
  // A number and fifteen others, each `drop` exponents lower, that together are more from drop = 4 on down.
  std::array<k::Term<1>, 16> terms{};
  for (auto& term : terms) term = {{1}, true};
  terms[0] = {{0}, false};
  const double below_two = std::nextafter(2.0, 0.0);
  for (int drop = -4; drop < 70; ++drop) {
    CAPTURE(drop);
    CHECK(sign(terms, std::array{1.0, std::ldexp(below_two, -drop)}) ==
          (drop <= 4 ? Sign::negative : Sign::positive));
  }
  // The same with the last bit that is left of a cancellation: 1 + 2^-52 - 1.
  std::array<k::Term<1>, 17> cancelling{};
  for (auto& term : cancelling) term = {{2}, true};
  cancelling[0] = {{0}, false};
  cancelling[1] = {{1}, true};
  const double above_one = std::nextafter(1.0, 2.0);
  for (int drop = 40; drop < 130; ++drop) {
    CAPTURE(drop);
    CHECK(sign(cancelling, std::array{above_one, 1.0, std::ldexp(below_two, -drop)}) ==
          (drop <= 56 ? Sign::negative : Sign::positive));
  }
}

TEST_CASE("a_sum_of_as_many_of_the_largest_terms_as_there_may_be_keeps_its_sign") {
  std::array<k::Term<5>, 480> terms{};
  for (bool is_negative : {false, true}) {
    for (auto& term : terms) term = {{0, 1, 2, 3, 4}, is_negative};
    std::array<double, 5> numbers;
    numbers.fill(std::numeric_limits<double>::max());
    CHECK(sign(terms, numbers) == (is_negative ? Sign::negative : Sign::positive));
    numbers.fill(std::numeric_limits<double>::denorm_min());
    CHECK(sign(terms, numbers) == (is_negative ? Sign::negative : Sign::positive));
    numbers[3] = 0;
    CHECK(sign(terms, numbers) == Sign::zero);
  }
}
