// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/input_angles.hpp"

#include <algorithm>
#include <cmath>

namespace leonhard::delaunay {
namespace {

/// 1 - cos of the angle from side s counter-clockwise to the next piece about the same origin, or 2 if all that is
/// between is not in the domain or the angle is not acute.
double cosine_gap(const ConstrainedTriangulation& in, SideId s) {
  const GhostTriangulation& topology = in.topology();
  if (topology.is_ghost(topology.triangle(s))) return 2;
  SideId t = topology.turn_about_origin(s);
  while (!in.is_constrained(t)) t = topology.turn_about_origin(t);
  if (t == s) return 2;
  const Point2 o = in.point(topology.origin(s));
  const Vec2 u = in.point(topology.destination(s)) - o, v = in.point(topology.destination(t)) - o;
  const double sine = cross(u, v), cosine = dot(u, v);
  if (sine <= 0 || cosine <= 0) return 2;
  // 1 - cos = sin^2 / (1 + cos) keeps its digits for small angles.
  const double length = std::sqrt(sine * sine + cosine * cosine);
  return (sine / length) * (sine / length) / (1 + cosine / length);
}

}  // namespace

InputAngles::InputAngles(const ConstrainedTriangulation& in) : least_cosine_gap_(in.points().size(), 2) {
  const GhostTriangulation& topology = in.topology();
  for (const Piece& piece : in.pieces())
    for (const SideId s : {piece.side, topology.twin(piece.side)}) {
      double& least = least_cosine_gap_[topology.origin(s).index()];
      least = std::min(least, cosine_gap(in, s));
    }
}

// Only says which triangles refinement leaves alone, so that it ends; no sign and no topology hangs on it.
double InputAngles::shell_tolerance(VertexId v) const {
  return std::clamp(least_cosine_gap_[v.index()] / 8, 1e-9, 1e-3);
}

}  // namespace leonhard::delaunay
