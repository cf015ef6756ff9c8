// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "tests/test_files.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;

namespace {

std::istream& operator>>(std::istream& in, Point2& p) { return in >> p.x >> p.y; }
std::istream& operator>>(std::istream& in, Point3& p) { return in >> p.x >> p.y >> p.z; }

std::ifstream open_vectors(const std::string& name) {
  std::ifstream file(leonhard::test::data_file("predicates/" + name));
  REQUIRE(file.is_open());
  return file;
}

}  // namespace

// The files' orient2d and incircle have our sign conventions; their orient3d and insphere, which are Shewchuk's, the
// opposite ones.

TEST_CASE("orient2d_answers_the_thousand_cases_of_georust_robust") {
  std::ifstream file = open_vectors("orient2d.txt");
  int number = 0, expected = 0, count = 0;
  for (Point2 a, b, c; file >> number >> a >> b >> c >> expected; ++count) {
    CAPTURE(number);
    CHECK(k::orient2d(a, b, c) == leonhard::sign_of(expected));
  }
  CHECK(count == 1000);
}

TEST_CASE("incircle_answers_the_thousand_cases_of_georust_robust") {
  std::ifstream file = open_vectors("incircle.txt");
  int number = 0, expected = 0, count = 0;
  for (Point2 a, b, c, d; file >> number >> a >> b >> c >> d >> expected; ++count) {
    CAPTURE(number);
    CHECK(k::incircle(a, b, c, d) == leonhard::sign_of(expected));
  }
  CHECK(count == 1000);
}

TEST_CASE("orient3d_answers_the_thousand_cases_of_georust_robust") {
  std::ifstream file = open_vectors("orient3d.txt");
  int number = 0, expected = 0, count = 0;
  for (Point3 a, b, c, d; file >> number >> a >> b >> c >> d >> expected; ++count) {
    CAPTURE(number);
    CHECK(k::orient3d(a, b, c, d) == -leonhard::sign_of(expected));
  }
  CHECK(count == 1000);
}

TEST_CASE("insphere_answers_the_thousand_cases_of_georust_robust") {
  std::ifstream file = open_vectors("insphere.txt");
  int number = 0, expected = 0, count = 0;
  for (Point3 a, b, c, d, e; file >> number >> a >> b >> c >> d >> e >> expected; ++count) {
    CAPTURE(number);
    CHECK(k::insphere(a, b, c, d, e) == -leonhard::sign_of(expected));
  }
  CHECK(count == 1000);
}
