// SPDX-License-Identifier: MIT
#include "tests/solver/session.hpp"

#include "leonhard/solver/linear_solver.hpp"

namespace leonhard::test {

void start_petsc() { static const PetscSession session; }

}  // namespace leonhard::test

// MPI keeps what it allocated when it started; that is no leak of ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libmpi\nleak:libopen-rte\nleak:libopen-pal\nleak:libpmix\nleak:libevent\nleak:libhwloc\nleak:"
         "mca_\nleak:libpetsc\n";
}
