// SPDX-License-Identifier: MIT
// Measures alpha and beta of equation 2.3.0, the time alpha + beta m of a message of m values, on this machine's MPI:
// two processes exchange messages of growing length at the same time, and a straight line is fitted.
//   mpirun -n 2 build/bench/bench/bench_message_cost
#define OMPI_SKIP_MPICXX 1  // the old C++ bindings bring warnings
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

/// Seconds of one exchange in both directions, the shortest of several series.
double exchange_seconds(int values, int partner) {
  std::vector<double> out(static_cast<std::size_t>(values), 1.0), in(out.size());
  constexpr int series = 10;
  const int repetitions = std::max(10, 200000 / (values + 100));
  double shortest = std::numeric_limits<double>::max();
  for (int s = 0; s < series; ++s) {
    MPI_Barrier(MPI_COMM_WORLD);
    const double start = MPI_Wtime();
    for (int r = 0; r < repetitions; ++r)
      MPI_Sendrecv(out.data(), values, MPI_DOUBLE, partner, 0, in.data(), values, MPI_DOUBLE, partner, 0,
                   MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    shortest = std::min(shortest, (MPI_Wtime() - start) / repetitions);
  }
  return shortest;
}

struct Sample {
  double values, seconds;
};

/// Least squares of the relative errors: short messages count as much as long ones.
void print_fit(const std::vector<Sample>& samples) {
  double w = 0, wm = 0, wmm = 0, wt = 0, wmt = 0;
  for (const auto& [m, t] : samples) {
    const double weight = 1 / (t * t);
    w += weight;
    wm += weight * m;
    wmm += weight * m * m;
    wt += weight * t;
    wmt += weight * m * t;
  }
  const double beta = (w * wmt - wm * wt) / (w * wmm - wm * wm), alpha = (wt - beta * wm) / w;
  std::printf("%12s %14s %14s\n", "values", "measured, us", "fitted, us");
  for (const auto& [m, t] : samples)
    std::printf("%12.0f %14.3f %14.3f\n", m, 1e6 * t, 1e6 * (alpha + beta * m));
  std::printf("alpha = %.3g s, beta = %.3g s a value of 8 bytes (%.2f GB/s each way)\n", alpha, beta,
              8e-9 / beta);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (size == 2) {
    std::vector<Sample> samples;
    for (int values = 1; values <= 1 << 17; values *= 4)
      samples.push_back({static_cast<double>(values), exchange_seconds(values, 1 - rank)});
    if (rank == 0) print_fit(samples);
  } else if (rank == 0) {
    std::fprintf(stderr, "bench_message_cost: two processes are needed: mpirun -n 2 bench_message_cost\n");
  }
  MPI_Finalize();
  return size == 2 ? 0 : 1;
}
