// SPDX-License-Identifier: MIT
#include <leonhard/kernel/predicates.hpp>

int main() {
  return leonhard::kernel::orient2d({0, 0}, {1, 0}, {0, 1}) == leonhard::Sign::positive ? 0 : 1;
}
