// SPDX-License-Identifier: MIT
// Prints what the self-test finds in the build that this file is part of.
#include "leonhard/kernel/self_test.hpp"

#include <cstdio>

int main() {
#if defined(__FMA__) && defined(__x86_64__)
  if (!__builtin_cpu_supports("fma")) {
    std::puts("this processor has no fused multiply-add");
    return 0;
  }
#endif
  const auto broken = leonhard::kernel::floating_point_self_test();
  std::puts(broken ? broken->c_str() : "all is well");
}
