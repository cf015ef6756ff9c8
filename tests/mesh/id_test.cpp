// SPDX-License-Identifier: MIT
#include "leonhard/mesh/id.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <unordered_map>
#include <vector>

using namespace leonhard;

TEST_CASE("ids_of_an_array_are_all_its_indices_in_order") {
  const PerId<VertexId, double> values(std::vector<double>{3, 1, 2});
  std::vector<std::size_t> seen;
  for (const VertexId v : values.ids()) seen.push_back(v.index());
  CHECK(seen == std::vector<std::size_t>{0, 1, 2});
  CHECK(values.ids().size() == 3);
  CHECK(PerId<VertexId, double>().ids().begin() == PerId<VertexId, double>().ids().end());
}

TEST_CASE("id_range_serves_standard_algorithms") {
  const PerId<TriangleId, int> values(std::vector<int>{5, 7, 5});
  const auto ids = values.ids();
  CHECK(std::count_if(ids.begin(), ids.end(), [&](TriangleId t) { return values[t] == 5; }) == 2);
  const std::vector<TriangleId> copy(ids.begin(), ids.end());
  CHECK(copy.size() == 3);
  CHECK(copy[2] == TriangleId{2});
}

TEST_CASE("maybe_id_is_none_until_given_an_id") {
  MaybeId<EdgeId> edge;
  CHECK_FALSE(edge);
  CHECK(edge == MaybeId<EdgeId>());
  edge = EdgeId{4};
  CHECK(edge);
  CHECK(*edge == EdgeId{4});
  CHECK(edge != MaybeId<EdgeId>(EdgeId{5}));
}

TEST_CASE("value_or_is_the_id_or_the_fallback") {
  constexpr MaybeId<EdgeId> none;
  static_assert(none.value_or(EdgeId{7}) == EdgeId{7});
  static_assert(MaybeId(EdgeId{4}).value_or(EdgeId{7}) == EdgeId{4});
}

TEST_CASE("ids_are_written_as_their_numbers") {
  std::ostringstream out;
  out << VertexId{17} << ' ' << MaybeId(TetId{0}) << ' ' << MaybeId<TetId>();
  CHECK(out.str() == "17 0 none");
}

TEST_CASE("ids_are_keys_of_hashed_containers") {
  std::unordered_map<VertexId, int> count;
  for (const IdRaw raw : {3U, 5U, 3U}) ++count[VertexId{raw}];
  CHECK(count.size() == 2);
  CHECK(count[VertexId{3}] == 2);
  std::unordered_map<MaybeId<TriangleId>, int> behind;
  ++behind[MaybeId<TriangleId>()];
  ++behind[TriangleId{1}];
  ++behind[MaybeId<TriangleId>()];
  CHECK(behind.size() == 2);
  CHECK(behind[MaybeId<TriangleId>()] == 2);
}

TEST_CASE("an_id_beyond_what_ids_can_number_is_refused_and_does_not_wrap") {
  constexpr std::size_t least_too_large = std::numeric_limits<IdRaw>::max();
  CHECK(VertexId::from(least_too_large - 1).index() == least_too_large - 1);
  CHECK_THROWS_AS(static_cast<void>(VertexId::from(least_too_large)), InputError);
  CHECK(IdRange<VertexId>(least_too_large).size() == least_too_large);
  if constexpr (sizeof(IdRaw) < sizeof(std::size_t))
    CHECK_THROWS_AS(static_cast<void>(IdRange<VertexId>(least_too_large + 1)), InputError);
}
