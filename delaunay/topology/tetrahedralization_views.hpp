// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/delaunay/topology/triangulation_views.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

/// What is iterated over in a DynamicTetrahedralization: valid until it changes.
namespace leonhard::delaunay {

using VertexQuadruple = std::array<VertexId, 4>;

using TetVertexView = LivingVertexView<Point3>;

/// The ends of each edge between real tetrahedra, each edge once: shown by the tetrahedron about it of the lowest number.
class TetEdgeView {
 public:
  class iterator : public ViewIterator<iterator, VertexPair> {
   public:
    using ViewIterator::operator++;
    iterator() = default;
    iterator(const GhostTetrahedralization* in, std::size_t at) : in_(in), at_(at) { skip(); }
    [[nodiscard]] VertexPair operator*() const {
      const auto& corners = in_->corners[tet()];
      const auto& [i, k] = tet_edge_corners[at_ % 6];
      return {corners[i], corners[k]};
    }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }

   private:
    [[nodiscard]] TetId tet() const { return TetId::from(at_ / 6); }
    [[nodiscard]] bool is_shown() const {
      if (in_->is_ghost(tet())) return false;
      const auto [a, b] = **this;
      return turn_about_edge(*in_, tet(), a, b, [&](TetId t) { return in_->is_ghost(t) || t >= tet(); });
    }
    void skip() {
      while (at_ < 6 * in_->tet_count() && !is_shown()) ++at_;
    }
    const GhostTetrahedralization* in_ = nullptr;
    std::size_t at_{};  // six edges a tetrahedron
  };

  explicit TetEdgeView(const GhostTetrahedralization& in) : in_(&in) {}
  [[nodiscard]] iterator begin() const { return {in_, 0}; }
  [[nodiscard]] iterator end() const { return {in_, 6 * in_->tet_count()}; }

 private:
  const GhostTetrahedralization* in_;
};

/// The corners of each real tetrahedron, positive.
class TetView {
 public:
  class iterator : public ViewIterator<iterator, VertexQuadruple> {
   public:
    using ViewIterator::operator++;
    iterator() = default;
    iterator(const GhostTetrahedralization* in, std::size_t at) : in_(in), at_(at) { skip(); }
    [[nodiscard]] VertexQuadruple operator*() const { return in_->corners[TetId::from(at_)]; }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }

   private:
    /// Numbers out of use are ghosts all over.
    void skip() {
      while (at_ < in_->tet_count() && in_->is_ghost(TetId::from(at_))) ++at_;
    }
    const GhostTetrahedralization* in_ = nullptr;
    std::size_t at_{};
  };

  explicit TetView(const GhostTetrahedralization& in) : in_(&in) {}
  [[nodiscard]] iterator begin() const { return {in_, 0}; }
  [[nodiscard]] iterator end() const { return {in_, in_->tet_count()}; }

 private:
  const GhostTetrahedralization* in_;
};

}  // namespace leonhard::delaunay
