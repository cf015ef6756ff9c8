// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard {

/// A directed edge of a QuadEdge or of its dual: 4 q + r is edge q turned by r quarters of a turn. Even r: an
/// edge from vertex to vertex; odd r: an edge of the dual, from face to face.
using EdgeRef = Id<struct EdgeRefTag>;
/// A face of a QuadEdge.
using FaceId = Id<struct FaceTag>;

/// The quad-edge structure: a subdivision of closed oriented surfaces and its dual in one, with topology kept
/// apart from geometry (Barth's notes 1.3, figure 1.3.0 d).
///
/// Of every edge there are four directed versions, e, rot(e), sym(e) and inv_rot(e). Rings: following onext
/// from e one goes counter-clockwise about e's origin, following lnext counter-clockwise about the face on
/// e's left. All that makes and changes subdivisions is make_edge and splice; the other operations are made
/// of these two.
///
/// Vertices and faces may carry ids, which the structure stores with the edges: origin(e) is a vertex id for
/// an edge and left(e) a face id; none where nobody set one. Each edge of a ring holds its own copy of the
/// ring's id. 32 bytes an edge.
///
/// Every edge given to a member must be of this structure, as contains() says, and not removed: a precondition, which is
/// not checked (a step takes a few instructions, a check would double them). validate() checks the whole.
///
/// Source: Guibas and Stolfi, "Primitives for the manipulation of general subdivisions and the computation of
/// Voronoi diagrams", ACM Transactions on Graphics 4 (1985). Surfaces are oriented here, so their Flip is
/// left out.
class QuadEdge {
 public:
  // ---- the edge algebra (their section 2) ----

  /// The dual edge from the right face of e to the left one.
  [[nodiscard]] static constexpr EdgeRef rot(EdgeRef e) { return turned(e, 1); }
  /// The same edge in the other direction.
  [[nodiscard]] static constexpr EdgeRef sym(EdgeRef e) { return EdgeRef{e.raw ^ 2}; }
  /// The dual edge from the left face of e to the right one.
  [[nodiscard]] static constexpr EdgeRef inv_rot(EdgeRef e) { return turned(e, 3); }
  /// Is it an edge between vertices, not one of the dual?
  [[nodiscard]] static constexpr bool is_primal(EdgeRef e) { return (e.raw & 1) == 0; }

  /// The next edge counter-clockwise with the same origin.
  [[nodiscard]] EdgeRef onext(EdgeRef e) const { return records_[e.raw >> 2].onext[e.raw & 3]; }
  /// The next edge clockwise with the same origin.
  [[nodiscard]] EdgeRef oprev(EdgeRef e) const { return rot(onext(rot(e))); }
  /// The next edge counter-clockwise with the same destination.
  [[nodiscard]] EdgeRef dnext(EdgeRef e) const { return sym(onext(sym(e))); }
  /// The next edge clockwise with the same destination.
  [[nodiscard]] EdgeRef dprev(EdgeRef e) const { return inv_rot(onext(inv_rot(e))); }
  /// The next edge counter-clockwise about the same left face: it starts where e ends.
  [[nodiscard]] EdgeRef lnext(EdgeRef e) const { return rot(onext(inv_rot(e))); }
  /// The edge before e about the same left face: it ends where e starts.
  [[nodiscard]] EdgeRef lprev(EdgeRef e) const { return sym(onext(e)); }
  /// The next edge counter-clockwise about the same right face: it ends where e starts.
  [[nodiscard]] EdgeRef rnext(EdgeRef e) const { return inv_rot(onext(rot(e))); }
  /// The edge before e about the same right face: it starts where e ends.
  [[nodiscard]] EdgeRef rprev(EdgeRef e) const { return onext(sym(e)); }

  // ---- vertices and faces ----

  /// e is an edge between vertices in all of these.
  [[nodiscard]] MaybeId<VertexId> origin(EdgeRef e) const { return record(e).vertices[end_of(e)]; }
  [[nodiscard]] MaybeId<VertexId> destination(EdgeRef e) const { return origin(sym(e)); }
  [[nodiscard]] MaybeId<FaceId> left(EdgeRef e) const { return record(e).left_faces[end_of(e)]; }
  [[nodiscard]] MaybeId<FaceId> right(EdgeRef e) const { return left(sym(e)); }

  /// Set the origin of this edge alone.
  void set_origin(EdgeRef e, MaybeId<VertexId> v) { record(e).vertices[end_of(e)] = v; }
  void set_destination(EdgeRef e, MaybeId<VertexId> v) { set_origin(sym(e), v); }
  /// Set the left face of this edge alone.
  void set_left(EdgeRef e, MaybeId<FaceId> f) { record(e).left_faces[end_of(e)] = f; }
  /// Set the origin of all edges of e's ring.
  void set_vertex(EdgeRef e, MaybeId<VertexId> v) {
    for_each_about_origin(e, [&](EdgeRef g) { set_origin(g, v); });
  }
  /// Set the left face of all edges about it.
  void set_face(EdgeRef e, MaybeId<FaceId> f) {
    for_each_about_left(e, [&](EdgeRef g) { set_left(g, f); });
  }

  // ---- the two basic operations ----

  /// A new component: one edge on a sphere of its own, with two vertices and one face.
  EdgeRef make_edge(MaybeId<VertexId> origin = {}, MaybeId<VertexId> destination = {});

  /// Exchange the tails of the rings of a and b. Where the two have different origins these become one, where
  /// they have the same it comes apart; likewise for the left faces. Its own inverse. Ids of vertices and
  /// faces stay as they are, edge by edge.
  void splice(EdgeRef a, EdgeRef b);

  // ---- what is made of them ----

  /// A new edge from a's destination to b's origin, its left face that of a and b, which must be the same;
  /// ids are taken from there. The face comes apart in two, or two components become one.
  EdgeRef connect(EdgeRef a, EdgeRef b);

  /// Take an edge out: its two faces become one, or a component comes apart. Ids stay as they are, edge by
  /// edge; the edge's record serves the next new edge.
  void remove(EdgeRef e);

  /// Turn an edge between two triangles counter-clockwise into the other diagonal of their quadrilateral: it
  /// then runs from the apex of its former right triangle to that of the left one. Vertices and faces keep
  /// their ids.
  void swap(EdgeRef e);

  // ---- iteration ----

  /// Edges, both directions and the dual counted once.
  [[nodiscard]] std::size_t edge_count() const { return records_.size() - free_.size(); }
  /// One more than the largest number q that an edge has had: the size of an array with one entry an edge.
  [[nodiscard]] std::size_t record_count() const { return records_.size(); }
  /// Does e name an edge, not one that was removed?
  [[nodiscard]] bool contains(EdgeRef e) const {
    return (e.raw >> 2) < records_.size() && records_[e.raw >> 2].onext[0] != removed;
  }
  /// Call visit(e) for every edge once, in one direction (r = 0), in the order of numbers.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t q = 0; q < records_.size(); ++q)
      if (records_[q].onext[0] != removed) visit(EdgeRef::from(4 * q));
  }
  /// Call visit(e) for every directed edge between vertices.
  template <class Visit>
  void for_each_directed_edge(const Visit& visit) const {
    for_each_edge([&](EdgeRef e) {
      visit(e);
      visit(sym(e));
    });
  }
  /// Call visit(g) for e and then for all other edges with its origin, counter-clockwise.
  template <class Visit>
  void for_each_about_origin(EdgeRef e, const Visit& visit) const {
    EdgeRef g = e;
    do {
      visit(g);
      g = onext(g);
    } while (g != e);
  }
  /// Call visit(g) for e and then for all other edges about its left face, counter-clockwise.
  template <class Visit>
  void for_each_about_left(EdgeRef e, const Visit& visit) const {
    EdgeRef g = e;
    do {
      visit(g);
      g = lnext(g);
    } while (g != e);
  }

  void reserve(std::size_t edges) { records_.reserve(edges); }

  /// The first thing that is wrong, in words: a ring that leads to a removed edge or changes between primal
  /// and dual; an edge at which rot(onext(rot(onext(e)))) is not e; two edges of one ring with different
  /// vertices; two edges about one face with different faces. Cost O(edges).
  [[nodiscard]] std::optional<std::string> validate() const;
  /// "edge 17" or "edge 17, turned by 3 quarters", for messages.
  [[nodiscard]] static std::string name(EdgeRef e);

 private:
  static constexpr EdgeRef removed{std::numeric_limits<IdRaw>::max()};

  struct Record {
    std::array<EdgeRef, 4> onext;
    std::array<MaybeId<VertexId>, 2> vertices;  ///< origins of e and of sym(e)
    std::array<MaybeId<FaceId>, 2> left_faces;  ///< left of e and of sym(e)
  };

  [[nodiscard]] static constexpr EdgeRef turned(EdgeRef e, IdRaw quarters) {
    return EdgeRef{(e.raw & ~IdRaw{3}) | ((e.raw + quarters) & 3)};
  }
  [[nodiscard]] static std::size_t end_of(EdgeRef e) {
    assert(is_primal(e));
    return (e.raw >> 1) & 1;
  }
  [[nodiscard]] Record& record(EdgeRef e) { return records_[e.raw >> 2]; }
  [[nodiscard]] const Record& record(EdgeRef e) const { return records_[e.raw >> 2]; }
  [[nodiscard]] EdgeRef& onext_of(EdgeRef e) { return record(e).onext[e.raw & 3]; }
  [[nodiscard]] std::optional<std::string> broken_algebra(EdgeRef e) const;
  [[nodiscard]] std::optional<std::string> broken_id(EdgeRef e) const;

  std::vector<Record> records_;
  std::vector<IdRaw> free_;  ///< numbers of the records of removed edges
};

}  // namespace leonhard
