// SPDX-License-Identifier: MIT
// On which side, inside or outside: of points for which plain arithmetic is wrong.
#include <leonhard/kernel/constructions.hpp>
#include <leonhard/kernel/implicit_point.hpp>
#include <leonhard/kernel/predicates.hpp>
#include <leonhard/kernel/predicates3.hpp>

#include "check.hpp"

int main() {
  using namespace leonhard;
  Claims claim;
  const double ulp = 0x1p-53;
  claim(kernel::orient2d({0.5, 0.5}, {12, 12}, {24, 24}) == Sign::zero, "points of the diagonal are collinear");
  claim(kernel::orient2d({0.5, 0.5 + ulp}, {12, 12}, {24, 24}) != Sign::zero, "one of them an ulp above is not");
  claim(kernel::orient2d({0, 0}, {1e-300, 0}, {0, 1e-300}) == Sign::positive, "a product that underflows has a sign");
  claim(kernel::incircle({0, 0}, {1, 0}, {1, 1}, {0, 1}) == Sign::zero, "a square's corners lie on one circle");
  claim(kernel::incircle({0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}) == Sign::positive, "its centre lies inside");
  claim(kernel::insphere({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 1, 1}) == Sign::zero,
        "a cube's corners lie on one sphere");
  const kernel::LineCrossing crossing({0, 0}, {3, 1}, {1, 0}, {1, 1});  // (1, 1/3), no double
  claim(kernel::orient2d(Point2{0, 0}, Point2{3, 1}, crossing) == Sign::zero, "a crossing lies on its lines");
  claim(kernel::circumcircle(Point2{0, 0}, {2, 0}, {0, 2}).centre == Point2{1, 1}, "the circle about a right angle");
  return claim.failed();
}
