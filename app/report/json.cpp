// SPDX-License-Identifier: MIT
// Numbers and words are written by nlohmann's library, which takes long to compile: nobody else needs to.
#include "leonhard/app/report/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace leonhard::app {
namespace {

/// Bytes that are not UTF-8, as file names may hold, become U+FFFD.
std::string quoted(const std::string& words) {
  return nlohmann::json(words).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void new_line(std::string& out, int level) {
  out.append(1, '\n').append(2 * static_cast<std::size_t>(level), ' ');
}

}  // namespace

Json::Json(std::nullptr_t) {}
Json::Json(std::string words) : kind_(Kind::words), words_(std::move(words)) {}
Json::Json(std::initializer_list<JsonMember> members) : kind_(Kind::object), members_(members) {}
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json Json::array(std::initializer_list<Json> elements) {
  Json list;
  list.kind_ = Kind::array;
  for (const Json& element : elements) list.push_back(element);
  return list;
}

void Json::set(bool value) { kind_ = Kind::boolean, boolean_ = value; }
void Json::set(double value) { kind_ = Kind::real, real_ = value; }
void Json::set(std::int64_t value) { kind_ = Kind::integer, integer_ = value; }
void Json::set(std::uint64_t value) { kind_ = Kind::natural, natural_ = value; }

Json& Json::operator[](std::string_view key) {
  kind_ = Kind::object;
  const auto found = std::ranges::find(members_, key, &JsonMember::key);
  if (found != members_.end()) return found->value;
  members_.push_back({std::string(key), Json()});
  return members_.back().value;
}

void Json::update(const Json& other) {
  for (const JsonMember& member : other.members_) (*this)[member.key] = member.value;
}

void Json::erase(std::string_view key) {
  std::erase_if(members_, [key](const JsonMember& member) { return member.key == key; });
}

void Json::push_back(Json element) { members_.push_back({std::string(), std::move(element)}); }

void Json::write(std::string& out, int level, bool lines) const {
  switch (kind_) {
    case Kind::null:
      out += "null";
      return;
    case Kind::boolean:
      out += boolean_ ? "true" : "false";
      return;
    case Kind::integer:
      out += std::to_string(integer_);
      return;
    case Kind::natural:
      out += std::to_string(natural_);
      return;
    case Kind::real:
      out += nlohmann::json(real_).dump();  // null, where it is not finite
      return;
    case Kind::words:
      out += quoted(words_);
      return;
    case Kind::array:
    case Kind::object:
      break;
  }
  const bool is_object = kind_ == Kind::object;
  out += is_object ? '{' : '[';
  for (const JsonMember& member : members_) {
    if (&member != members_.data()) out += ',';
    if (lines) new_line(out, level + 1);
    if (is_object) out += quoted(member.key) + (lines ? ": " : ":");
    member.value.write(out, level + 1, lines);
  }
  if (lines && !members_.empty()) new_line(out, level);
  out += is_object ? '}' : ']';
}

std::string Json::line() const {
  std::string out;
  write(out, 0, false);
  return out;
}

std::string Json::text() const {
  std::string out;
  write(out, 0, true);
  return out;
}

}  // namespace leonhard::app
