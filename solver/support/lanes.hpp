// SPDX-License-Identifier: MIT
#pragma once

// Four doubles at once, in GCC's and clang's vector extension, and the few operations that the formulas need, with
// overloads for one double, so that one text of a formula serves both. Every operation is IEEE: the same bits come
// out of one lane, of SSE2 and of AVX2. Included by the sweep files that are compiled once per instruction set:
// keep it free of functions that a linker could share between them (everything here is always inlined).

#if defined(__AVX__) || defined(__SSE2__)
#include <immintrin.h>
#endif

#define LEONHARD_INLINE [[gnu::always_inline]] static inline

namespace leonhard::solver {

using Lanes = double __attribute__((vector_size(32)));
using LanesMask = long long __attribute__((vector_size(32)));
using LanesUnaligned = double __attribute__((vector_size(32), aligned(8)));

LEONHARD_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }
LEONHARD_INLINE Lanes select(const LanesMask& mask, const Lanes& yes, const Lanes& no) {
  return mask ? yes : no;
}

LEONHARD_INLINE double root(double x) { return __builtin_sqrt(x); }
LEONHARD_INLINE Lanes root(const Lanes& x) {
#if defined(__AVX__)
  return (Lanes)_mm256_sqrt_pd((__m256d)x);
#else
  return Lanes{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
#endif
}

template <class T>
LEONHARD_INLINE T smaller(const T& a, const T& b) {
  return select(a < b, a, b);
}
template <class T>
LEONHARD_INLINE T larger(const T& a, const T& b) {
  return select(a > b, a, b);
}
template <class T>
LEONHARD_INLINE T magnitude(const T& x) {
  return larger<T>(x, -x);
}

/// The same number in every lane.
template <class T>
LEONHARD_INLINE T constant(double x) {
  if constexpr (__is_same(T, Lanes))
    return Lanes{x, x, x, x};
  else
    return T(x);
}

LEONHARD_INLINE Lanes load(const double* p) { return *reinterpret_cast<const LanesUnaligned*>(p); }
LEONHARD_INLINE void store(double* p, const Lanes& x) { *reinterpret_cast<LanesUnaligned*>(p) = x; }

/// Rows become columns.
LEONHARD_INLINE void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
#if defined(__clang__)
  const Lanes ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6),
              ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6),
              cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
#else
  const Lanes ab_low = __builtin_shuffle(a, b, LanesMask{0, 4, 2, 6}),
              ab_high = __builtin_shuffle(a, b, LanesMask{1, 5, 3, 7});
  const Lanes cd_low = __builtin_shuffle(c, d, LanesMask{0, 4, 2, 6}),
              cd_high = __builtin_shuffle(c, d, LanesMask{1, 5, 3, 7});
  a = __builtin_shuffle(ab_low, cd_low, LanesMask{0, 1, 4, 5});
  b = __builtin_shuffle(ab_high, cd_high, LanesMask{0, 1, 4, 5});
  c = __builtin_shuffle(ab_low, cd_low, LanesMask{2, 3, 6, 7});
  d = __builtin_shuffle(ab_high, cd_high, LanesMask{2, 3, 6, 7});
#endif
}

}  // namespace leonhard::solver
