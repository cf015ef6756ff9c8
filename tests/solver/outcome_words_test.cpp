// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <initializer_list>
#include <set>
#include <string_view>

#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/lawson.hpp"
#include "leonhard/delaunay/refine.hpp"
#include "leonhard/delaunay/tet_algorithm.hpp"
#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/fiedler.hpp"
#include "leonhard/graph/order.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/orientation.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/sign.hpp"
#include "leonhard/solver/linear_solver.hpp"
#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/steady.hpp"

using namespace leonhard;

namespace {

/// Different words for all values from the first to the last, and none beyond it.
template <class Enum>
void check_words(Enum last) {
  std::set<std::string_view> words;
  for (int i = 0; i <= static_cast<int>(last); ++i) words.insert(to_string(static_cast<Enum>(i)));
  CHECK(words.size() == static_cast<std::size_t>(last) + 1);
  CHECK(!words.contains(""));
}

}  // namespace

TEST_CASE("every_outcome_has_a_word_of_its_own") {
  check_words(delaunay::TriangulateOutcome::stopped);
  check_words(delaunay::TetrahedralizeOutcome::stopped);
  check_words(delaunay::RefineOutcome::stopped);
  check_words(delaunay::SwapOutcome::stopped);
  check_words(delaunay::Extent::plane);
  check_words(graph::EdgeColourCount::stopped);
  check_words(graph::FiedlerOutcome::stopped);
  check_words(graph::OrderOutcome::stopped);
  check_words(graph::OrientationOutcome::not_planar);
  check_words(graph::PartitionOutcome::disconnected);
  check_words(solver::LinearOutcome::stopped);
  check_words(Verdict::stopped);
  check_words(BoundaryKind::symmetry);
}

TEST_CASE("words_of_outcomes_are_their_names") {
  static_assert(to_string(delaunay::RefineOutcome::vertex_budget_spent) == "vertex_budget_spent");
  static_assert(to_string(graph::PartitionOutcome::empty_parts) == "empty_parts");
  static_assert(to_string(Verdict::iteration_limit) == "iteration_limit");
  static_assert(to_string(Sign::negative) == "negative" && to_string(Sign::zero) == "zero" &&
                to_string(Sign::positive) == "positive");
}

TEST_CASE("words_of_methods_are_those_that_name_them") {
  for (const auto& known : delaunay::named_algorithms) CHECK(to_string(known.algorithm) == known.name);
  for (const auto& known : delaunay::named_tet_algorithms) CHECK(to_string(known.algorithm) == known.name);
  for (const auto& known : graph::named_order_methods) CHECK(to_string(known.method) == known.name);
  for (const auto& [name, method] : graph::named_partition_methods) CHECK(to_string(method) == name);
}
