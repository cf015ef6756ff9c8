// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/boost_orderings.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <boost/graph/minimum_degree_ordering.hpp>
#include <boost/graph/sloan_ordering.hpp>
#include <iterator>
#include <vector>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // index_begin, which is set before it is read
#endif
#include <boost/graph/king_ordering.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include "leonhard/graph/boost_graph.hpp"
#include "leonhard/graph/ordering/by_component.hpp"

namespace leonhard::graph::detail {
namespace {

using Order = std::vector<std::uint32_t>;

/// Thrown out of Boost's loops, which ask nobody whether to go on; never leaves this file.
struct Stopped {};

void step(StepCounter& steps) {
  if (!steps.step()) throw Stopped{};
}

/// Output iterator: appends to an order, one step a vertex.
class CountedOutput {
 public:
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = void;

  CountedOutput(Order& order, StepCounter& steps) : order_(&order), steps_(&steps) {}
  CountedOutput& operator*() { return *this; }
  CountedOutput& operator++() { return *this; }
  CountedOutput operator++(int) { return *this; }
  CountedOutput& operator=(std::uint32_t vertex) {
    order_->push_back(vertex);
    step(*steps_);
    return *this;
  }

 private:
  Order* order_;
  StepCounter* steps_;
};

/// Lvalue property map: degrees, one step a look at one.
class CountedDegrees : public boost::put_get_helper<std::ptrdiff_t&, CountedDegrees> {
 public:
  using key_type = std::size_t;
  using value_type = std::ptrdiff_t;
  using reference = std::ptrdiff_t&;
  using category = boost::lvalue_property_map_tag;

  CountedDegrees(std::vector<std::ptrdiff_t>& degrees, StepCounter& steps)
      : degrees_(&degrees), steps_(&steps) {}
  std::ptrdiff_t& operator[](std::size_t vertex) const {
    step(*steps_);
    return (*degrees_)[vertex];
  }

 private:
  std::vector<std::ptrdiff_t>* degrees_;
  StepCounter* steps_;
};

auto vertex_map(auto& values, const CsrGraph& graph) {
  return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, graph));
}

/// What an ordering of Boost's puts out for one connected graph, as far as it comes.
///
/// ordering  (graph, output, colours, degrees)
Order output_of(const CsrGraph& connected, StepCounter& steps, const auto& ordering) {
  Order order;
  order.reserve(vertex_count(connected));
  std::vector<boost::default_color_type> colours(vertex_count(connected));
  try {
    ordering(connected, CountedOutput(order, steps), vertex_map(colours, connected),
             boost::make_out_degree_map(connected));
  } catch (const Stopped&) {
  }
  return order;
}

Order reversed(Order order) {
  std::ranges::reverse(order);
  return order;
}

Order cuthill_mckee_of(const CsrGraph& connected, StepCounter& steps) {
  return reversed(output_of(connected, steps, [](const auto& graph, auto output, auto colours, auto degrees) {
    boost::cuthill_mckee_ordering(graph, output, colours, degrees);
  }));
}

Order king_of(const CsrGraph& connected, StepCounter& steps) {
  return reversed(output_of(connected, steps, [](const auto& graph, auto output, auto colours, auto degrees) {
    boost::king_ordering(graph, output, colours, degrees, get(boost::vertex_index, graph));
  }));
}

Order sloan_of(const CsrGraph& connected, StepCounter& steps) {
  return output_of(connected, steps, [](const auto& graph, auto output, auto colours, auto degrees) {
    int levels = 0;
    const std::uint32_t start = boost::find_starting_node(graph, std::uint32_t{0}, colours, degrees);
    const std::uint32_t end = boost::pseudo_peripheral_pair(graph, start, levels, colours, degrees);
    std::vector<double> priorities(vertex_count(graph));
    boost::sloan_ordering(graph, start, end, output, colours, degrees, vertex_map(priorities, graph));
  });
}

Order minimum_degree_of(const CsrGraph& connected, StepCounter& steps) {
  using Copy = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
  const std::uint32_t n = vertex_count(connected);
  Copy copy(n + std::size_t{1});
  for (std::uint32_t v = 0; v < n; ++v)
    for (const std::uint32_t w : neighbours(connected, v)) add_edge(v, w, copy);
  std::vector<std::ptrdiff_t> place(n + std::size_t{1}), at(n + std::size_t{1}), degrees(n + std::size_t{1}),
      together(n + std::size_t{1}, 1);
  const auto index = get(boost::vertex_index, copy);
  Order order;
  try {
    boost::minimum_degree_ordering(copy, CountedDegrees(degrees, steps), place.data(), at.data(),
                                   boost::make_iterator_property_map(together.begin(), index), 0, index);
  } catch (const Stopped&) {
    return order;
  }
  for (const std::ptrdiff_t v : at)
    if (v != n) order.push_back(static_cast<std::uint32_t>(v));
  return order;
}

}  // namespace

OrderResult boost_cuthill_mckee(const CsrGraph& graph, const Progress& progress) {
  StepCounter steps(progress, "boost-cuthill-mckee", vertex_count(graph));
  return order_by_component(graph, steps, cuthill_mckee_of);
}

OrderResult boost_king(const CsrGraph& graph, const Progress& progress) {
  StepCounter steps(progress, "boost-king", vertex_count(graph));
  return order_by_component(graph, steps, king_of);
}

OrderResult boost_sloan(const CsrGraph& graph, const Progress& progress) {
  StepCounter steps(progress, "boost-sloan", vertex_count(graph));
  return order_by_component(graph, steps, sloan_of);
}

OrderResult boost_minimum_degree(const CsrGraph& graph, const Progress& progress) {
  StepCounter steps(progress, "boost-minimum-degree", std::size_t{10} * vertex_count(graph));
  return order_by_component(graph, steps, minimum_degree_of);
}

}  // namespace leonhard::graph::detail
