// SPDX-License-Identifier: MIT
#pragma once

// The inner loops over edges and vertices, and the plain arrays that they read and write. They are compiled twice
// (sweep_baseline.cpp, sweep_avx2.cpp from sweep_impl.hpp) and chosen when the program starts; both give the same bits.

#include <cstddef>
#include <cstdint>

#include "leonhard/solver/kinds.hpp"

namespace leonhard::solver {

/// How a neighbour enters a vertex's gradient, and the way to the middle of the edge between them.
template <int dim>
struct alignas(dim == 2 ? 32 : 16) StencilSlot {
  double weight[dim];  ///< gradient = sum of weight times (neighbour's value less own)
  double half[dim];    ///< from the vertex to the edge's midpoint
};

/// An edge from a to b as one part sees it. into_a and into_b say where its flux is added (b's is subtracted); the
/// same as a and b, or the part's rubbish line where the end belongs to another part.
struct EdgeEnds {
  std::uint32_t a, b, into_a, into_b;
  std::uint32_t block_aa, block_ab, block_bb, block_ba;  ///< likewise in the block matrix, or no_block
};

inline constexpr std::uint32_t no_block = 0xffffffff;  ///< of an end that belongs to another part

/// Four edges' geometry: unit normal from a to b, size of the dual face, half the vector from a to b.
template <int dim>
struct alignas(32) EdgeMetric {
  double n[dim][4], size[4], half[dim][4];
};

struct PartRange {
  std::uint32_t vertex_begin, vertex_end;      ///< in part_vertices
  std::uint32_t edge_begin, edge_end;          ///< in ends; multiples of four
  std::uint32_t boundary_begin, boundary_end;  ///< in part_boundary
};

/// Lines between the rubbish entries of two parts: two cache lines, so that threads do not disturb each other.
inline constexpr std::size_t rubbish_stride = 4;

template <int dim>
struct SweepMesh {
  const std::uint32_t* offset;
  const std::uint32_t* neighbour;
  const StencilSlot<dim>* slot;
  const std::uint32_t* part_vertices;
  const EdgeEnds* ends;
  const EdgeMetric<dim>* metric;
};

struct SweepSettings {
  double gamma = 1.4;
  double entropy_fix = 0.05;
  double mach = 0.5;  ///< of the free stream
  FluxKind flux = FluxKind::roe;
  LimiterKind limiter = LimiterKind::none;
  const double* limiter_scale2 = nullptr;  ///< epsilon^2 of Venkatakrishnan's limiter, one a vertex
  const double* limiter_scale3 = nullptr;  ///< epsilon^3 of Nishikawa's R3, likewise
  double viscosity = 0;                    ///< at the free stream's temperature; 0: inviscid
  double sutherland = -1;                  ///< see Viscosity
  double inverse_prandtl = 1;
  bool repeats_edges = false;  ///< two vertices may have several edges: the Jacobian adds to all blocks
};

/// One build of the loops. States: n = dim + 2 doubles a vertex (rho, velocity, p); gradients: dim rows of n, d/dx of all, then
/// d/dy ...
template <int dim>
struct SweepKernels {
  const char* name;
  /// Limited gradients of the part's vertices; unlimited != nullptr takes those before the limiter.
  void (*limited_gradients)(const SweepMesh<dim>&, const PartRange&, const SweepSettings&, const double* state,
                            double* gradient, double* unlimited);
  /// Add the convective fluxes of the part's edges to `residual` (n a line). gradient == nullptr: states constant in a cell.
  void (*fluxes)(const SweepMesh<dim>&, const PartRange&, const SweepSettings&, const double* state,
                 const double* gradient, double* residual);
  /// Add the viscous fluxes likewise. gradient (unlimited) == nullptr: those of the jumps along the edges alone.
  void (*viscous_fluxes)(const SweepMesh<dim>&, const PartRange&, const SweepSettings&, const double* state,
                         const double* gradient, double* residual);
  /// Add (|Vn| + c) times size of the part's edges, and what diffusion adds, to `sum`, one a line.
  void (*wave_speeds)(const SweepMesh<dim>&, const PartRange&, const SweepSettings&, const double* state,
                      double* sum);
  /// Add to diagonal blocks and set the others (repeats_edges: add to them too) of the first-order Jacobian; blocks of n x n,
  /// column by column.
  void (*jacobian)(const SweepMesh<dim>&, const PartRange&, const SweepSettings&, const double* state,
                   double* blocks);
};

/// The builds there are.
template <int dim>
struct SweepBuilds {
  static const SweepKernels<dim> baseline;
#if defined(LEONHARD_HAS_AVX2_SWEEP)
  static const SweepKernels<dim> avx2;
#endif
};
template <>
const SweepKernels<2> SweepBuilds<2>::baseline;
template <>
const SweepKernels<3> SweepBuilds<3>::baseline;
#if defined(LEONHARD_HAS_AVX2_SWEEP)
template <>
const SweepKernels<2> SweepBuilds<2>::avx2;
template <>
const SweepKernels<3> SweepBuilds<3>::avx2;
#endif

/// The fastest build that this processor runs.
template <int dim>
[[nodiscard]] const SweepKernels<dim>& best_sweep();

}  // namespace leonhard::solver
