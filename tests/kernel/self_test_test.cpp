// SPDX-License-Identifier: MIT
#include "leonhard/kernel/self_test.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <initializer_list>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace k = leonhard::kernel;

TEST_CASE("the_self_test_passes_in_this_build") {
  const auto broken = k::floating_point_self_test();
  CAPTURE(broken.value_or(""));
  CHECK(!broken);
}

TEST_CASE("the_self_test_notices_every_rounding_mode_but_to_nearest") {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto broken = k::floating_point_self_test();
    std::fesetround(FE_TONEAREST);
    REQUIRE(broken);
    CHECK(broken->find("rounding mode") != std::string::npos);
  }
}

#ifdef __SSE2__
TEST_CASE("the_self_test_notices_flushed_subnormals") {
  constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040;  // MXCSR bits FTZ and DAZ
  for (const unsigned bit : {flush_results, flush_operands}) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | bit);
    const auto broken = k::floating_point_self_test();
    _mm_setcsr(before);
    REQUIRE(broken);
    CHECK(broken->find("subnormal") != std::string::npos);
  }
}
#endif
