// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/bowyer_diagram.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "leonhard/delaunay/topology/conflict.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {
namespace {

template <class T>
unsigned index_of(const std::array<T, 3>& three, T one) {
  assert(three[0] == one || three[1] == one || three[2] == one);
  return three[0] == one ? 0 : three[1] == one ? 1 : 2;
}

void turn_ghost_first(BowyerDiagram::Vertex& v) {
  const auto turns = v.forming[1] == BowyerDiagram::ghost ? 1 : v.forming[2] == BowyerDiagram::ghost ? 2 : 0;
  std::rotate(v.forming.begin(), v.forming.begin() + turns, v.forming.end());
  std::rotate(v.neighbours.begin(), v.neighbours.begin() + turns, v.neighbours.end());
}

}  // namespace

BowyerDiagram::BowyerDiagram(std::span<const Point2> sites, VertexId a, VertexId b, VertexId c)
    : sites_(sites), corner_of_(sites.size()), last_site_(a), marked_(4), cut_from_(sites.size() + 1) {
  vertices_.reserve(2 * sites.size());
  const std::array three{a, b, c};
  const std::array ends{VoronoiVertexId{1}, VoronoiVertexId{2}, VoronoiVertexId{3}};
  vertices_.push_back({three, ends});
  for (unsigned i = 0; i < 3; ++i) {
    // The end at infinity of the edge between the two sites other than i.
    const unsigned next = (i + 1) % 3, last = (i + 2) % 3;
    vertices_.push_back({{ghost, three[last], three[next]}, {VoronoiVertexId{0}, ends[last], ends[next]}});
    corner_of_[three[i]] = VoronoiVertexId{0};
  }
}

std::size_t BowyerDiagram::insert(VertexId site) {
  // Step 1: the new site.
  site_ = sites_[site.index()];
  // Step 2: a vertex closer to it than to its forming sites.
  const VoronoiVertexId first = first_deletable();
  // Step 3: search for the other deletable vertices. Steps 4 and 5: their forming sites, and the edges that
  // remain.
  find_deletable(first);
  // Step 6: the new vertices, their forming sites and neighbours.
  form_vertices(site);
  last_site_ = site;
  return cut_edges_.size();
}

bool BowyerDiagram::is_deletable(VoronoiVertexId v) const {
  const auto& [a, b, c] = vertices_[v].forming;
  return in_conflict(sites_, a, b, c, site_);
}

VoronoiVertexId BowyerDiagram::next_corner(VoronoiVertexId v, VertexId site) const {
  const Vertex& corner = vertices_[v];
  return corner.neighbours[(index_of(corner.forming, site) + 1) % 3];
}

/// A site next to this one that is nearer to the new one; itself if there is none.
VertexId BowyerDiagram::nearer_site(VertexId than) const {
  const VoronoiVertexId first = corner_of_[than];
  VoronoiVertexId corner = first;
  do {
    const Vertex& at = vertices_[corner];
    const VertexId other = at.forming[(index_of(at.forming, than) + 1) % 3];
    if (other != ghost &&
        kernel::compare_distance(site_, sites_[than.index()], sites_[other.index()]) == Sign::positive)
      return other;
    corner = next_corner(corner, than);
  } while (corner != first);
  return than;
}

/// The site in whose territory the new one lies.
VertexId BowyerDiagram::nearest_site() const {
  VertexId nearest = last_site_, nearer = nearer_site(nearest);
  while (nearer != nearest) nearest = std::exchange(nearer, nearer_site(nearer));
  return nearest;
}

/// A deletable corner of the nearest site's territory: of this the new site takes a piece.
VoronoiVertexId BowyerDiagram::first_deletable() const {
  const VertexId nearest = nearest_site();
  VoronoiVertexId corner = corner_of_[nearest];
  while (!is_deletable(corner)) corner = next_corner(corner, nearest);
  return corner;
}

void BowyerDiagram::find_deletable(VoronoiVertexId first) {
  deletable_.assign(1, first);
  marked_[first.index()] = true;
  cut_edges_.clear();
  for (std::size_t k = 0; k < deletable_.size(); ++k) {
    const VoronoiVertexId v = deletable_[k];
    for (unsigned i = 0; i < 3; ++i) {
      const VoronoiVertexId w = vertices_[v].neighbours[i];
      if (marked_[w.index()]) continue;
      if (is_deletable(w)) {
        marked_[w.index()] = true;
        deletable_.push_back(w);
      } else {
        add_cut_edge(v, i);
      }
    }
  }
  for (const VoronoiVertexId v : deletable_) marked_[v.index()] = false;
}

void BowyerDiagram::add_cut_edge(VoronoiVertexId deleted, unsigned neighbour) {
  const Vertex& end = vertices_[deleted];
  const VoronoiVertexId kept = end.neighbours[neighbour];
  cut_edges_.push_back({kept, index_of(vertices_[kept].neighbours, deleted), end.forming[(neighbour + 1) % 3],
                        end.forming[(neighbour + 2) % 3], kept});
}

/// New vertices take the numbers of the deletable ones, then new numbers; there are two more of them.
VoronoiVertexId BowyerDiagram::number_for(std::size_t i) {
  if (i < deletable_.size()) return deletable_[i];
  marked_.push_back(false);
  return vertices_.push_back({});
}

VoronoiVertexId& BowyerDiagram::cut_from(VertexId site) {
  return cut_from_[site == ghost ? VertexId::from(sites_.size()) : site];
}

void BowyerDiagram::form_vertices(VertexId site) {
  for (std::size_t i = 0; i < cut_edges_.size(); ++i) {
    CutEdge& edge = cut_edges_[i];
    edge.made = number_for(i);
    vertices_[edge.made] = {{site, edge.from, edge.to}, {edge.kept, edge.made, edge.made}};
    vertices_[edge.kept].neighbours[edge.back] = edge.made;
    cut_from(edge.from) = edge.made;
    if (edge.from != ghost) corner_of_[edge.from] = edge.made;
  }
  for (const CutEdge& edge : cut_edges_) {
    const VoronoiVertexId next = cut_from(edge.to);
    vertices_[edge.made].neighbours[1] = next;
    vertices_[next].neighbours[2] = edge.made;
  }
  for (const CutEdge& edge : cut_edges_) turn_ghost_first(vertices_[edge.made]);
  corner_of_[site] = cut_edges_[0].made;
}

kernel::Circle BowyerDiagram::place(VoronoiVertexId v) const {
  assert(!is_at_infinity(v));
  const auto& [a, b, c] = vertices_[v].forming;
  return kernel::circumcircle(sites_[a.index()], sites_[b.index()], sites_[c.index()]);
}

GhostTriangulation BowyerDiagram::triangulation() const {
  GhostTriangulation dual;
  dual.reserve(vertices_.size());
  for (const Vertex& v : vertices_) dual.add(v.forming[0], v.forming[1], v.forming[2]);
  for (const VoronoiVertexId v : vertices_.ids())
    for (unsigned i = 0; i < 3; ++i) {
      const VoronoiVertexId w = vertices_[v].neighbours[i];
      if (w < v) continue;
      const unsigned back = index_of(vertices_[w].neighbours, v);
      dual.link(dual.side(AnyTriangleId{v.raw}, i), dual.side(AnyTriangleId{w.raw}, back));
    }
  return dual;
}

std::optional<std::string> BowyerDiagram::validate() const {
  for (const VoronoiVertexId v : vertices_.ids())
    for (unsigned i = 0; i < 3; ++i) {
      const Vertex &one = vertices_[v], &other = vertices_[one.neighbours[i]];
      const std::string name =
          "neighbour " + std::to_string(i) + " of Voronoi vertex " + std::to_string(v.raw);
      const auto back = std::find(other.neighbours.begin(), other.neighbours.end(), v);
      if (back == other.neighbours.end()) return name + " does not point back";
      const auto j = static_cast<unsigned>(back - other.neighbours.begin());
      if (one.forming[(i + 1) % 3] != other.forming[(j + 2) % 3] ||
          one.forming[(i + 2) % 3] != other.forming[(j + 1) % 3])
        return name + " does not share the sites of their edge";
    }
  return std::nullopt;
}

}  // namespace leonhard::delaunay
