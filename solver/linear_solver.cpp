// SPDX-License-Identifier: MIT
#include "leonhard/solver/linear_solver.hpp"

#include <petscksp.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard {
namespace {

static_assert(sizeof(PetscInt) == sizeof(std::int32_t), "PETSc with 32-bit indices");
static_assert(sizeof(PetscScalar) == sizeof(double), "PETSc with real scalars");

void check(PetscErrorCode code, const char* what) {
  if (code != 0)
    throw std::runtime_error(std::string("PETSc: ") + what + " failed with error " + std::to_string(code));
}

/// Whether it ran and ended: neither PETSc nor MPI starts a second time.
bool petsc_has_ended() {
  PetscBool finalized = PETSC_FALSE;
  PetscFinalized(&finalized);
  int mpi_finalized = 0;
  MPI_Finalized(&mpi_finalized);
  return finalized == PETSC_TRUE || mpi_finalized != 0;
}

void require_size(const char* name, std::size_t size, std::size_t least) {
  if (size < least)
    throw InputError(name, std::to_string(size) + " numbers, the system has " + std::to_string(least));
}

bool petsc_runs() {
  PetscBool initialized = PETSC_FALSE, finalized = PETSC_FALSE;
  PetscInitialized(&initialized);
  PetscFinalized(&finalized);
  return initialized && !finalized;
}

}  // namespace

PetscSession::PetscSession() {
  if (petsc_runs()) return;
  if (petsc_has_ended())
    throw std::logic_error(
        "PetscSession: PETSc and MPI have ended in this process and cannot start again; keep one session "
        "alive for as "
        "long as anything is solved");
  check(PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"), "PetscOptionsSetValue");
  check(PetscInitializeNoArguments(), "PetscInitialize");
  owner_ = true;
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr), "PetscPushErrorHandler");
}

PetscSession::~PetscSession() {
  if (owner_ && petsc_runs()) PetscFinalize();
}

namespace solver {

struct BlockSystem::Petsc {
  std::size_t block_numbers{};  ///< numbers in the matrix
  std::size_t size{};           ///< numbers in a vector
  Mat matrix = nullptr, shell = nullptr;
  KSP ksp = nullptr;
  Vec x = nullptr, b = nullptr;
  const LinearOperator* product = nullptr;
  std::exception_ptr thrown;  ///< by the product: kept while PETSc's C frames are left by an error code
  std::stop_token stop;
  bool stopped = false, has_factors = false;
  bool in_place = false;  ///< the factors are written over the matrix
  double first_norm = 0, last_norm = 0, relative_tolerance = 0;
  PetscInt max_iterations = 0;

  struct Callbacks;

  ~Petsc() {
    if (!petsc_runs()) return;
    KSPDestroy(&ksp);
    MatDestroy(&shell);
    MatDestroy(&matrix);
    VecDestroy(&x);
    VecDestroy(&b);
  }
};

/// What PETSc calls back: whether to go on, and the product with a vector.
struct BlockSystem::Petsc::Callbacks {
  static PetscErrorCode judge(KSP /*ksp*/, PetscInt iteration, PetscReal norm, KSPConvergedReason* reason,
                              void* context) {
    auto& self = *static_cast<Petsc*>(context);
    if (iteration == 0) self.first_norm = norm;
    self.last_norm = norm;
    *reason = KSP_CONVERGED_ITERATING;
    if (self.stop.stop_requested()) {
      self.stopped = true;
      *reason = KSP_DIVERGED_BREAKDOWN;
    } else if (!(norm <= 1e300)) {
      *reason = KSP_DIVERGED_NANORINF;
    } else if (norm <= self.relative_tolerance * self.first_norm) {
      *reason = KSP_CONVERGED_RTOL;
    } else if (iteration >= self.max_iterations) {
      *reason = KSP_DIVERGED_ITS;
    }
    return 0;
  }

  static PetscErrorCode multiply(Mat shell, Vec x, Vec y) {
    void* context = nullptr;
    PetscErrorCode code = MatShellGetContext(shell, static_cast<void*>(&context));
    if (code != 0) return code;
    auto& self = *static_cast<Petsc*>(context);
    const PetscScalar* from = nullptr;
    PetscScalar* to = nullptr;
    if ((code = VecGetArrayRead(x, &from)) != 0) return code;
    if ((code = VecGetArray(y, &to)) != 0) return code;
    PetscErrorCode failed = 0;
    try {
      (*self.product)({from, self.size}, {to, self.size});
    } catch (...) {
      self.thrown = std::current_exception();
      failed = PETSC_ERR_USER;
    }
    if ((code = VecRestoreArray(y, &to)) != 0) return code;
    if ((code = VecRestoreArrayRead(x, &from)) != 0) return code;
    return failed;
  }
};

namespace {

/// throws  InputError unless the rows are as BlockSystem's header wants them
void check_pattern(const BlockPattern& pattern) {
  const auto refuse = [](std::size_t row, const char* problem) {
    throw InputError("row " + std::to_string(row), problem,
                     "give ascending columns, the diagonal among them");
  };
  if (pattern.empty()) throw InputError("pattern", "has no rows", "give one row at least");
  for (std::size_t row = 0; row < pattern.size(); ++row) {
    if (pattern.offsets()[row + 1] < pattern.offsets()[row]) refuse(row, "its columns begin after they end");
    const std::span<const std::int32_t> columns = pattern[row];
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] < 0 || std::cmp_greater_equal(columns[k], pattern.size()))
        refuse(row, "a column is out of range");
      if (k > 0 && columns[k] <= columns[k - 1]) refuse(row, "its columns do not ascend");
    }
    if (!std::binary_search(columns.begin(), columns.end(), static_cast<std::int32_t>(row)))
      refuse(row, "it lacks its diagonal");
  }
}

}  // namespace

BlockSystem::BlockSystem(const BlockPattern& pattern, int block_rows, int fill)
    : petsc_(std::make_unique<Petsc>()) {
  if (!petsc_runs()) throw std::logic_error("BlockSystem: make a PetscSession first");
  check_pattern(pattern);
  if (block_rows < 1) throw InputError("block", "has " + std::to_string(block_rows) + " rows", "give at least one");
  if (fill < 0) throw InputError("fill", "is " + std::to_string(fill), "give a number of levels from 0");
  const PetscInt width = block_rows;
  Petsc& self = *petsc_;
  self.in_place = fill == 0;
  self.block_numbers = static_cast<std::size_t>(width) * static_cast<std::size_t>(width) * pattern.link_count();
  const auto rows = static_cast<PetscInt>(pattern.size()), size = width * rows;
  self.size = static_cast<std::size_t>(size);
  check(MatCreate(PETSC_COMM_SELF, &self.matrix), "MatCreate");
  check(MatSetSizes(self.matrix, size, size, size, size), "MatSetSizes");
  check(MatSetType(self.matrix, MATSEQBAIJ), "MatSetType");
  check(MatSeqBAIJSetPreallocationCSR(self.matrix, width, pattern.offsets().data(), pattern.links().data(), nullptr),
        "MatSeqBAIJSetPreallocationCSR");
  check(MatCreateShell(PETSC_COMM_SELF, size, size, size, size, petsc_.get(), &self.shell), "MatCreateShell");
  check(
      MatShellSetOperation(self.shell, MATOP_MULT, reinterpret_cast<void (*)()>(&Petsc::Callbacks::multiply)),
      "MatShellSetOperation");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, width, size, nullptr, &self.x), "VecCreate");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, width, size, nullptr, &self.b), "VecCreate");
  check(KSPCreate(PETSC_COMM_SELF, &self.ksp), "KSPCreate");
  PC pc = nullptr;
  check(KSPGetPC(self.ksp, &pc), "KSPGetPC");
  check(PCSetType(pc, PCILU), "PCSetType");
  check(PCFactorSetMatOrderingType(pc, MATORDERINGNATURAL), "PCFactorSetMatOrderingType");
  check(PCFactorSetLevels(pc, fill), "PCFactorSetLevels");
  check(PCFactorSetUseInPlace(pc, self.in_place ? PETSC_TRUE : PETSC_FALSE), "PCFactorSetUseInPlace");
  check(KSPSetType(self.ksp, KSPGMRES), "KSPSetType");
  check(KSPSetPCSide(self.ksp, PC_RIGHT), "KSPSetPCSide");
  check(KSPSetNormType(self.ksp, KSP_NORM_UNPRECONDITIONED), "KSPSetNormType");
  check(KSPSetConvergenceTest(self.ksp, &Petsc::Callbacks::judge, petsc_.get(), nullptr),
        "KSPSetConvergenceTest");
}

BlockSystem::~BlockSystem() = default;
BlockSystem::BlockSystem(BlockSystem&&) noexcept = default;
BlockSystem& BlockSystem::operator=(BlockSystem&&) noexcept = default;

namespace {

/// Zero times a number is zero, but NaN for NaN and infinity.
bool all_finite(std::span<const double> numbers) {
  double sum = 0;
  for (const double number : numbers) sum += 0 * number;
  return sum == 0;
}

}  // namespace

std::span<double> BlockSystem::blocks() {
  Petsc& self = *petsc_;
  if (self.in_place) check(MatSetUnfactored(self.matrix), "MatSetUnfactored");
  PetscScalar* values = nullptr;  // stays valid: PETSc moves nothing after the pattern is set
  check(MatSeqBAIJGetArray(self.matrix, &values), "MatSeqBAIJGetArray");
  const std::span<double> all(values, self.block_numbers);
  check(MatSeqBAIJRestoreArray(self.matrix, &values), "MatSeqBAIJRestoreArray");
  return all;
}

bool BlockSystem::factor(std::span<const double> given) {
  require_size("blocks", given.size(), petsc_->block_numbers);
  std::copy_n(given.begin(), petsc_->block_numbers, blocks().begin());
  return factor();
}

bool BlockSystem::factor() {
  Petsc& self = *petsc_;
  if (!all_finite(blocks())) return false;  // PETSc's pivot test lets NaN pass
  check(MatAssemblyBegin(self.matrix, MAT_FINAL_ASSEMBLY),
        "MatAssemblyBegin");  // tells PETSc that blocks changed
  check(MatAssemblyEnd(self.matrix, MAT_FINAL_ASSEMBLY), "MatAssemblyEnd");
  PC pc = nullptr;
  check(KSPGetPC(self.ksp, &pc), "KSPGetPC");
  if (self.has_factors && !self.in_place) {  // PETSc leaves the mark of a failed factorisation on the factors
    Mat factors = nullptr;
    check(PCFactorGetMatrix(pc, &factors), "PCFactorGetMatrix");
    check(MatFactorClearError(factors), "MatFactorClearError");
  }
  check(KSPSetReusePreconditioner(self.ksp, PETSC_FALSE), "KSPSetReusePreconditioner");
  check(KSPSetOperators(self.ksp, self.matrix, self.matrix), "KSPSetOperators");
  check(KSPSetUp(self.ksp), "KSPSetUp");
  check(KSPSetReusePreconditioner(self.ksp, PETSC_TRUE), "KSPSetReusePreconditioner");
  self.has_factors = true;
  PCFailedReason failed = PC_NOERROR;
  check(PCGetFailedReason(pc, &failed), "PCGetFailedReason");
  return failed == PC_NOERROR;
}

LinearReport BlockSystem::solve(std::span<const double> b, std::span<double> x, const LinearOptions& options,
                                const LinearOperator& product, std::stop_token stop) {
  Petsc& self = *petsc_;
  require_size("b", b.size(), self.size);
  require_size("x", x.size(), self.size);
  if (!(options.relative_tolerance >= 0) || options.max_iterations < 1)
    throw InputError("LinearOptions",
                     "a tolerance of " + std::to_string(options.relative_tolerance) + " and at most " +
                         std::to_string(options.max_iterations) + " iterations",
                     "give a tolerance that is not negative and at least one iteration");
  if (self.in_place && !product)
    throw std::logic_error("BlockSystem: the factors took the matrix's place, give a product");
  self.product = &product;
  self.stop = std::move(stop);
  self.stopped = false;
  self.thrown = nullptr;
  self.relative_tolerance = options.relative_tolerance;
  self.max_iterations = options.max_iterations;
  check(KSPSetOperators(self.ksp, product ? self.shell : self.matrix, self.matrix), "KSPSetOperators");
  check(KSPGMRESSetRestart(self.ksp, options.max_iterations), "KSPGMRESSetRestart");
  check(KSPSetTolerances(self.ksp, options.relative_tolerance, 0, PETSC_DEFAULT, options.max_iterations),
        "KSPSetTolerances");
  check(VecPlaceArray(self.b, b.data()), "VecPlaceArray");
  check(VecPlaceArray(self.x, x.data()), "VecPlaceArray");
  const PetscErrorCode code = KSPSolve(self.ksp, self.b, self.x);
  VecResetArray(self.b);
  VecResetArray(self.x);
  if (self.thrown) std::rethrow_exception(std::exchange(self.thrown, nullptr));
  check(code, "KSPSolve");
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  check(KSPGetConvergedReason(self.ksp, &reason), "KSPGetConvergedReason");
  check(KSPGetIterationNumber(self.ksp, &iterations), "KSPGetIterationNumber");
  LinearReport report;
  report.iterations = iterations;
  report.relative_residual = self.first_norm > 0 ? self.last_norm / self.first_norm : 0;
  report.outcome = self.stopped                 ? LinearOutcome::stopped
                   : reason > 0                 ? LinearOutcome::reached
                   : reason == KSP_DIVERGED_ITS ? LinearOutcome::iteration_limit
                                                : LinearOutcome::breakdown;
  return report;
}

}  // namespace solver
}  // namespace leonhard
