// SPDX-License-Identifier: MIT
#include "leonhard/graph/order.hpp"

#include <algorithm>
#include <string>

#include "leonhard/graph/ordering/boost_orderings.hpp"
#include "leonhard/graph/ordering/minimum_degree.hpp"
#include "leonhard/graph/ordering/nested_dissection.hpp"
#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

std::vector<std::uint32_t> hilbert(const CsrGraph& graph, std::span<const Point3> coordinates) {
  if (coordinates.size() != vertex_count(graph))
    throw InputError("coordinates",
                     std::to_string(coordinates.size()) + " points for " +
                         std::to_string(vertex_count(graph)) + " vertices",
                     "give one a vertex");
  const bool plane = std::ranges::all_of(coordinates, [](const Point3& p) { return p.z == 0; });
  if (!plane) return kernel::hilbert_order(coordinates);
  std::vector<Point2> points;
  points.reserve(coordinates.size());
  for (const Point3& p : coordinates) points.push_back({p.x, p.y});
  return kernel::hilbert_order(points);
}

OrderResult improved_by_rosen(const CsrGraph& graph, OrderOptions options) {
  if (options.start == OrderMethod::rosen)
    throw InputError("start", "rosen cannot start from rosen", "name the order to improve");
  options.method = options.start;
  const OrderResult start = order(graph, options);
  OrderResult result = rosen(graph, start.order, options.progress);
  if (start.outcome == OrderOutcome::stopped) result.outcome = OrderOutcome::stopped;
  return result;
}

}  // namespace

std::optional<OrderMethod> order_method_named(std::string_view name) {
  const auto found = std::ranges::find(named_order_methods, name, &NamedOrderMethod::name);
  if (found == named_order_methods.end()) return std::nullopt;
  return found->method;
}

OrderResult order(const CsrGraph& graph, const OrderOptions& options) {
  switch (options.method) {
    case OrderMethod::natural:
      return {natural_order(graph)};
    case OrderMethod::rosen:
      return improved_by_rosen(graph, options);
    case OrderMethod::cuthill_mckee:
      return {cuthill_mckee(graph)};
    case OrderMethod::reverse_cuthill_mckee:
      return {reverse_cuthill_mckee(graph)};
    case OrderMethod::gibbs_poole_stockmeyer:
      return gibbs_poole_stockmeyer(graph, options.progress);
    case OrderMethod::gibbs_king:
      return gibbs_king(graph, options.progress);
    case OrderMethod::king:
      return king(graph, options.progress);
    case OrderMethod::sloan:
      return sloan(graph, options.progress);
    case OrderMethod::spectral:
      return spectral_order(graph, options.seed, options.progress);
    case OrderMethod::minimum_degree:
      return minimum_degree(graph, options.progress);
    case OrderMethod::nested_dissection:
      return nested_dissection(graph, {.seed = options.seed, .progress = options.progress});
    case OrderMethod::hilbert:
      return {hilbert(graph, options.coordinates)};
    case OrderMethod::boost_cuthill_mckee:
      return detail::boost_cuthill_mckee(graph, options.progress);
    case OrderMethod::boost_king:
      return detail::boost_king(graph, options.progress);
    case OrderMethod::boost_sloan:
      return detail::boost_sloan(graph, options.progress);
    case OrderMethod::boost_minimum_degree:
      return detail::boost_minimum_degree(graph, options.progress);
  }
  return {natural_order(graph)};
}

}  // namespace leonhard::graph
