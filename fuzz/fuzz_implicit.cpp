// SPDX-License-Identifier: MIT
// Predicates of crossings of lines and planes, and their rounding, against rational arithmetic.
#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/kernel/implicit_point.hpp"
#include "leonhard/kernel/implicit_point3.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact_implicit.hpp"

namespace k = leonhard::kernel;
namespace exact = leonhard::kernel::exact;
using k::Stage;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::fuzzing::Input;
using leonhard::fuzzing::report;

namespace {

constexpr std::array stages{Stage::filter, Stage::double_double, Stage::expansion, Stage::rational};

/// The crossing that the arguments define, or none if it is refused.
template <class Crossing, class... Arguments>
std::optional<Crossing> made(const Arguments&... arguments) {
  try {
    return Crossing(arguments...);
  } catch (const leonhard::InputError&) {
    return {};
  }
}

/// No double is nearer to the truth, and the error holds.
bool is_rounded_well(double x, double error, const mpq_class& truth) {
  constexpr double largest = std::numeric_limits<double>::max();
  const mpq_class distance = abs(x - truth);
  for (const double other : {std::nextafter(x, -largest), std::nextafter(x, largest)})
    if (abs(other - truth) < distance) return false;
  return std::isinf(error) || distance <= error;
}

/// An explicit point or a crossing, with its coordinates.
struct Any2 {
  std::variant<Point2, k::LineCrossing> point;
  exact::RationalPoint2 truth;
  [[nodiscard]] k::PointRef2 ref() const {
    return std::visit([](const auto& p) { return k::PointRef2(p); }, point);
  }
};
struct Any3 {
  std::variant<Point3, k::LinePlaneCrossing, k::ThreePlaneCrossing> point;
  exact::RationalPoint3 truth;
  [[nodiscard]] k::PointRef3 ref() const {
    return std::visit([](const auto& p) { return k::PointRef3(p); }, point);
  }
};

Any2 any_point(Input& input, std::span<const Point2> pool) {
  const auto next = [&] { return pool[input.take<std::uint8_t>() % pool.size()]; };
  const Point2 a = next();
  if (input.take<std::uint8_t>() % 4 == 0) return {a, exact::rational(a)};
  const Point2 b = next(), c = next(), d = next();
  const auto truth = exact::line_crossing(a, b, c, d);
  const auto crossing = made<k::LineCrossing>(a, b, c, d);
  if (crossing.has_value() != truth.has_value()) report("existence is wrong", std::array{a, b, c, d});
  if (!crossing) return {a, exact::rational(a)};
  return {*crossing, *truth};
}

Any3 any_point(Input& input, std::span<const Point3> pool) {
  std::array<Point3, 9> q;
  const unsigned kind = input.take<std::uint8_t>() % 4;
  for (Point3& p : std::span(q).first(kind == 0 ? 1 : kind == 1 ? 9 : 5))
    p = pool[input.take<std::uint8_t>() % pool.size()];
  const Any3 first{q[0], exact::rational(q[0])};
  if (kind == 0) return first;
  if (kind == 1) {
    const auto truth = exact::three_plane_crossing(
        exact::plane(q[0], q[1], q[2]), exact::plane(q[3], q[4], q[5]), exact::plane(q[6], q[7], q[8]));
    const auto crossing = made<k::ThreePlaneCrossing>(
        k::PlanePoints{q[0], q[1], q[2]}, k::PlanePoints{q[3], q[4], q[5]}, k::PlanePoints{q[6], q[7], q[8]});
    if (crossing.has_value() != truth.has_value()) report("existence is wrong", q);
    return crossing ? Any3{*crossing, *truth} : first;
  }
  const auto truth = exact::line_plane_crossing(q[0], q[1], exact::plane(q[2], q[3], q[4]));
  const auto crossing = made<k::LinePlaneCrossing>(q[0], q[1], q[2], q[3], q[4]);
  if (crossing.has_value() != truth.has_value()) report("existence is wrong", q);
  return crossing ? Any3{*crossing, *truth} : first;
}

void check_plane(Input& input, unsigned kind) {
  std::array<Point2, 8> pool;
  for (Point2& p : pool) p = input.point(kind);
  const Any2 a = any_point(input, pool), b = any_point(input, pool), c = any_point(input, pool),
             d = any_point(input, pool);
  const auto turn = exact::orient2d(a.truth, b.truth, c.truth);
  const auto inside = exact::incircle(a.truth, b.truth, c.truth, d.truth);
  const auto order = exact::compare_xy(a.truth, b.truth);
  if (k::orient2d(a.ref(), b.ref(), c.ref()) != turn) report("orient2d is wrong", pool);
  if (k::incircle(a.ref(), b.ref(), c.ref(), d.ref()) != inside) report("incircle is wrong", pool);
  for (const Stage s : stages) {
    if (k::orient2d_staged(a.ref(), b.ref(), c.ref(), s).sign != turn)
      report("orient2d_staged is wrong", pool);
    if (k::incircle_staged(a.ref(), b.ref(), c.ref(), d.ref(), s).sign != inside)
      report("incircle_staged is wrong", pool);
    if (k::compare_xy_staged(a.ref(), b.ref(), s).sign != order) report("compare_xy is wrong", pool);
  }
  const auto [point, error] = k::rounded(a.ref());
  if (!is_rounded_well(point.x, error, a.truth.x) || !is_rounded_well(point.y, error, a.truth.y))
    report("rounded is wrong", pool);
}

void check_space(Input& input, unsigned kind) {
  std::array<Point3, 8> pool;
  for (Point3& p : pool) p = input.point3(kind);
  const Any3 a = any_point(input, pool), b = any_point(input, pool), c = any_point(input, pool),
             d = any_point(input, pool), e = any_point(input, pool);
  const auto turn = exact::orient3d(a.truth, b.truth, c.truth, d.truth);
  const auto inside = exact::insphere(a.truth, b.truth, c.truth, d.truth, e.truth);
  const auto order = exact::compare_xyz(a.truth, b.truth);
  if (k::orient3d(a.ref(), b.ref(), c.ref(), d.ref()) != turn) report("orient3d is wrong", pool);
  if (k::insphere(a.ref(), b.ref(), c.ref(), d.ref(), e.ref()) != inside) report("insphere is wrong", pool);
  for (const Stage s : stages) {
    if (k::orient3d_staged(a.ref(), b.ref(), c.ref(), d.ref(), s).sign != turn)
      report("orient3d_staged is wrong", pool);
    if (k::insphere_staged(a.ref(), b.ref(), c.ref(), d.ref(), e.ref(), s).sign != inside)
      report("insphere_staged is wrong", pool);
    if (k::compare_xyz_staged(a.ref(), b.ref(), s).sign != order) report("compare_xyz is wrong", pool);
  }
  const auto [point, error] = k::rounded(a.ref());
  if (!is_rounded_well(point.x, error, a.truth.x) || !is_rounded_well(point.y, error, a.truth.y) ||
      !is_rounded_well(point.z, error, a.truth.z))
    report("rounded is wrong", pool);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const unsigned kind = input.take<std::uint8_t>();
  if (kind < 128)
    check_plane(input, kind);
  else
    check_space(input, kind);
  return 0;
}
