// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace leonhard {

/// PETSc's life, at most one at a time and made once, by the program or a test's main: starts PETSc (and MPI
/// with it, in one process, no mpirun) without command line, signal handlers or output, and ends both in the
/// destructor. Does nothing where PETSc is already running.
class PetscSession {
 public:
  /// throws  std::runtime_error when PETSc cannot start
  PetscSession();
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;

 private:
  bool owner_ = false;
};

}  // namespace leonhard
