// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/delaunay/topology/conflict.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// Keeps no history of an insertion: see SwapInsertion.
struct NoHistory {
  void replaced(const GhostTriangulation&, std::span<const AnyTriangleId>, std::span<const AnyTriangleId>) {}
};

/// One insertion after another by Green and Sibson's method (Computer Journal 21, 1978; Barth's notes 3.3b):
/// the new site is connected to the three or four vertices about it, then suspect edges are swapped until
/// none fails the incircle test. The ghost is a vertex like others, so a site outside is connected to an
/// outer edge and the ghost.
///
/// Every edge that swapping connects to the site stays, so only the edges opposite it are suspect: swapping
/// goes forward only. The recursion of the notes keeps its calls on a stack of its own.
class SwapInsertion {
 public:
  /// Insert a vertex; cost O(its degree).
  ///
  /// at       its location, not on a vertex; outside: a ghost triangle strictly inside whose half plane it
  ///          lies
  /// history  history.replaced(in, olds, news) is told of every step: triangles `olds` gave way to `news`,
  ///          which reuse their numbers and together cover the same part of the sphere
  /// returns  the number of triangles made, those that the swaps replaced again included
  template <class History>
  std::size_t insert(GhostTriangulation& in, std::span<const Point2> points, VertexId v, const Location& at,
                     History& history) {
    site_ = v;
    // Step 2: connect the site to the vertices about it.
    std::size_t made = at.kind == Location::Kind::on_side
                           ? connect_to_four(in, at.side, history)
                           : connect_to_three(in, in.triangle(at.side), history);
    // Steps 3 to 6: swap suspect edges; two more become suspect with each swap.
    const Point2 p = points[v.index()];
    while (!suspect_.empty()) {
      const SideId s = suspect_.back();
      suspect_.pop_back();
      if (!in_conflict(in, points, in.triangle(in.twin(s)), p)) continue;
      swap(in, s, history);
      made += 2;
    }
    return made;
  }

 private:
  /// The triangle (site, a, b) with its sides a -> b, b -> site and site -> a.
  struct Spoke {
    SideId opposite, towards, away;
  };

  Spoke place(GhostTriangulation& in, AnyTriangleId t, VertexId a, VertexId b) const {
    constexpr VertexId ghost = GhostTriangulation::ghost;
    const unsigned corner = a == ghost ? 2 : b == ghost ? 1 : 0;  // of the site; the ghost has to be corner 0
    if (corner == 0)
      in.set_corners(t, site_, a, b);
    else if (corner == 1)
      in.set_corners(t, b, site_, a);
    else
      in.set_corners(t, a, b, site_);
    const SideId opposite = in.side(t, corner);
    return {opposite, in.next(opposite), in.previous(opposite)};
  }

  template <class History>
  std::size_t connect_to_three(GhostTriangulation& in, AnyTriangleId t, History& history) {
    const std::array<VertexId, 3> corner{in.corner(t, 0), in.corner(t, 1), in.corner(t, 2)};
    const std::array<SideId, 3> outer{in.twin(in.side(t, 0)), in.twin(in.side(t, 1)), in.twin(in.side(t, 2))};
    const std::array<AnyTriangleId, 3> news{t, in.add(site_, site_, site_), in.add(site_, site_, site_)};
    std::array<Spoke, 3> spokes;
    for (unsigned i = 0; i < 3; ++i) spokes[i] = place(in, news[i], corner[(i + 1) % 3], corner[(i + 2) % 3]);
    for (unsigned i = 0; i < 3; ++i) close(in, spokes[i], outer[i], spokes[(i + 1) % 3]);
    history.replaced(in, std::array{t}, news);
    return 3;
  }

  template <class History>
  std::size_t connect_to_four(GhostTriangulation& in, SideId edge, History& history) {
    const SideId twin = in.twin(edge);
    const AnyTriangleId t = in.triangle(edge), u = in.triangle(twin);
    const std::array<VertexId, 4> corner{in.destination(edge), in.apex(edge), in.origin(edge), in.apex(twin)};
    const std::array<SideId, 4> outer{in.twin(in.next(edge)), in.twin(in.previous(edge)),
                                      in.twin(in.next(twin)), in.twin(in.previous(twin))};
    const std::array<AnyTriangleId, 4> news{t, in.add(site_, site_, site_), u, in.add(site_, site_, site_)};
    std::array<Spoke, 4> spokes;
    for (unsigned i = 0; i < 4; ++i) spokes[i] = place(in, news[i], corner[i], corner[(i + 1) % 4]);
    for (unsigned i = 0; i < 4; ++i) close(in, spokes[i], outer[i], spokes[(i + 1) % 4]);
    history.replaced(in, std::array{t}, std::array{t, news[1]});
    history.replaced(in, std::array{u}, std::array{u, news[3]});
    return 4;
  }

  /// Link a triangle about the site to the one outside and to the next one counter-clockwise.
  void close(GhostTriangulation& in, const Spoke& spoke, SideId outer, const Spoke& next) {
    in.link(spoke.opposite, outer);
    in.link(spoke.towards, next.away);
    suspect_.push_back(spoke.opposite);
  }

  /// Swap the edge a - b opposite the site for the one to the vertex d beyond it.
  template <class History>
  void swap(GhostTriangulation& in, SideId s, History& history) {
    const SideId o = in.twin(s);
    const VertexId a = in.origin(s), b = in.destination(s), d = in.apex(o);
    const SideId beyond_ad = in.twin(in.next(o)), beyond_db = in.twin(in.previous(o));
    const SideId beyond_b = in.twin(in.next(s)), beyond_a = in.twin(in.previous(s));
    const std::array pair{in.triangle(s), in.triangle(o)};
    const Spoke first = place(in, pair[0], a, d), second = place(in, pair[1], d, b);
    in.link(first.away, beyond_a);
    in.link(second.towards, beyond_b);
    in.link(second.opposite, beyond_db);
    suspect_.push_back(second.opposite);
    close(in, first, beyond_ad, second);
    history.replaced(in, pair, pair);
  }

  VertexId site_{};
  std::vector<SideId> suspect_;  // opposite the site
};

}  // namespace leonhard::delaunay
