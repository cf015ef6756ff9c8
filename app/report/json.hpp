// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace leonhard::app {

struct JsonMember;

/// A JSON value that is put together and written; objects keep the order in which keys were added. Nothing is read from
/// it: what decides is in the structs that it is made from.
///
///   Json report{{"vertices", 4}, {"fingerprint", nullptr}, {"low", Json::array({0.5, 1.0})}};
class Json {
 public:
  Json() : Json(nullptr) {}
  Json(std::nullptr_t);
  Json(std::string words);
  Json(std::string_view words) : Json(std::string(words)) {}
  Json(const char* words) : Json(std::string(words)) {}
  /// An object. Keys differ.
  Json(std::initializer_list<JsonMember> members);

  template <class Number>
  requires std::is_arithmetic_v<Number> Json(Number number) : Json() {
    if constexpr (std::same_as<Number, bool>)
      set(number);
    else if constexpr (std::floating_point<Number>)
      set(static_cast<double>(number));
    else if constexpr (std::signed_integral<Number>)
      set(std::int64_t{number});
    else
      set(std::uint64_t{number});
  }
  /// null where there is none
  template <class Value>
  Json(const std::optional<Value>& value) : Json() {
    if (value) *this = Json(*value);
  }
  /// An array of what a vector, a set or an array holds.
  template <class List>
  requires(!std::convertible_to<List, std::string_view>) && requires(const List& list) {
    list.begin() != list.end();
  }
  Json(const List& list) : Json(array()) {
    for (const auto& element : list) push_back(Json(element));
  }

  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  [[nodiscard]] static Json object() { return Json(std::initializer_list<JsonMember>{}); }
  [[nodiscard]] static Json array(std::initializer_list<Json> elements = {});

  /// The value of a key of an object, null at first; what was no object becomes one.
  Json& operator[](std::string_view key);
  /// The members of another object, in place of those of the same key or behind all others.
  void update(const Json& other);
  /// Take a key out of an object, if it is there.
  void erase(std::string_view key);
  /// At the end of an array.
  void push_back(Json element);

  /// On one line without spaces.
  [[nodiscard]] std::string line() const;
  /// For people: a line a value, two spaces a level, no newline at the end.
  [[nodiscard]] std::string text() const;

 private:
  enum class Kind : std::uint8_t { null, boolean, integer, natural, real, words, array, object };
  void set(bool value);
  void set(double value);
  void set(std::int64_t value);
  void set(std::uint64_t value);
  void write(std::string& out, int level, bool lines) const;

  Kind kind_ = Kind::null;
  union {
    bool boolean_;
    std::int64_t integer_;
    std::uint64_t natural_ = 0;
    double real_;
  };
  std::string words_;
  std::vector<JsonMember> members_;  ///< of an array: without keys
};

struct JsonMember {
  std::string key;
  Json value;
};

}  // namespace leonhard::app
