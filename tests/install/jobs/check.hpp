// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>

/// What a program claims; it ends with the number of claims that failed.
class Claims {
 public:
  void operator()(bool holds, const char* words) {
    if (!holds) std::fprintf(stderr, "not true: %s\n", words);
    failed_ += !holds;
  }
  [[nodiscard]] int failed() const { return failed_; }

 private:
  int failed_ = 0;
};
