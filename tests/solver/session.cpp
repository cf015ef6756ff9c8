// SPDX-License-Identifier: MIT
#include "tests/solver/session.hpp"

#include "leonhard/solver/linear_solver.hpp"

// The leak sanitizer's switches, where it is linked in.
extern "C" void __lsan_disable() __attribute__((weak));
extern "C" void __lsan_enable() __attribute__((weak));

namespace leonhard::test {
namespace {

/// PETSc, MPI and the plug-ins that they load keep what they allocate when they start and end; these are no leaks of
/// ours, and their modules are gone when the sanitizer looks for names to suppress.
class Session {
 public:
  Session() {
    if (__lsan_disable) __lsan_disable();
    petsc_ = new PetscSession;
    if (__lsan_enable) __lsan_enable();
  }
  ~Session() {
    if (__lsan_disable) __lsan_disable();
    delete petsc_;
    if (__lsan_enable) __lsan_enable();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  PetscSession* petsc_;
};

}  // namespace

void start_petsc() { static const Session session; }

}  // namespace leonhard::test
