// SPDX-License-Identifier: MIT
#include "leonhard/app/failure.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <new>
#include <stdexcept>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

template <class Thrown>
Failure failure_by(const Thrown& thrown) {
  return failure_of(std::make_exception_ptr(thrown));
}

}  // namespace

TEST_CASE("bad_input_is_told_in_its_own_words") {
  const Failure failure = failure_by(InputError("wing.dat:4", "x is no number", "correct it"));
  CHECK(failure.code == ExitCode::bad_input);
  CHECK(failure.message == "wing.dat:4: x is no number; correct it");
}

TEST_CASE("what_the_system_refuses_and_too_little_memory_are_no_internal_errors") {
  CHECK(failure_by(OutputError("a.su2", "No space left")).code == ExitCode::bad_input);
  CHECK(
      failure_by(std::filesystem::filesystem_error("no", std::make_error_code(std::errc::permission_denied)))
          .code == ExitCode::bad_input);
  const Failure memory = failure_by(std::bad_alloc());
  CHECK(memory.code == ExitCode::bad_input);
  CHECK(memory.message.starts_with("out of memory"));
}

TEST_CASE("an_exception_of_ours_is_an_internal_error_with_a_code_of_its_own") {
  const Failure failure = failure_by(std::logic_error("make a session first"));
  CHECK(static_cast<int>(failure.code) == 70);
  CHECK(failure.message.starts_with("internal error: make a session first\n"));
  CHECK(failure.message.find("report") != std::string::npos);
  CHECK(failure_by(std::out_of_range("vector")).code == ExitCode::internal_error);
  CHECK(failure_by(42).code == ExitCode::internal_error);
}
