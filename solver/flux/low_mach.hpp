// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/primitive.hpp"

// At small Mach numbers M an upwind flux resists a jump of the normal velocity like a sound wave, with rho c times the
// jump, where the flow has rho |V|: the error in pressure grows like 1 / M (H. Guillard and C. Viozat, Computers and
// Fluids 28, 1999). The low-Mach versions of the fluxes keep a share of that jump only.

namespace leonhard::solver {

/// The share of the normal velocity's jump that upwinding keeps: the greatest Mach number, at most 1, of the two sides and
/// the free stream (F. Rieper, Journal of Computational Physics 230, 2011, for Roe's flux; B. Thornber et al.,
/// Journal of Computational Physics 227, 2008, for any Riemann solver; that the free stream bounds it from
/// below: M.-S. Liou, Journal of Computational Physics 214, 2006). A supersonic free stream therefore leaves
/// the flux as it is. A jump of pressure counts as the Mach number of a flow that could bring it about, sqrt(|dp| / p), so
/// that nothing is taken from a shock, wherever its states lie; in slow flow that is of the order of M as well.
template <int dim, class T>
LEONHARD_INLINE T low_mach_share(const FluxConstants& k, const Primitive<dim, T>& a,
                                 const Primitive<dim, T>& b) {
  const auto mach2 = [&](const Primitive<dim, T>& w) {
    return T(dot(w.velocity, w.velocity) * w.rho / (k.gamma * w.p));
  };
  const T jump = magnitude<T>(b.p - a.p) / smaller<T>(a.p, b.p);
  const T local2 = larger<T>(jump, larger<T>(mach2(a), mach2(b)));
  return root(smaller<T>(constant<T>(1), larger<T>(local2, constant<T>(k.mach * k.mach))));
}

}  // namespace leonhard::solver
