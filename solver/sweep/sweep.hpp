// SPDX-License-Identifier: MIT
#pragma once

// The inner loops over edges and vertices, and the plain arrays that they read and write. They are compiled twice
// (sweep_baseline.cpp, sweep_avx2.cpp from sweep_impl.hpp) and chosen when the program starts; both give the same bits.

#include <cstddef>
#include <cstdint>

#include "leonhard/solver/kinds.hpp"

namespace leonhard::solver {

/// How a neighbour enters a vertex's gradient, and the way to the middle of the edge between them.
struct alignas(32) StencilSlot {
  double weight_x, weight_y;  ///< gradient = sum of weight times (neighbour's value less own)
  double half_x, half_y;      ///< from the vertex to the edge's midpoint
};

/// An edge from a to b as one part sees it. into_a and into_b say where its flux is added (b's is subtracted); the
/// same as a and b, or the part's rubbish line where the end belongs to another part.
struct EdgeEnds {
  std::uint32_t a, b, into_a, into_b;
  std::uint32_t block_aa, block_ab, block_bb, block_ba;  ///< likewise in the block matrix
};

/// Four edges' geometry: unit normal from a to b, length of the dual face, half the vector from a to b.
struct alignas(32) EdgeMetric {
  double nx[4], ny[4], length[4], half_x[4], half_y[4];
};

struct PartRange {
  std::uint32_t vertex_begin, vertex_end;      ///< in part_vertices
  std::uint32_t edge_begin, edge_end;          ///< in ends; multiples of four
  std::uint32_t boundary_begin, boundary_end;  ///< in part_boundary
};

/// Lines between the rubbish entries of two parts: two cache lines, so that threads do not disturb each other.
inline constexpr std::size_t rubbish_stride = 4;

struct SweepMesh {
  const std::uint32_t* offset;
  const std::uint32_t* neighbour;
  const StencilSlot* slot;
  const std::uint32_t* part_vertices;
  const EdgeEnds* ends;
  const EdgeMetric* metric;
};

struct SweepSettings {
  double gamma = 1.4;
  double entropy_fix = 0.05;
  double mach = 0.5;  ///< of the free stream
  FluxKind flux = FluxKind::roe;
  LimiterKind limiter = LimiterKind::none;
  const double* limiter_scale2 = nullptr;  ///< epsilon^2 of Venkatakrishnan's limiter, one a vertex
};

/// One build of the loops. States: 4 doubles a vertex (rho, u, v, p); gradients: 8, d/dx of the four then d/dy.
struct SweepKernels {
  const char* name;
  /// Limited gradients of the part's vertices.
  void (*limited_gradients)(const SweepMesh&, const PartRange&, const SweepSettings&, const double* state,
                            double* gradient);
  /// Add the fluxes of the part's edges to `residual` (4 a line). gradient == nullptr: states constant in a cell.
  void (*fluxes)(const SweepMesh&, const PartRange&, const SweepSettings&, const double* state,
                 const double* gradient, double* residual);
  /// Add (|Vn| + c) times length of the part's edges to `sum`, one a line.
  void (*wave_speeds)(const SweepMesh&, const PartRange&, const SweepSettings&, const double* state,
                      double* sum);
  /// Add to diagonal blocks and set the others of the first-order Jacobian; blocks of 16, column by column.
  void (*jacobian)(const SweepMesh&, const PartRange&, const SweepSettings&, const double* state,
                   double* blocks);
};

extern const SweepKernels sweep_baseline;
#if defined(LEONHARD_HAS_AVX2_SWEEP)
extern const SweepKernels sweep_avx2;
#endif

/// The fastest build that this processor runs.
[[nodiscard]] const SweepKernels& best_sweep();

}  // namespace leonhard::solver
