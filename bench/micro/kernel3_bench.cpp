// SPDX-License-Identifier: MIT
// Predicates of space on easy and hard points; predicate_bench.hpp says what is measured.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bench/micro/predicate_bench.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::Vec3;
using leonhard::benching::Random;
using leonhard::benching::rounded_sign;
using leonhard::benching::unit;

namespace {

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
  const auto inputs = leonhard::benching::inputs_of_space();
  leonhard::benching::register_predicate<Orient3d>("orient3d", inputs);
  leonhard::benching::register_predicate<Insphere>("insphere", inputs);
  leonhard::benching::register_predicate<InspherePerturbed>("insphere_perturbed", inputs);
  return true;
}();

}  // namespace
