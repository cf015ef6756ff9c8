// SPDX-License-Identifier: MIT
#include <cassert>
#include <queue>

#include "leonhard/delaunay/dynamic/answer_all.hpp"
#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/support/id_set.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {
namespace {

template <class LocationT>
ValueAt<LocationT> value_at(typename LocationT::Kind where, std::span<const VertexWeight> weights,
                            std::span<const double> values) {
  ValueAt<LocationT> result;
  result.where = where;
  if (!result.inside()) return result;
  result.value = 0;
  for (const auto& [vertex, weight] : weights)
    if (weight != 0) result.value += weight * values[vertex.index()];
  return result;
}

}  // namespace

template <class Sites, class PointT, class LocationT>
Moved DynamicQueries<Sites, PointT, LocationT>::move(VertexId v, const PointT& to) {
  sites().require_living(v);
  typename Sites::Search search = sites().search_for(to, v);
  const LocationT there = sites().locate_from(to, search);
  if (there.kind == LocationT::Kind::on_vertex) {
    const VertexId occupant = *there.vertices[0];
    return {occupant == v ? MoveOutcome::moved : MoveOutcome::occupied, occupant};
  }
  auto& mine = static_cast<Sites&>(*this);
  mine.remove(v);
  [[maybe_unused]] const Inserted again = mine.insert(to);
  assert(again.vertex == v && again.is_new);  // the id given back last is the first to be taken
  return {MoveOutcome::moved, v};
}

template <class Sites, class PointT, class LocationT>
LocationT DynamicQueries<Sites, PointT, LocationT>::locate(const PointT& p, MaybeId<VertexId> hint) const {
  typename Sites::Search search = sites().search_for(p, hint);
  return sites().locate_from(p, search);
}

template <class Sites, class PointT, class LocationT>
MaybeId<VertexId> DynamicQueries<Sites, PointT, LocationT>::nearest_vertex(const PointT& p,
                                                                           MaybeId<VertexId> hint) const {
  typename Sites::Search search = sites().search_for(p, hint);
  return sites().nearest_from(p, search);
}

template <class Sites, class PointT, class LocationT>
std::vector<VertexId> DynamicQueries<Sites, PointT, LocationT>::k_nearest_vertices(
    const PointT& p, std::size_t k, MaybeId<VertexId> hint) const {
  typename Sites::Search search = sites().search_for(p, hint);
  std::vector<VertexId> found, neighbours;
  const MaybeId<VertexId> nearest = sites().nearest_from(p, search);
  if (!nearest) return found;
  const auto comes_later = [&](VertexId a, VertexId b) { return sites().is_nearer(p, b, a); };
  std::priority_queue<VertexId, std::vector<VertexId>, decltype(comes_later)> next(comes_later);
  IdSet known;
  next.push(*nearest);
  known.insert((*nearest).raw);
  while (found.size() < k && !next.empty()) {
    const VertexId v = next.top();
    next.pop();
    found.push_back(v);
    sites().collect_neighbours(v, search, neighbours);
    for (const VertexId w : neighbours)
      if (known.insert(w.raw)) next.push(w);
  }
  return found;
}

template <class Sites, class PointT, class LocationT>
WeightsAt<LocationT> DynamicQueries<Sites, PointT, LocationT>::natural_neighbours(
    const PointT& p, MaybeId<VertexId> hint) const {
  typename Sites::Search search = sites().search_for(p, hint);
  const auto where = sites().find_natural_weights(p, search);
  return {where, search.weights};
}

template <class Sites, class PointT, class LocationT>
void DynamicQueries<Sites, PointT, LocationT>::require_values(std::span<const double> values) const {
  if (values.size() < sites().id_bound())
    throw InputError(
        "values",
        std::to_string(values.size()) + " values for vertex ids below " + std::to_string(sites().id_bound()),
        "give one an id");
}

template <class Sites, class PointT, class LocationT>
ValueAt<LocationT> DynamicQueries<Sites, PointT, LocationT>::interpolate_linear(
    const PointT& p, std::span<const double> values, MaybeId<VertexId> hint) const {
  require_values(values);
  typename Sites::Search search = sites().search_for(p, hint);
  const auto where = sites().find_linear_weights(p, search);
  return value_at<LocationT>(where, search.weights, values);
}

template <class Sites, class PointT, class LocationT>
ValueAt<LocationT> DynamicQueries<Sites, PointT, LocationT>::interpolate_natural_neighbour(
    const PointT& p, std::span<const double> values, MaybeId<VertexId> hint) const {
  require_values(values);
  typename Sites::Search search = sites().search_for(p, hint);
  const auto where = sites().find_natural_weights(p, search);
  return value_at<LocationT>(where, search.weights, values);
}

// ---- many at once ----

template <class Sites, class PointT, class LocationT>
std::vector<LocationT> DynamicQueries<Sites, PointT, LocationT>::locate(std::span<const PointT> points,
                                                                        unsigned threads) const {
  using Search = typename Sites::Search;
  return answer_all<LocationT>(points, threads, Search({}), [&](const PointT& p, Search& search) {
    return sites().locate_from(p, search);
  });
}

template <class Sites, class PointT, class LocationT>
std::vector<MaybeId<VertexId>> DynamicQueries<Sites, PointT, LocationT>::nearest_vertices(
    std::span<const PointT> points, unsigned threads) const {
  using Search = typename Sites::Search;
  return answer_all<MaybeId<VertexId>>(points, threads, Search({}), [&](const PointT& p, Search& search) {
    return sites().nearest_from(p, search);
  });
}

template <class Sites, class PointT, class LocationT>
std::vector<ValueAt<LocationT>> DynamicQueries<Sites, PointT, LocationT>::interpolate_linear(
    std::span<const PointT> points, std::span<const double> values, unsigned threads) const {
  require_values(values);
  using Search = typename Sites::Search;
  return answer_all<ValueAt<LocationT>>(points, threads, Search({}), [&](const PointT& p, Search& search) {
    const auto where = sites().find_linear_weights(p, search);
    return value_at<LocationT>(where, search.weights, values);
  });
}

template <class Sites, class PointT, class LocationT>
std::vector<ValueAt<LocationT>> DynamicQueries<Sites, PointT, LocationT>::interpolate_natural_neighbour(
    std::span<const PointT> points, std::span<const double> values, unsigned threads) const {
  require_values(values);
  using Search = typename Sites::Search;
  return answer_all<ValueAt<LocationT>>(points, threads, Search({}), [&](const PointT& p, Search& search) {
    const auto where = sites().find_natural_weights(p, search);
    return value_at<LocationT>(where, search.weights, values);
  });
}

template class DynamicQueries<DynamicTriangulation, Point2, PointLocation>;
template class DynamicQueries<DynamicTetrahedralization, Point3, TetLocation>;

}  // namespace leonhard::delaunay
