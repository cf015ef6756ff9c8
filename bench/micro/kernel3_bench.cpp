// SPDX-License-Identifier: MIT
// Predicates of space on easy and hard points; predicate_bench.hpp says what is measured.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bench/micro/predicate_bench.hpp"
#include "leonhard/kernel/exact.hpp"
#include "leonhard/kernel/predicates3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::Vec3;
using leonhard::benching::Random;
using leonhard::benching::rounded_sign;
using leonhard::benching::unit;

namespace {

using Input = leonhard::benching::Input<Point3, 5>;

template <class Draw>
Input random_calls(Draw draw) {
  return leonhard::benching::random_calls<Point3, 5>(draw);
}

Input uniform() {
  return random_calls([](Random& r) { return Point3{unit(r), unit(r), unit(r)}; });
}
Input plane() {
  return random_calls([](Random& r) {
    const double x = unit(r), y = unit(r);
    return Point3{x, y, 0.1 * x + 0.3 * y};
  });
}
Input sphere() {
  return random_calls([](Random& r) {
    const Vec3 v{unit(r) - 0.5, unit(r) - 0.5, unit(r) - 0.5};
    return Point3{} + (1 / norm(v)) * v;
  });
}

/// Cells of a 16 x 16 x 16 grid of the given spacing: each call asks about five corners of one cell, four of them in
/// one face: always a tie, of orient3d and of insphere.
Input grid(double origin, double spacing) {
  constexpr std::uint32_t side = 16;
  Input input;
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t z = 0; z < side; ++z)
        input.points.push_back({origin + spacing * x, origin + spacing * y, origin + spacing * z});
  for (std::uint32_t x = 0; x + 1 < side; ++x)
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t z = 0; z + 1 < side; ++z) {
        const std::uint32_t first = (x * side + y) * side + z;
        input.calls.push_back({first, first + 1, first + side, first + side + 1, first + side * side});
      }
  return input;
}

// Each predicate, the bare determinant, the filter and the oracle in one form: (a, b, c, d, e).
struct Orient3d {
  static Sign predicate(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3&) {
    return k::orient3d(a, b, c, d);
  }
  static Sign bare(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3&) {
    return rounded_sign(dot(cross(b - a, c - a), d - a));
  }
  static bool filtered(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3&) {
    return k::orient3d_filter(a, b, c, d).is_certain();
  }
  static Sign oracle(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3&) {
    return k::exact::orient3d(a, b, c, d);
  }
};

struct Insphere {
  static Sign predicate(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return k::insphere(a, b, c, d, e);
  }
  /// With shared minors, as Shewchuk writes it.
  static Sign bare(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    const Vec3 u = a - e, v = b - e, w = c - e, t = d - e;
    const double uv = u.x * v.y - u.y * v.x, vw = v.x * w.y - v.y * w.x, wt = w.x * t.y - w.y * t.x;
    const double tu = t.x * u.y - t.y * u.x, uw = u.x * w.y - u.y * w.x, vt = v.x * t.y - v.y * t.x;
    const double vwt = wt * v.z - vt * w.z + vw * t.z, uwt = wt * u.z + tu * w.z + uw * t.z;
    const double uvt = vt * u.z + tu * v.z + uv * t.z, uvw = vw * u.z - uw * v.z + uv * w.z;
    return rounded_sign((vwt * dot(u, u) - uwt * dot(v, v)) + (uvt * dot(w, w) - uvw * dot(t, t)));
  }
  static bool filtered(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return k::insphere_filter(a, b, c, d, e).is_certain();
  }
  static Sign oracle(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return k::exact::insphere(a, b, c, d, e);
  }
};

struct InspherePerturbed : Insphere {
  static Sign predicate(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
    return k::insphere_perturbed(a, b, c, d, e);
  }
};

const bool registered = [] {
  const std::vector<std::pair<std::string, Input>> inputs{{"uniform", uniform()},
                                                          {"plane", plane()},
                                                          {"sphere", sphere()},
                                                          {"integer_grid", grid(0, 1)},
                                                          {"tenths_grid", grid(1.0 / 3, 0.1)},
                                                          {"tiny_grid", grid(0, 0x1p-1074)}};
  leonhard::benching::register_predicate<Orient3d>("orient3d", inputs);
  leonhard::benching::register_predicate<Insphere>("insphere", inputs);
  leonhard::benching::register_predicate<InspherePerturbed>("insphere_perturbed", inputs);
  return true;
}();

}  // namespace
