// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "leonhard/app/case/keys.hpp"
#include "leonhard/app/case/place_value.hpp"

namespace leonhard::app {

/// The numbers a key accepts. "above" and "below" exclude the bound.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;
  bool high_excluded = false;

  [[nodiscard]] bool contains(double x) const;
  [[nodiscard]] std::string words() const;  ///< "a number above 0 and below 34"
};
[[nodiscard]] constexpr Range above(double low) { return {.low = low, .low_excluded = true}; }
[[nodiscard]] constexpr Range at_least(double low) { return {.low = low}; }
[[nodiscard]] constexpr Range between(double low, double high) { return {.low = low, .high = high}; }
[[nodiscard]] constexpr Range inside(double low, double high) { return {low, high, true, true}; }

/// What all section readers of one case file write down.
class CaseLog {
 public:
  explicit CaseLog(std::filesystem::path case_file, bool only_list = false)
      : file(std::move(case_file)), listing(only_list) {}

  /// throws InputError for the first unknown key, else for the first missing one, else returns.
  void raise() const;

  std::filesystem::path file;
  bool listing;  ///< only collect `known`: no table is there and nothing is missing
  std::vector<KeyInForce> in_force;
  std::vector<KnownKey> known;

 private:
  friend class SectionReader;
  struct Unknown {
    std::string where, section, shown, key;
    bool is_section;
  };
  struct Missing {
    std::string where, key, type;
  };
  std::vector<Unknown> unknown_;
  std::vector<Missing> missing_;
};

/// Reads one section (TOML table) of a case file, key by key. Each getter names the key, its default and what
/// it accepts; that one line is all a new key needs. What was never asked for is logged as unknown when the
/// reader goes out of scope. Getters throw InputError with file and line for a value of wrong type or out of
/// range.
class SectionReader {
 public:
  /// table   the section, or null if the file has none
  /// prefix  "flow" in messages; known keys are listed under the same name
  /// where   "case.toml:7" of the section, for keys that are missing from it
  SectionReader(CaseLog& log, const toml::table* table, std::string prefix, std::string where);
  ~SectionReader();
  SectionReader(const SectionReader&) = delete;
  SectionReader& operator=(const SectionReader&) = delete;

  /// Show keys as NAME.key from here on ("body.main" in place of "body").
  void show_as(std::string name) { shown_ = std::move(name); }

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] std::string where(std::string_view key) const;  ///< of the key, else of the section

  [[nodiscard]] double number(std::string_view key, double fallback, Range range = {},
                              std::string_view fallback_words = {});
  [[nodiscard]] double required_number(std::string_view key, Range range = {});
  [[nodiscard]] std::optional<double> optional_number(std::string_view key, Range range,
                                                      std::string_view fallback_words);
  [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t fallback, std::int64_t low,
                                     std::int64_t high, std::string_view fallback_words = {});
  [[nodiscard]] bool flag(std::string_view key, bool fallback);
  [[nodiscard]] std::string text(std::string_view key, std::string fallback, std::string_view fallback_words);
  /// A path, relative to the case file, of a file that exists; empty if not given.
  [[nodiscard]] std::filesystem::path existing_file(std::string_view key);
  /// `count` finite numbers; empty if not given.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t count, std::string fallback);
  /// Up to `most` finite numbers; empty if not given.
  [[nodiscard]] std::vector<double> list(std::string_view key, std::size_t most, std::string fallback);
  /// Two finite numbers, or three in space (require_dimension); empty if not given.
  [[nodiscard]] std::vector<double> vector(std::string_view key, std::string fallback);
  /// A number in a range, a formula of the place (text) or a table along a line; its value is checked again at each place, with an
  /// InputError. None if not given.
  [[nodiscard]] std::optional<PlaceValue> place_value(std::string_view key, Range range, std::string_view fallback_words);
  /// As vector, each element as place_value.
  [[nodiscard]] std::vector<PlaceValue> place_vector(std::string_view key, std::string fallback);

  template <class Value>
  using Words = std::span<const std::pair<std::string_view, Value>>;
  /// One of several words; without a fallback the key is required. Underscores count as hyphens.
  template <class Value>
  [[nodiscard]] Value choice(std::string_view key, std::optional<Value> fallback, Words<Value> words) {
    std::vector<std::string_view> names;
    std::optional<std::size_t> fallback_index;
    for (std::size_t i = 0; i < words.size(); ++i) {
      names.push_back(words[i].first);
      if (fallback == words[i].second) fallback_index = i;
    }
    return words[choose(key, fallback_index, names)].second;
  }

  /// throws InputError if the key was given although `reason` makes it idle.
  void refuse(std::string_view key, const std::string& reason) const;

  /// The section NAME below this one.
  [[nodiscard]] SectionReader section(std::string_view name);
  struct Named {
    std::string name;
    const toml::table* table;
    std::string where;
  };
  /// The tables of the array [[name]]; empty if there is none.
  [[nodiscard]] std::vector<Named> array_of_sections(std::string_view name);
  /// The tables below [name.*]; empty if there is none.
  [[nodiscard]] std::vector<Named> named_sections(std::string_view name);

 private:
  const toml::node* take(std::string_view key, const std::string& type, const std::string& fallback);
  const toml::node* take_section(std::string_view name);
  [[nodiscard]] std::string path(std::string_view key) const;
  [[noreturn]] void wrong(std::string_view key, const toml::node&, const std::string& expected) const;
  std::vector<double> checked_numbers(std::string_view key, std::size_t least, std::size_t most,
                                      const std::string& expected, std::string fallback);
  double checked_number(std::string_view key, const toml::node&, const Range&) const;
  PlaceValue value_of(std::string_view key, const toml::node&, const Range&, const std::string& expected) const;
  PlaceValue::Function formula(std::string_view key, const toml::node&) const;
  PlaceValue::Function table_along(std::string_view key, const toml::table&, const Range&) const;
  void in_force(std::string_view key, std::string value, bool by_default);
  std::size_t choose(std::string_view key, std::optional<std::size_t> fallback,
                     std::span<const std::string_view> names);

  CaseLog& log_;
  const toml::table* table_;
  std::string prefix_, shown_, where_;
  std::set<std::string, std::less<>> asked_;
};

/// A number as TOML, the shortest that reads back the same.
[[nodiscard]] std::string as_toml(double);
/// A text as TOML, quoted.
[[nodiscard]] std::string as_toml(std::string_view);

}  // namespace leonhard::app
