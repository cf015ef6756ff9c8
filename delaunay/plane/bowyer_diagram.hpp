// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

using VoronoiVertexId = Id<struct VoronoiVertexTag>;

/// A Voronoi diagram as Bowyer stores it (Computer Journal 24, 1981): of each vertex the three sites that
/// form it and the three vertices that its edges lead to. Positions are not stored: whether a vertex lies
/// closer to a new site than to its forming sites is decided exactly from these.
///
/// An unbounded edge ends in a vertex at infinity, which is formed by the two sites of that edge and the
/// ghost. Where sites are cocircular, several vertices share one place: kernel::incircle_perturbed decides
/// which sites form them.
class BowyerDiagram {
 public:
  static constexpr VertexId ghost = GhostTriangulation::ghost;

  struct Vertex {
    std::array<VertexId, 3> forming;  ///< counter-clockwise; the ghost, if any, first
    std::array<VoronoiVertexId, 3>
        neighbours;  ///< [i] along the edge between the sites other than forming[i]
  };

  /// The diagram of three sites.
  ///
  /// sites    all that will be inserted, distinct and finite; the diagram keeps a reference
  /// a, b, c  counter-clockwise
  BowyerDiagram(std::span<const Point2> sites, VertexId a, VertexId b, VertexId c);

  /// Insert a site that is not in yet; Barth's notes 3.3b, steps 1 to 6. Cost O(new vertices), and the way
  /// from the site inserted before.
  ///
  /// returns  the number of new vertices, one for each corner of the site's territory
  std::size_t insert(VertexId site);

  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  [[nodiscard]] const Vertex& vertex(VoronoiVertexId v) const { return vertices_[v]; }
  [[nodiscard]] bool is_at_infinity(VoronoiVertexId v) const { return vertices_[v].forming[0] == ghost; }
  /// A corner of the territory of a site that was inserted.
  [[nodiscard]] VoronoiVertexId a_corner_of(VertexId site) const { return corner_of_[site]; }
  /// The next corner of a site's territory, counter-clockwise.
  [[nodiscard]] VoronoiVertexId next_corner(VoronoiVertexId v, VertexId site) const;
  /// The place of a vertex that is not at infinity, rounded, with its distance from the forming sites and
  /// error bounds. Throws InputError where it exceeds the largest double.
  [[nodiscard]] kernel::Circle place(VoronoiVertexId v) const;

  /// The dual: a triangle for every vertex, with the same number.
  [[nodiscard]] GhostTriangulation triangulation() const;

  /// The first broken invariant in words: neighbours that do not point back or do not share two forming
  /// sites. Cost O(vertices).
  [[nodiscard]] std::optional<std::string> validate() const;

 private:
  /// An edge that the new site's territory cuts.
  struct CutEdge {
    VoronoiVertexId kept;  ///< its end outside
    unsigned back;         ///< which neighbour of `kept` its deletable end is
    VertexId from, to;     ///< its sites, counter-clockwise about the new one
    VoronoiVertexId made;  ///< its new end
  };

  [[nodiscard]] bool is_deletable(VoronoiVertexId v) const;
  [[nodiscard]] VertexId nearer_site(VertexId than) const;
  [[nodiscard]] VertexId nearest_site() const;
  [[nodiscard]] VoronoiVertexId first_deletable() const;
  void find_deletable(VoronoiVertexId first);
  void add_cut_edge(VoronoiVertexId deleted, unsigned neighbour);
  void form_vertices(VertexId site);
  [[nodiscard]] VoronoiVertexId number_for(std::size_t i);
  [[nodiscard]] VoronoiVertexId& cut_from(VertexId site);

  std::span<const Point2> sites_;
  PerId<VoronoiVertexId, Vertex> vertices_;
  PerId<VertexId, VoronoiVertexId> corner_of_;
  VertexId last_site_;
  Point2 site_{};             // the one being inserted
  std::vector<bool> marked_;  // one a vertex: it is in deletable_
  std::vector<VoronoiVertexId> deletable_;
  std::vector<CutEdge> cut_edges_;
  PerId<VertexId, VoronoiVertexId>
      cut_from_;  // one a site and one for the ghost: the new vertex between it and the next
};

}  // namespace leonhard::delaunay
