// SPDX-License-Identifier: MIT
#include "leonhard/solver/kinds.hpp"

namespace leonhard {

std::string_view to_string(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::slip_wall:
      return "slip_wall";
    case BoundaryKind::far_field:
      return "far_field";
    case BoundaryKind::supersonic_inflow:
      return "supersonic_inflow";
    case BoundaryKind::supersonic_outflow:
      return "supersonic_outflow";
    case BoundaryKind::symmetry:
      return "symmetry";
  }
  return "";
}

std::string_view to_string(LimiterKind kind) {
  switch (kind) {
    case LimiterKind::none:
      return "none";
    case LimiterKind::venkatakrishnan:
      return "venkatakrishnan";
    case LimiterKind::barth_jespersen:
      return "barth_jespersen";
  }
  return "";
}

std::string_view to_string(Marching marching) {
  switch (marching) {
    case Marching::implicit_ptc:
      return "implicit_ptc";
    case Marching::explicit_multistage:
      return "explicit_multistage";
  }
  return "";
}

}  // namespace leonhard
