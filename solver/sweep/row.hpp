// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/primitive.hpp"
#include "leonhard/solver/support/lanes.hpp"

namespace leonhard::solver {

/// The n >= 4 variables of one vertex: the first four in a register, the others beside it. (Loops over faces take the same
/// variable of four faces in a register instead: Primitive<dim, Lanes>.)
template <int n>
struct Row {
  static constexpr int rest = n - 4;
  Lanes head;
  double tail[rest > 0 ? rest : 1];

  LEONHARD_INLINE Row load(const double* p) {
    Row r;
    r.head = solver::load(p);
    for (int i = 0; i < rest; ++i) r.tail[i] = p[4 + i];
    return r;
  }
  LEONHARD_INLINE Row same(double x) {
    Row r;
    r.head = constant<Lanes>(x);
    for (int i = 0; i < rest; ++i) r.tail[i] = x;
    return r;
  }
  [[gnu::always_inline]] inline void store(double* p) const {
    solver::store(p, head);
    for (int i = 0; i < rest; ++i) p[4 + i] = tail[i];
  }
  [[gnu::always_inline]] inline double operator[](int i) const { return i < 4 ? head[i] : tail[i - 4]; }
};

template <int n>
LEONHARD_INLINE Row<n> operator+(const Row<n>& a, const Row<n>& b) {
  Row<n> r;
  r.head = a.head + b.head;
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = a.tail[i] + b.tail[i];
  return r;
}
template <int n>
LEONHARD_INLINE Row<n> operator-(const Row<n>& a, const Row<n>& b) {
  Row<n> r;
  r.head = a.head - b.head;
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = a.tail[i] - b.tail[i];
  return r;
}
template <int n>
LEONHARD_INLINE Row<n> operator*(const Row<n>& a, const Row<n>& b) {
  Row<n> r;
  r.head = a.head * b.head;
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = a.tail[i] * b.tail[i];
  return r;
}
template <int n>
LEONHARD_INLINE Row<n> operator*(double s, const Row<n>& a) {
  Row<n> r;
  r.head = s * a.head;
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = s * a.tail[i];
  return r;
}
template <int n>
LEONHARD_INLINE Row<n> root(const Row<n>& a) {
  Row<n> r;
  r.head = solver::root(a.head);
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = solver::root(a.tail[i]);
  return r;
}
template <int n>
LEONHARD_INLINE Row<n> larger(const Row<n>& a, const Row<n>& b) {
  Row<n> r;
  r.head = solver::larger<Lanes>(a.head, b.head);
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = solver::larger<double>(a.tail[i], b.tail[i]);
  return r;
}
template <int n>
LEONHARD_INLINE Row<n> smaller(const Row<n>& a, const Row<n>& b) {
  Row<n> r;
  r.head = solver::smaller<Lanes>(a.head, b.head);
  for (int i = 0; i < Row<n>::rest; ++i) r.tail[i] = solver::smaller<double>(a.tail[i], b.tail[i]);
  return r;
}

/// Four vertices' variables, a vertex a row, to one variable a register; and back.
template <int n>
LEONHARD_INLINE void rows_to_lanes(Row<n> (&rows)[4], Lanes (&variable)[n]) {
  for (int i = 0; i < 4; ++i) variable[i] = rows[i].head;
  transpose(variable[0], variable[1], variable[2], variable[3]);
  for (int i = 0; i < Row<n>::rest; ++i)
    variable[4 + i] = Lanes{rows[0].tail[i], rows[1].tail[i], rows[2].tail[i], rows[3].tail[i]};
}
template <int n>
LEONHARD_INLINE void lanes_to_rows(const Lanes (&variable)[n], Row<n> (&rows)[4]) {
  Lanes r[4] = {variable[0], variable[1], variable[2], variable[3]};
  transpose(r[0], r[1], r[2], r[3]);
  for (int face = 0; face < 4; ++face) {
    rows[face].head = r[face];
    for (int i = 0; i < Row<n>::rest; ++i) rows[face].tail[i] = variable[4 + i][face];
  }
}

}  // namespace leonhard::solver
