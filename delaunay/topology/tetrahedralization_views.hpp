// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/triangulation_views.hpp"
#include "leonhard/kernel/point.hpp"

/// What is iterated over in a DynamicTetrahedralization: valid until it changes.
namespace leonhard::delaunay {

using VertexQuadruple = std::array<VertexId, 4>;

using SpaceVertexView = LivingVertexView<Point3>;

/// The corners of each real tetrahedron, positive.
class TetrahedronView {
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

  explicit TetrahedronView(const GhostTetrahedralization& in) : in_(&in) {}
  [[nodiscard]] iterator begin() const { return {in_, 0}; }
  [[nodiscard]] iterator end() const { return {in_, in_->tet_count()}; }

 private:
  const GhostTetrahedralization* in_;
};

}  // namespace leonhard::delaunay
