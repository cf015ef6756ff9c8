// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/space/coplanar_points.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <vector>

#include "leonhard/kernel/predicates3.hpp"

namespace leonhard::delaunay {

/// As in CollinearPoints: the foot lies beyond a if the angle at a, between the ray to the last point and that to the
/// foot's origin, is acute.
bool CoplanarPoints::Order::operator()(const Point3& a, const Foot& foot) const {
  return a != foot.last && kernel::angle(foot.of, a, foot.last) == Sign::positive;
}

bool CoplanarPoints::spans(const Point3& p) const {
  std::array<Point3, 4> with = basis_points_;
  const std::size_t count = basis_.count();
  with[count] = p;
  return first_tetrahedron(std::span<const Point3>(with).first(count + 1)).extent == extent();
}

MaybeId<VertexId> CoplanarPoints::find(const Point3& p) const {
  const auto found = vertices_.find(p);
  return found == vertices_.end() ? MaybeId<VertexId>{} : found->second;
}

MaybeId<VertexId> CoplanarPoints::nearest(const Point3& p) const {
  if (empty()) return {};
  if (extent() != Extent::plane) {
    const auto beyond = vertices_.lower_bound(Foot{p, vertices_.rbegin()->first});  // never end()
    if (beyond == vertices_.begin()) return beyond->second;
    const auto before = std::prev(beyond);
    const bool take_before = kernel::compare_distance(p, before->first, beyond->first) != Sign::positive;
    return (take_before ? before : beyond)->second;
  }
  auto best = vertices_.begin();
  for (auto other = best; other != vertices_.end(); ++other)
    if (kernel::compare_distance(p, other->first, best->first) == Sign::negative) best = other;
  return best->second;
}

void CoplanarPoints::insert(const Point3& p, VertexId v) {
  vertices_.emplace(p, v);
  if (spans(p)) return;
  assert(extent() != Extent::plane);
  basis_points_[basis_.count()] = p;
  basis_.extent = static_cast<Extent>(basis_.count() + 1);
}

void CoplanarPoints::erase(const Point3& p) {
  vertices_.erase(p);
  const auto last = basis_points_.begin() + static_cast<std::ptrdiff_t>(basis_.count());
  if (std::find(basis_points_.begin(), last, p) != last) find_basis();
}

void CoplanarPoints::find_basis() {
  std::vector<Point3> points;
  for (const auto& [point, vertex] : vertices_) points.push_back(point);
  basis_ = first_tetrahedron(points);
  for (std::size_t i = 0; i < basis_.count(); ++i) basis_points_[i] = points[basis_.points[i]];
}

}  // namespace leonhard::delaunay
