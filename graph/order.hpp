// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/kernel/point.hpp"

/// One door to all orderings.
namespace leonhard::graph {

enum class OrderMethod {
  natural,                 ///< as it is
  rosen,                   ///< exchanges that improve another order
  cuthill_mckee,           ///< from a vertex of least degree
  reverse_cuthill_mckee,   ///< from a pseudo-peripheral vertex
  gibbs_poole_stockmeyer,  ///< level structures from both ends
  gibbs_king,              ///< the same levels, numbered for a small envelope
  king,                    ///< small envelope
  sloan,                   ///< small envelope
  spectral,                ///< by the Fiedler vector
  minimum_degree,          ///< little fill
  nested_dissection,       ///< little fill, on large graphs less than minimum_degree
  hilbert,                 ///< along a curve through the vertices' coordinates
  boost_cuthill_mckee,     ///< Boost.Graph's own, to compare with: reverse Cuthill-McKee,
  boost_king,              ///< King, reversed,
  boost_sloan,             ///< Sloan (hours for 10^6 vertices),
  boost_minimum_degree     ///< and multiple minimum degree
};

/// Every method with the word for it, as the program's --method takes it.
struct NamedOrderMethod {
  std::string_view name;
  OrderMethod method;
  bool of_boost = false;  ///< Boost.Graph's own, for those who compare
};
inline constexpr std::array named_order_methods{
    NamedOrderMethod{"natural", OrderMethod::natural},
    NamedOrderMethod{"rosen", OrderMethod::rosen},
    NamedOrderMethod{"cuthill-mckee", OrderMethod::cuthill_mckee},
    NamedOrderMethod{"reverse-cuthill-mckee", OrderMethod::reverse_cuthill_mckee},
    NamedOrderMethod{"gibbs-poole-stockmeyer", OrderMethod::gibbs_poole_stockmeyer},
    NamedOrderMethod{"gibbs-king", OrderMethod::gibbs_king},
    NamedOrderMethod{"king", OrderMethod::king},
    NamedOrderMethod{"sloan", OrderMethod::sloan},
    NamedOrderMethod{"spectral", OrderMethod::spectral},
    NamedOrderMethod{"minimum-degree", OrderMethod::minimum_degree},
    NamedOrderMethod{"nested-dissection", OrderMethod::nested_dissection},
    NamedOrderMethod{"hilbert", OrderMethod::hilbert},
    NamedOrderMethod{"boost-cuthill-mckee", OrderMethod::boost_cuthill_mckee, true},
    NamedOrderMethod{"boost-king", OrderMethod::boost_king, true},
    NamedOrderMethod{"boost-sloan", OrderMethod::boost_sloan, true},
    NamedOrderMethod{"boost-minimum-degree", OrderMethod::boost_minimum_degree, true},
};
[[nodiscard]] constexpr std::string_view to_string(OrderMethod method) {
  for (const auto& known : named_order_methods) {
    if (known.method == method) return known.name;
  }
  return "";
}
[[nodiscard]] std::optional<OrderMethod> order_method_named(std::string_view name);

struct OrderOptions {
  OrderMethod method = OrderMethod::reverse_cuthill_mckee;
  OrderMethod start = OrderMethod::natural;  ///< the order that rosen improves; not rosen itself
  std::span<const Point3> coordinates{};       ///< one a vertex (z = 0 in the plane), for hilbert alone
  std::uint64_t seed = 1;                    ///< of methods that draw random numbers
  Progress progress{};
};

/// An ordering of a graph's vertices by the method of one's choice; the same for the same graph and seed.
///
/// returns  stopped if it was; natural, hilbert and the two Cuthill-McKee methods take less time than a stop would save
///          and do not ask
/// throws  InputError if hilbert has not one finite point a vertex, or rosen is to start from itself
OrderResult order(const CsrGraph& graph, const OrderOptions& options = {});

}  // namespace leonhard::graph
