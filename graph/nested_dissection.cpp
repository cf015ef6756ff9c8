// SPDX-License-Identifier: MIT
#include "leonhard/graph/nested_dissection.hpp"

#include <array>
#include <string>
#include <utility>

#include "leonhard/graph/minimum_degree.hpp"
#include "leonhard/graph/separator.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using Vertices = std::vector<std::uint32_t>;

/// Divides again and again, numbering the sets in the sequence of their elimination.
class Dissection {
 public:
  Dissection(const CsrGraph& graph, const NestedDissectionOptions& options)
      : extract_(graph), options_(options), set_of_(vertex_count(graph), 0) {}

  void divide(Vertices vertices) {
    if (vertices.size() <= options_.leaf || stop()) return close_set(vertices);
    const CsrGraph piece = extract_(vertices);
    if (const Components parts = components(piece); parts.count() > 1) {
      Vertices small;  // components that are leaves need no set of their own
      for (Vertices& part : members(vertices, parts.component_of, parts.count()))
        if (part.size() > options_.leaf)
          divide(std::move(part));
        else
          small.insert(small.end(), part.begin(), part.end());
      return close_set(small);
    }
    std::array<Vertices, 3> sides = separated(piece, vertices);
    if (sides[0].empty() || sides[1].empty()) return close_set(vertices);
    Vertices().swap(vertices);
    divide(std::move(sides[0]));
    divide(std::move(sides[1]));
    close_set(sides[VertexSeparator::separator]);
  }

  [[nodiscard]] const std::vector<std::uint32_t>& set_of() const { return set_of_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  [[nodiscard]] bool stop() {
    stopped_ = stopped_ || options_.progress.stop_requested();
    return stopped_;
  }

  static std::vector<Vertices> members(const Vertices& vertices, const std::vector<std::uint32_t>& part_of,
                                       std::uint32_t parts) {
    std::vector<Vertices> result(parts);
    for (std::size_t i = 0; i < vertices.size(); ++i) result[part_of[i]].push_back(vertices[i]);
    return result;
  }

  std::array<Vertices, 3> separated(const CsrGraph& piece, const Vertices& vertices) {
    SeparatorOptions options;
    options.seed = options_.seed + set_count_;
    options.stop = options_.progress.stop;
    const VertexSeparator found = vertex_separator(piece, options);
    std::array<Vertices, 3> sides;
    for (std::size_t i = 0; i < vertices.size(); ++i) sides[found.side_of[i]].push_back(vertices[i]);
    return sides;
  }

  void close_set(const Vertices& vertices) {
    if (vertices.empty()) return;
    for (const std::uint32_t v : vertices) set_of_[v] = set_count_;
    ++set_count_;
    closed_ += vertices.size();
    options_.progress("nested dissection", static_cast<double>(closed_) / static_cast<double>(set_of_.size()));
  }

  SubgraphExtractor extract_;
  const NestedDissectionOptions& options_;
  std::vector<std::uint32_t> set_of_;
  std::uint32_t set_count_ = 0;
  std::size_t closed_ = 0;  ///< vertices that have their set
  bool stopped_ = false;
};

}  // namespace

OrderResult nested_dissection(const CsrGraph& graph, const NestedDissectionOptions& options) {
  if (options.leaf == 0) throw InputError("options", "leaves of 0 vertices", "give at least 1");
  Dissection dissection(graph, options);
  dissection.divide(natural_order(graph));
  OrderResult result;
  result.order = detail::constrained_minimum_degree(graph, dissection.set_of());
  if (dissection.stopped()) result.outcome = OrderOutcome::stopped;
  return result;
}

}  // namespace leonhard::graph
