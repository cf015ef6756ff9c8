// SPDX-License-Identifier: MIT
#include "leonhard/app/failure.hpp"

#include <new>
#include <system_error>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"

namespace leonhard::app {
namespace {

Failure internal_error(const std::string& words) {
  return {ExitCode::internal_error,
          "internal error: " + words +
              "\nThe fault is the program's, not yours. Please report it with the command and its input."};
}

}  // namespace

Failure failure_of(std::exception_ptr thrown) try {
  std::rethrow_exception(std::move(thrown));
} catch (const InputError& error) {
  return {ExitCode::bad_input, error.what()};
} catch (const OutputError& error) {
  return {ExitCode::bad_input, error.what()};
} catch (const std::system_error& error) {  // a file or folder that the system refuses
  return {ExitCode::bad_input, error.what()};
} catch (const std::bad_alloc&) {
  return {ExitCode::bad_input, "out of memory: this machine has too little for a problem of this size"};
} catch (const std::exception& error) {
  return internal_error(error.what());
} catch (...) {
  return internal_error("an exception without words");
}

}  // namespace leonhard::app
