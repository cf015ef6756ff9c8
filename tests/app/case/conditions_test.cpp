// SPDX-License-Identifier: MIT
#include "leonhard/app/case/conditions.hpp"

#include <doctest/doctest.h>

#include "tests/app/input_error_of.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

Case case_with(const std::vector<std::pair<std::string, BoundaryKind>>& sections) {
  Case c;
  c.file = "c.toml";
  std::size_t line = 10;
  for (const auto& [name, kind] : sections)
    c.boundary[name] = {kind, name, "c.toml:" + std::to_string(line++)};
  return c;
}

}  // namespace

TEST_CASE("sections_match_markers_by_name_and_by_number") {
  Case c = case_with({{"airfoil", BoundaryKind::slip_wall}, {"7", BoundaryKind::far_field}});
  c.boundary["7"].name = "outer";
  const auto conditions = match_conditions(c, {7, 3, 7}, {{3, "airfoil"}}, "a.su2");
  REQUIRE(conditions.size() == 2);
  CHECK(conditions.at(3).kind == BoundaryKind::slip_wall);
  CHECK(conditions.at(3).name == "airfoil");
  CHECK(conditions.at(7).kind == BoundaryKind::far_field);
  CHECK(conditions.at(7).name == "outer");
}

TEST_CASE("a_marker_without_a_condition_is_named") {
  const Case c = case_with({{"airfoil", BoundaryKind::slip_wall}});
  const std::string message = input_error_of([&] {
    return match_conditions(c, {1, 2}, {{1, "airfoil"}, {2, "far"}}, "a.su2");
  });
  CHECK(message.find("c.toml: the boundary marker \"far\" of a.su2 has no condition; add [boundary.far]") ==
        0);
}

TEST_CASE("a_condition_without_a_marker_is_named_with_its_line_and_the_nearest_marker") {
  const Case c = case_with({{"airfoli", BoundaryKind::slip_wall}});
  const std::string message = input_error_of([&] {
    return match_conditions(c, {1}, {{1, "airfoil"}}, "a.su2");
  });
  CHECK(message == "c.toml:10: a.su2 has no boundary marker \"airfoli\"; did you mean \"airfoil\"?");
}
