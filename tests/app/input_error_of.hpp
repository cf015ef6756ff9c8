// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

/// What the InputError says that the work throws; "" if it throws none.
template <class Work>
std::string input_error_of(Work&& work) {
  try {
    (void)std::forward<Work>(work)();
  } catch (const leonhard::InputError& error) {
    return error.what();
  }
  return "";
}
