// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/collinear_points.hpp"

#include <iterator>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

/// The foot lies beyond a if the angle at a, between the ray to the last point and that to the foot's origin,
/// is acute.
bool CollinearPoints::Order::operator()(Point2 a, const Foot& foot) const {
  return a != foot.last && kernel::angle(foot.of, a, foot.last) == Sign::positive;
}

bool CollinearPoints::collinear_with(Point2 p) const {
  return size() < 2 || kernel::orient2d(first(), last(), p) == Sign::zero;
}

MaybeId<VertexId> CollinearPoints::find(Point2 p) const {
  const auto found = vertices_.find(p);
  return found == vertices_.end() ? MaybeId<VertexId>{} : found->second;
}

std::array<MaybeId<VertexId>, 2> CollinearPoints::around(Point2 p) const {
  std::array<MaybeId<VertexId>, 2> both;
  const auto not_before = vertices_.lower_bound(p), after = vertices_.upper_bound(p);
  if (not_before != vertices_.begin()) both[0] = std::prev(not_before)->second;
  if (after != vertices_.end()) both[1] = after->second;
  return both;
}

MaybeId<VertexId> CollinearPoints::nearest(Point2 p) const {
  if (empty()) return {};
  const auto beyond = vertices_.lower_bound(Foot{p, last()});  // never end(): the last point counts as beyond
  if (beyond == vertices_.begin()) return beyond->second;
  const auto before = std::prev(beyond);
  const bool take_before = kernel::compare_distance(p, before->first, beyond->first) != Sign::positive;
  return (take_before ? before : beyond)->second;
}

}  // namespace leonhard::delaunay
