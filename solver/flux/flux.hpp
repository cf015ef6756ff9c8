// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/ausm_plus_up.hpp"
#include "leonhard/solver/flux/hllc.hpp"
#include "leonhard/solver/flux/kep.hpp"
#include "leonhard/solver/flux/roe.hpp"
#include "leonhard/solver/flux/rusanov.hpp"
#include "leonhard/solver/flux/van_leer.hpp"
#include "leonhard/solver/kinds.hpp"

namespace leonhard::solver {

/// The flux of a kind from a to b per unit of the face; the unit normal n points from a to b. Pure.
template <FluxKind kind, int dim, class T>
LEONHARD_INLINE Components<dim, T> flux(const FluxConstants& k, const Primitive<dim, T>& a,
                                        const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  if constexpr (kind == FluxKind::roe) return flux_roe(k, a, b, n);
  if constexpr (kind == FluxKind::roe_low_mach) return flux_roe_low_mach(k, a, b, n);
  if constexpr (kind == FluxKind::hllc) return flux_hllc(k, a, b, n);
  if constexpr (kind == FluxKind::hllc_low_mach) return flux_hllc_low_mach(k, a, b, n);
  if constexpr (kind == FluxKind::ausm_plus_up) return flux_ausm_plus_up(k, a, b, n);
  if constexpr (kind == FluxKind::rusanov) return flux_rusanov(k, a, b, n);
  if constexpr (kind == FluxKind::van_leer) return flux_van_leer(k, a, b, n);
  if constexpr (kind == FluxKind::kep_scalar) return flux_kep_scalar(k, a, b, n);
  if constexpr (kind == FluxKind::kep_matrix) return flux_kep_matrix(k, a, b, n);
}

/// Call work.operator()<kind>() with a kind known at run time.
template <class Work>
LEONHARD_INLINE void with_flux(FluxKind kind, const Work& work) {
  switch (kind) {
    case FluxKind::roe:
      return work.template operator()<FluxKind::roe>();
    case FluxKind::roe_low_mach:
      return work.template operator()<FluxKind::roe_low_mach>();
    case FluxKind::hllc:
      return work.template operator()<FluxKind::hllc>();
    case FluxKind::hllc_low_mach:
      return work.template operator()<FluxKind::hllc_low_mach>();
    case FluxKind::ausm_plus_up:
      return work.template operator()<FluxKind::ausm_plus_up>();
    case FluxKind::rusanov:
      return work.template operator()<FluxKind::rusanov>();
    case FluxKind::van_leer:
      return work.template operator()<FluxKind::van_leer>();
    case FluxKind::kep_scalar:
      return work.template operator()<FluxKind::kep_scalar>();
    case FluxKind::kep_matrix:
      return work.template operator()<FluxKind::kep_matrix>();
  }
}

}  // namespace leonhard::solver
