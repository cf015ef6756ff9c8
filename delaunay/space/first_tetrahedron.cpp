// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/first_tetrahedron.hpp"

#include <utility>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"

namespace leonhard::delaunay {
namespace {

/// Whether p is outside what the points found so far span.
///
/// point  point(i) is the point of index i
template <class PointOf>
bool is_independent(const PointOf& point, const FirstTetrahedron& found, const Point3& p) {
  const auto at = [&](std::size_t i) -> const Point3& { return point(found.points[i]); };
  switch (found.extent) {
    case Extent::nothing:
      return true;
    case Extent::point:
      return p != at(0);
    case Extent::line:
      return !are_collinear(at(0), at(1), p);
    case Extent::plane:
      return kernel::orient3d(at(0), at(1), at(2), p) != Sign::zero;
    case Extent::space:
      break;
  }
  return false;
}

/// index  index(i) is the index of the i-th of `count` points
template <class PointOf, class Index>
FirstTetrahedron find_first(const PointOf& point, std::size_t count, const Index& index) {
  FirstTetrahedron found;
  for (std::size_t i = 0; i < count && found.extent != Extent::space; ++i) {
    if (!is_independent(point, found, point(index(i)))) continue;
    found.points[found.count()] = index(i);
    found.extent = static_cast<Extent>(found.count() + 1);
  }
  if (found.extent == Extent::space) {
    auto& [a, b, c, d] = found.points;
    if (kernel::orient3d(point(a), point(b), point(c), point(d)) == Sign::negative) std::swap(a, b);
  }
  return found;
}

}  // namespace

bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
  return kernel::orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::zero &&
         kernel::orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == Sign::zero &&
         kernel::orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == Sign::zero;
}

FirstTetrahedron first_tetrahedron(std::span<const Point3> points, std::span<const std::uint32_t> order) {
  return find_first([&](std::size_t i) -> const Point3& { return points[i]; }, order.size(),
                    [&](std::size_t i) -> std::size_t { return order[i]; });
}

FirstTetrahedron first_tetrahedron(std::span<const Point3> points) {
  return find_first([&](std::size_t i) -> const Point3& { return points[i]; }, points.size(),
                    [](std::size_t i) { return i; });
}

FirstTetrahedron first_tetrahedron(std::span<const TetNode> nodes) {
  return find_first([&](std::size_t i) -> const Point3& { return nodes[i].point; }, nodes.size(),
                    [](std::size_t i) { return i; });
}

}  // namespace leonhard::delaunay
