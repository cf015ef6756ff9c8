// SPDX-License-Identifier: MIT
#include "leonhard/kernel/point.hpp"

#include <charconv>
#include <initializer_list>
#include <ostream>
#include <string>

namespace leonhard {
namespace {

std::ostream& write(std::ostream& out, std::initializer_list<double> coordinates) {
  std::string text;
  for (const double c : coordinates) {
    char digits[32];
    text += text.empty() ? "(" : ", ";
    text.append(digits, std::to_chars(digits, digits + sizeof digits, c).ptr);
  }
  return out << text + ")";
}

}  // namespace

std::ostream& operator<<(std::ostream& out, Point2 p) { return write(out, {p.x, p.y}); }
std::ostream& operator<<(std::ostream& out, Vec2 v) { return write(out, {v.x, v.y}); }
std::ostream& operator<<(std::ostream& out, const Point3& p) { return write(out, {p.x, p.y, p.z}); }
std::ostream& operator<<(std::ostream& out, const Vec3& v) { return write(out, {v.x, v.y, v.z}); }

}  // namespace leonhard
