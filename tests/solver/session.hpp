// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::test {

/// Start PETSc, once for the test program.
void start_petsc();

}  // namespace leonhard::test
