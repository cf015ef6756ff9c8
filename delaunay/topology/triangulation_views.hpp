// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <span>

#include "leonhard/delaunay/plane/collinear_points.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

/// What is iterated over in a DynamicTriangulation: a few pointers each, valid until the triangulation
/// changes.
namespace leonhard::delaunay {

using VertexPair = std::array<VertexId, 2>;
using VertexTriple = std::array<VertexId, 3>;

/// What every forward iterator here has besides dereference and increment: the rest of its type, and
/// equality.
template <class Derived, class Value>
struct ViewIterator {
  using iterator_category = std::input_iterator_tag;  // operator* yields a value
  using value_type = Value;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = Value;

  Derived operator++(int) {
    Derived& self = static_cast<Derived&>(*this);
    const Derived old = self;
    ++self;
    return old;
  }
};

/// The vertices that live: those with finite coordinates. Points of the plane or of space.
template <class Point>
class LivingVertexView {
 public:
  class iterator : public ViewIterator<iterator, VertexId> {
   public:
    using ViewIterator<iterator, VertexId>::operator++;
    iterator() = default;
    iterator(std::span<const Point> points, std::size_t at) : points_(points), at_(at) { skip(); }
    [[nodiscard]] VertexId operator*() const { return VertexId::from(at_); }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }

   private:
    void skip() {
      while (at_ < points_.size() && !is_finite(points_[at_])) ++at_;
    }
    std::span<const Point> points_;
    std::size_t at_{};
  };

  explicit LivingVertexView(std::span<const Point> points) : points_(points) {}
  [[nodiscard]] iterator begin() const { return {points_, 0}; }
  [[nodiscard]] iterator end() const { return {points_, points_.size()}; }

 private:
  std::span<const Point> points_;
};
using VertexView = LivingVertexView<Point2>;

/// The corners of each real triangle, counter-clockwise.
class TriangleView {
 public:
  class iterator : public ViewIterator<iterator, VertexTriple> {
   public:
    using ViewIterator::operator++;
    iterator() = default;
    iterator(const GhostTriangulation* in, std::size_t at) : in_(in), at_(at) { skip(); }
    [[nodiscard]] VertexTriple operator*() const {
      const AnyTriangleId t = AnyTriangleId::from(at_);
      return {in_->corner(t, 0), in_->corner(t, 1), in_->corner(t, 2)};
    }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }

   private:
    void skip() {
      while (at_ < in_->triangle_count() && in_->is_ghost(AnyTriangleId::from(at_))) ++at_;
    }
    const GhostTriangulation* in_ = nullptr;
    std::size_t at_{};
  };

  explicit TriangleView(const GhostTriangulation& in) : in_(&in) {}
  [[nodiscard]] iterator begin() const { return {in_, 0}; }
  [[nodiscard]] iterator end() const { return {in_, in_->triangle_count()}; }

 private:
  const GhostTriangulation* in_;
};

/// The ends of each edge, each edge once; on a line, the pieces between vertices that follow each other.
class EdgeView {
 public:
  class iterator : public ViewIterator<iterator, VertexPair> {
   public:
    using ViewIterator::operator++;
    iterator() = default;
    iterator(const GhostTriangulation* in, std::size_t slot, CollinearPoints::const_iterator on_line)
        : in_(in), slot_(slot), on_line_(on_line) {
      skip();
    }
    [[nodiscard]] VertexPair operator*() const {
      if (in_->triangle_count() == 0) return {on_line_->second, std::next(on_line_)->second};
      return {in_->origin(side()), in_->destination(side())};
    }
    iterator& operator++() {
      if (in_->triangle_count() == 0) {
        ++on_line_;
      } else {
        ++slot_;
        skip();
      }
      return *this;
    }
    friend bool operator==(const iterator& a, const iterator& b) {
      return a.slot_ == b.slot_ && a.on_line_ == b.on_line_;
    }

   private:
    [[nodiscard]] SideId side() const {
      return GhostTriangulation::side(AnyTriangleId::from(slot_ / 3), static_cast<unsigned>(slot_ % 3));
    }
    /// An edge of two real triangles is shown by the side of the lower number, one of the hull by its real
    /// side.
    [[nodiscard]] bool is_shown() const {
      if (in_->is_ghost(in_->triangle(side()))) return false;
      const SideId twin = in_->twin(side());
      return in_->is_ghost(in_->triangle(twin)) || side() < twin;
    }
    void skip() {
      while (slot_ < 3 * in_->triangle_count() && !is_shown()) ++slot_;
    }
    const GhostTriangulation* in_ = nullptr;
    std::size_t slot_{};
    CollinearPoints::const_iterator on_line_;
  };

  EdgeView(const GhostTriangulation& in, const CollinearPoints& line) : in_(&in), line_(&line) {}
  [[nodiscard]] iterator begin() const { return {in_, 0, line_->begin()}; }
  [[nodiscard]] iterator end() const {
    return {in_, 3 * in_->triangle_count(), line_->empty() ? line_->end() : std::prev(line_->end())};
  }

 private:
  const GhostTriangulation* in_;
  const CollinearPoints* line_;
};

/// The other ends of a vertex's edges, counter-clockwise; on a line, the vertex before and the one after it.
class NeighbourView {
 public:
  class iterator : public ViewIterator<iterator, VertexId> {
   public:
    using ViewIterator::operator++;
    iterator() = default;
    iterator(const NeighbourView* of, std::size_t at, SideId side) : of_(of), at_(at), side_(side) { skip(); }
    [[nodiscard]] VertexId operator*() const {
      return of_->in_ == nullptr ? *of_->on_line_[at_] : of_->in_->destination(side_);
    }
    iterator& operator++() {
      advance();
      skip();
      return *this;
    }
    /// Of two iterators of the same view.
    friend bool operator==(const iterator& a, const iterator& b) {
      return a.at_ == b.at_ && a.side_ == b.side_;
    }

   private:
    /// In the plane at_ is 1 after the whole turn, when side_ is the first one again.
    void advance() {
      if (of_->in_ == nullptr) {
        ++at_;
        return;
      }
      side_ = of_->in_->turn_about_origin(side_);
      if (side_ == of_->first_) at_ = 1;
    }
    void skip() {
      if (of_->in_ == nullptr) {
        while (at_ < 2 && !of_->on_line_[at_]) ++at_;
      } else if (at_ == 0 && of_->in_->destination(side_) == GhostTriangulation::ghost) {
        advance();
      }
    }
    const NeighbourView* of_ = nullptr;
    std::size_t at_{};
    SideId side_{};
  };

  NeighbourView(const GhostTriangulation& in, SideId first) : in_(&in), first_(first) {}
  explicit NeighbourView(std::array<MaybeId<VertexId>, 2> on_line) : on_line_(on_line) {}
  [[nodiscard]] iterator begin() const { return {this, 0, first_}; }
  [[nodiscard]] iterator end() const { return {this, in_ == nullptr ? std::size_t{2} : 1, first_}; }

 private:
  const GhostTriangulation* in_ = nullptr;
  SideId first_{};
  std::array<MaybeId<VertexId>, 2> on_line_;
};

}  // namespace leonhard::delaunay
