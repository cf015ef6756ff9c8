// SPDX-License-Identifier: MIT
#include "leonhard/app/report/json.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

using leonhard::app::Json;
using Peer = nlohmann::ordered_json;

TEST_CASE("json_is_written_as_by_the_library_that_reads_it") {
  const std::vector<double> numbers{0,
                                    -0.0,
                                    1,
                                    0.1,
                                    1e-5,
                                    123456789012345678.0,
                                    1e15,
                                    1e16,
                                    2.5e-308,
                                    1e300,
                                    -3.5,
                                    1.0 / 3,
                                    1e-320,
                                    5e-324,
                                    std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN()};
  const std::string words = "quote \" backslash \\ newline \n tab \t bell \a Grad °";
  Json ours{{"numbers", numbers},
            {"words", words},
            {"none", nullptr},
            {"yes", true},
            {"least", std::numeric_limits<std::int64_t>::min()},
            {"most", std::numeric_limits<std::uint64_t>::max()},
            {"small", std::uint32_t{7}},
            {"empty_list", Json::array()},
            {"empty_object", Json::object()},
            {"nested", Json::array({Json{{"a", Json::array({1, 2})}}, Json{{"b", "c"}}})}};
  Peer peer = {{"numbers", numbers},
               {"words", words},
               {"none", nullptr},
               {"yes", true},
               {"least", std::numeric_limits<std::int64_t>::min()},
               {"most", std::numeric_limits<std::uint64_t>::max()},
               {"small", 7},
               {"empty_list", Peer::array()},
               {"empty_object", Peer::object()},
               {"nested", Peer::array({Peer{{"a", {1, 2}}}, Peer{{"b", "c"}}})}};
  CHECK(ours.text() == peer.dump(2));
  CHECK(ours.line() == peer.dump());
}

TEST_CASE("keys_keep_their_places_when_they_are_updated_and_erased") {
  Json json{{"first", 1}, {"second", 2}};
  json["third"] = 3;
  json["first"] = "one";
  json.update(Json{{"second", 2.5}, {"fourth", false}});
  json.erase("third");
  json.erase("no such key");
  CHECK(json.line() == R"({"first":"one","second":2.5,"fourth":false})");
}

TEST_CASE("lists_sets_and_optional_values_become_json") {
  CHECK(Json(std::array<int, 2>{3, 4}).line() == "[3,4]");
  CHECK(Json(std::set<std::string>{"b", "a"}).line() == R"(["a","b"])");
  CHECK(Json(std::vector<std::vector<std::uint32_t>>{{1}, {}}).line() == "[[1],[]]");
  CHECK(Json(std::optional<double>()).line() == "null");
  CHECK(Json(std::optional<std::string>("x")).line() == R"("x")");
}

TEST_CASE("bytes_that_are_no_utf_8_do_not_stop_a_report") {
  CHECK(Json("caf\xE9").line() == "\"caf\xEF\xBF\xBD\"");
}
