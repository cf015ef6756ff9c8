// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "leonhard/mesh/compressed_rows.hpp"

namespace leonhard {

/// PETSc's life, at most one at a time and made once, by the program or a test's main: starts PETSc (and MPI with it,
/// in one process, no mpirun) without command line, signal handlers or output, and ends both in the destructor. Does
/// nothing where PETSc is already running, but the first session must outlive whatever solves.
class PetscSession {
 public:
  /// throws  std::runtime_error when PETSc cannot start; std::logic_error where PETSc or MPI has run and ended in this
  ///         process: neither starts a second time
  PetscSession();
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;

 private:
  bool owner_ = false;
};

namespace solver {

enum class LinearOutcome { reached, iteration_limit, breakdown, stopped };

/// The word for it, e.g. "reached".
[[nodiscard]] constexpr std::string_view to_string(LinearOutcome outcome) {
  switch (outcome) {
    case LinearOutcome::reached:
      return "reached";
    case LinearOutcome::iteration_limit:
      return "iteration_limit";
    case LinearOutcome::breakdown:
      return "breakdown";
    case LinearOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct LinearReport {
  LinearOutcome outcome{};
  int iterations{};
  double relative_residual{};  ///< last norm of b - A x over the first, as GMRES has it; not preconditioned
};

struct LinearOptions {
  double relative_tolerance = 0.1;
  int max_iterations = 30;  ///< also GMRES's restart length
};

/// y = A x for vectors of as many numbers a row as a block has rows.
using LinearOperator = std::function<void(std::span<const double> x, std::span<double> y)>;

/// The columns of each row's blocks; numbers as PETSc has them.
using BlockPattern = CompressedRows<std::int32_t, std::int32_t>;

/// A sparse matrix of square blocks, its incomplete factors and GMRES; hides PETSc. One process; the distributed one
/// will be another class with this interface.
class BlockSystem {
 public:
  /// pattern  of the blocks, copied: columns ascending in each row, every row with its diagonal
  /// rows     of a block, >= 1
  /// fill     levels of fill of the incomplete factors, >= 0. With 0 they take the matrix's own place: half the memory, but
  ///          solve needs a product
  /// throws   std::logic_error without a PetscSession, InputError naming the row that is not so
  explicit BlockSystem(const BlockPattern& pattern, int rows = 4, int fill = 1);
  ~BlockSystem();
  BlockSystem(BlockSystem&&) noexcept;
  BlockSystem& operator=(BlockSystem&&) noexcept;

  /// The matrix, to be written whole before each factor(): rows^2 numbers a block of the pattern, column by column.
  [[nodiscard]] std::span<double> blocks();

  /// Make the incomplete factors of what blocks() holds, in the rows' own order.
  /// returns  false where a pivot block is singular or a number is not finite; other blocks may be written then
  [[nodiscard]] bool factor();

  /// The same of blocks that lie elsewhere; may be longer, InputError if shorter.
  [[nodiscard]] bool factor(std::span<const double> blocks);

  /// Solve A x = b by GMRES, preconditioned from the right by the last factors, started at 0.
  /// product  A; empty: the matrix itself, std::logic_error where the factors took its place. What it throws ends the solve and passes through to the caller
  /// throws   std::runtime_error naming the call of PETSc that failed
  [[nodiscard]] LinearReport solve(std::span<const double> b, std::span<double> x,
                                   const LinearOptions& options, const LinearOperator& product = {},
                                   std::stop_token stop = {});

 private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
};

}  // namespace solver
}  // namespace leonhard
