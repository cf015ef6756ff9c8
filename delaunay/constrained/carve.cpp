// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/carve.hpp"

#include <cstdint>
#include <optional>
#include <utility>

#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {
namespace {

/// A real triangle that has the seed in it or on its border; none outside the hull.
///
/// throws InputError if the seed is on a segment, so that it would be unclear which side is meant.
std::optional<AnyTriangleId> seeded_triangle(const ConstrainedTriangulation& in, Point2 seed,
                                             const std::string& name, const std::string& source) {
  const GhostTriangulation& topology = in.topology();
  AnyTriangleId start{0};
  while (topology.is_ghost(start)) ++start.raw;
  Coin coin;
  const Location at = locate(topology, in.points(), start, seed, coin);
  bool on_segment = at.kind == Location::Kind::on_side && in.is_constrained(at.side);
  if (at.kind == Location::Kind::on_vertex) {
    SideId s = at.side;
    do {
      on_segment = on_segment || in.is_constrained(s);
      s = topology.turn_about_origin(s);
    } while (s != at.side);
  }
  if (on_segment)
    throw InputError(source, name + " at " + mesh::words(seed) + " lies exactly on a segment",
                     "move it off the segment, to the side that is meant");
  if (at.kind == Location::Kind::outside) return std::nullopt;
  return topology.triangle(at.side);
}

/// Give `value` to all triangles that can be reached from those on the stack (which have it already) over
/// unconstrained edges and that satisfy `free`.
template <class Values, class Value, class Free>
void flood(const ConstrainedTriangulation& in, std::vector<AnyTriangleId> stack, Values& values, Value value,
           const Free& free) {
  const GhostTriangulation& topology = in.topology();
  while (!stack.empty()) {
    const AnyTriangleId t = stack.back();
    stack.pop_back();
    for (unsigned i = 0; i < 3; ++i) {
      const SideId s = topology.side(t, i);
      const AnyTriangleId behind = topology.triangle(topology.twin(s));
      if (in.is_constrained(s) || !free(behind)) continue;
      values[behind.index()] = value;
      stack.push_back(behind);
    }
  }
}

/// Which triangles go, ghosts included.
std::vector<bool> removed_triangles(const ConstrainedTriangulation& in, const Pslg& pslg,
                                    bool keep_convex_hull, std::vector<std::string>& repairs) {
  const GhostTriangulation& topology = in.topology();
  std::vector<bool> removed(topology.triangle_count(), false);
  std::vector<AnyTriangleId> stack;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    if (!topology.is_ghost(t)) continue;
    removed[i] = true;
    if (!keep_convex_hull) stack.push_back(t);
  }
  const auto there = [&](AnyTriangleId t) { return !removed[t.index()]; };
  flood(in, std::move(stack), removed, true, there);
  for (std::size_t h = 0; h < pslg.holes.size(); ++h) {
    const std::string name = "hole " + std::to_string(h);
    const std::optional<AnyTriangleId> t = seeded_triangle(in, pslg.holes[h], name, pslg.source);
    if (!t || removed[t->index()]) {
      repairs.push_back(
          name + " at " + mesh::words(pslg.holes[h]) +
          (t ? " lies outside the domain or in a hole already made" : " lies outside the domain") +
          ": it removes nothing");
      continue;
    }
    removed[t->index()] = true;
    flood(in, {*t}, removed, true, there);
  }
  return removed;
}

/// Put a ghost triangle behind every side that has none yet and link the ghosts into rings.
void close_with_ghosts(GhostTriangulation& topology, const std::vector<SideId>& open) {
  const auto is_open = [&](SideId s) { return topology.twin(s) == s; };
  std::vector<std::pair<SideId, AnyTriangleId>> ghosts;
  for (const SideId s : open)
    ghosts.emplace_back(s,
                        topology.add(GhostTriangulation::ghost, topology.destination(s), topology.origin(s)));
  std::vector<SideId> next_open;
  for (const SideId s : open) {
    SideId turn = topology.next(s);  // leaves the destination of s
    while (!is_open(turn)) turn = topology.next(topology.twin(turn));
    next_open.push_back(turn);
  }
  for (const auto& [s, ghost] : ghosts) topology.link(s, topology.side(ghost, 0));
  for (std::size_t i = 0; i < open.size(); ++i) {
    const AnyTriangleId beyond = topology.triangle(topology.twin(next_open[i]));
    topology.link(topology.side(ghosts[i].second, 2), topology.side(beyond, 1));
  }
}

/// The real triangles that stay, closed with ghosts, and every piece between or beside them.
ConstrainedTriangulation keep(const ConstrainedTriangulation& in, const std::vector<bool>& removed) {
  const GhostTriangulation& from = in.topology();
  GhostTriangulation topology;
  std::vector<MaybeId<AnyTriangleId>> new_of_old(removed.size());
  std::vector<AnyTriangleId> kept;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (removed[i]) continue;
    const AnyTriangleId t = AnyTriangleId::from(i);
    new_of_old[i] = topology.add(from.corner(t, 0), from.corner(t, 1), from.corner(t, 2));
    kept.push_back(t);
  }
  std::vector<SideId> open;
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (unsigned k = 0; k < 3; ++k) {
      const SideId s = topology.side(AnyTriangleId::from(i), k), twin = from.twin(from.side(kept[i], k));
      if (const MaybeId<AnyTriangleId> behind = new_of_old[from.triangle(twin).index()]) {
        topology.link(s, topology.side(*behind, topology.number(twin)));
      } else {
        topology.link(s, s);
        open.push_back(s);
      }
    }
  close_with_ghosts(topology, open);

  ConstrainedTriangulation out(std::move(topology), in.points());
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (unsigned k = 0; k < 3; ++k) {
      const SideId s = out.topology().side(AnyTriangleId::from(i), k);
      const bool boundary = out.topology().is_ghost(out.topology().triangle(out.topology().twin(s)));
      const MaybeId<PieceId> p = in.piece_of(from.side(kept[i], k));
      if (out.is_constrained(s) || (!p && !boundary)) continue;
      if (p)
        out.add_piece(s, in.piece(*p).marker, in.piece(*p).segment);
      else
        out.add_piece(s, 1, {});  // of the convex hull
    }
  return out;
}

/// One a triangle: 0, or one more than the index of the region that it lies in.
std::vector<std::uint32_t> regions(const ConstrainedTriangulation& in, const Pslg& pslg,
                                   const std::vector<bool>& removed, std::vector<std::string>& repairs) {
  std::vector<std::uint32_t> region_of(removed.size(), 0);
  for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
    const std::string name = "region " + std::to_string(r);
    const Point2 seed = pslg.regions[r].seed;
    const std::optional<AnyTriangleId> t = seeded_triangle(in, seed, name, pslg.source);
    const bool outside = !t || removed[t->index()];
    if (outside || region_of[t->index()] != 0) {
      repairs.push_back(name + " at " + mesh::words(seed) +
                        (outside ? " lies outside the domain or in a hole"
                                 : " is the same as region " + std::to_string(region_of[t->index()] - 1)) +
                        ": it has no effect");
      continue;
    }
    const auto value = static_cast<std::uint32_t>(r + 1);
    region_of[t->index()] = value;
    flood(in, {*t}, region_of, value,
          [&](AnyTriangleId u) { return !removed[u.index()] && region_of[u.index()] == 0; });
  }
  return region_of;
}

}  // namespace

ConstrainedTriangulation carve(const ConstrainedTriangulation& in, const Pslg& pslg, bool keep_convex_hull,
                               std::vector<std::string>& repairs) {
  const std::vector<bool> removed = removed_triangles(in, pslg, keep_convex_hull, repairs);
  const std::vector<std::uint32_t> region_of = regions(in, pslg, removed, repairs);
  ConstrainedTriangulation out = keep(in, removed);
  if (out.topology().triangle_count() == 0)
    throw InputError(pslg.source,
                     "the segments enclose nothing: carving holes and the outside leaves no triangle",
                     "close the outline, move the hole seeds, or keep the convex hull");
  std::vector<std::uint32_t> kept_regions;
  if (!pslg.regions.empty()) {
    for (std::size_t i = 0; i < removed.size(); ++i)
      if (!removed[i]) kept_regions.push_back(region_of[i]);
    kept_regions.resize(out.topology().triangle_count(), 0);
    out.set_regions(std::move(kept_regions));
  }
  return out;
}

}  // namespace leonhard::delaunay
