// SPDX-License-Identifier: MIT
#include "leonhard/app/case/section_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <system_error>

#include "leonhard/app/case/spelling.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/did_you_mean.hpp"

namespace leonhard::app {
namespace {

std::string joined(const std::string& prefix, std::string_view key) {
  return prefix.empty() ? std::string(key) : prefix + "." + std::string(key);
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// What stands after `prefix.` in the known keys, up to the next dot: the keys and sections that a section may have.
std::vector<std::string> keys_below(const std::string& prefix, std::span<const KnownKey> known) {
  std::vector<std::string> keys;
  const std::string start = prefix.empty() ? "" : prefix + ".";
  for (const KnownKey& entry : known) {
    if (!entry.key.starts_with(start)) continue;
    const std::string rest = entry.key.substr(start.size());
    std::string key = rest.substr(0, rest.find('.'));
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(std::move(key));
  }
  return keys;
}

/// The value as the user wrote it, or as near as toml++ can print it; sections and arrays of them are named by their kind.
std::string shown_value(const toml::node& node) {
  if (node.is_table() && !node.as_table()->is_inline()) return "a section";
  if (node.is_array_of_tables()) return "a list of sections";
  if (const auto number = node.value_exact<double>()) return as_toml(*number);
  if (const auto text = node.value_exact<std::string>()) return as_toml(std::string_view(*text));
  std::ostringstream out;
  node.visit([&out](const auto& value) { out << value; });
  return out.str();
}

std::string line_of(const CaseLog& log, const toml::node& node) {
  return at_line(log.file.string(), node.source().begin.line);
}

/// Words such as "slip_wall" and "slip-wall" are taken for the same.
std::string with_hyphens(std::string word) {
  std::ranges::replace(word, '_', '-');
  return word;
}

}  // namespace

std::string as_toml(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return fmt::format("{}", number);
}

std::string as_toml(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "\"";
}

bool Range::contains(double x) const {
  return (low_excluded ? x > low : x >= low) && (high_excluded ? x < high : x <= high);
}

std::string Range::words() const {
  std::string words = "a finite number";
  if (std::isfinite(low))
    words += (low_excluded ? " above " : " from ") + as_toml(low) +
             (low_excluded || std::isfinite(high) ? "" : " on");
  if (std::isfinite(high)) words += (high_excluded ? " below " : " up to ") + as_toml(high);
  return words;
}

void CaseLog::raise() const {
  if (!unknown_.empty()) {
    const Unknown& first = unknown_.front();
    const std::vector<KnownKey> all = known_keys();
    const std::string kind = first.is_section ? "section" : "key";
    const std::string problem = fmt::format("unknown {} \"{}\"", kind, joined(first.shown, first.key));
    const std::vector<std::string> here = keys_below(first.section, all);
    if (const std::string near = io::did_you_mean(first.key, here); !near.empty())
      throw InputError(first.where, problem, near);
    for (const KnownKey& entry : all)  // the right key in the wrong section
      if (io::edit_distance(last_part(entry.key), first.key) <= 1)
        throw InputError(first.where, problem, "did you mean \"" + entry.key + "\"?");
    throw InputError(first.where, problem, suggestion(first.key, here));
  }
  if (!missing_.empty()) {
    const Missing& first = missing_.front();
    throw InputError(first.where, fmt::format("the key \"{}\" is missing", first.key),
                     fmt::format("add it: it takes {}", first.type));
  }
}

SectionReader::SectionReader(CaseLog& log, const toml::table* table, std::string prefix, std::string where)
    : log_(log), table_(table), prefix_(std::move(prefix)), shown_(prefix_), where_(std::move(where)) {}

SectionReader::~SectionReader() {
  if (!table_) return;
  std::vector<std::pair<toml::source_position, CaseLog::Unknown>> found;
  for (const auto& [key, node] : *table_)
    if (!asked_.contains(key.str()))
      found.push_back({node.source().begin,
                       {line_of(log_, node), prefix_, shown_, std::string(key.str()),
                        node.is_table() || node.is_array_of_tables()}});
  std::ranges::sort(found, {},
                    [](const auto& entry) { return std::pair(entry.first.line, entry.first.column); });
  for (auto& entry : found) log_.unknown_.push_back(std::move(entry.second));
}

bool SectionReader::has(std::string_view key) const { return table_ && table_->contains(key); }

std::string SectionReader::where(std::string_view key) const {
  return has(key) ? line_of(log_, *table_->get(key)) : where_;
}

std::string SectionReader::path(std::string_view key) const { return joined(shown_, key); }

const toml::node* SectionReader::take(std::string_view key, const std::string& type,
                                      const std::string& fallback) {
  asked_.emplace(key);
  if (log_.listing) log_.known.push_back({joined(prefix_, key), type, fallback});
  const toml::node* node = table_ ? table_->get(key) : nullptr;
  if (!node && fallback == "required" && !log_.listing) log_.missing_.push_back({where_, path(key), type});
  return node;
}

const toml::node* SectionReader::take_section(std::string_view name) {
  asked_.emplace(name);
  return table_ ? table_->get(name) : nullptr;
}

void SectionReader::in_force(std::string_view key, std::string value, bool by_default) {
  log_.in_force.push_back({path(key), std::move(value), by_default, where(key)});
}

void SectionReader::wrong(std::string_view key, const toml::node& node, const std::string& expected) const {
  throw InputError(line_of(log_, node),
                   fmt::format("{} = {} is not {}", path(key), shown_value(node), expected),
                   "correct the value");
}

double SectionReader::checked_number(std::string_view key, const toml::node& node, const Range& range) const {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value) || !range.contains(*value)) wrong(key, node, range.words());
  return *value;
}

double SectionReader::number(std::string_view key, double fallback, Range range,
                             std::string_view fallback_words) {
  const toml::node* node =
      take(key, range.words(), fallback_words.empty() ? as_toml(fallback) : std::string(fallback_words));
  const double value = node ? checked_number(key, *node, range) : fallback;
  in_force(key, as_toml(value), !node);
  return value;
}

double SectionReader::required_number(std::string_view key, Range range) {
  const toml::node* node = take(key, range.words(), "required");
  if (!node) return 1;  // CaseLog::raise tells before anyone uses it
  const double value = checked_number(key, *node, range);
  in_force(key, as_toml(value), false);
  return value;
}

std::optional<double> SectionReader::optional_number(std::string_view key, Range range,
                                                     std::string_view fallback_words) {
  const toml::node* node = take(key, range.words(), std::string(fallback_words));
  if (!node) return in_force(key, std::string(fallback_words), true), std::nullopt;
  const double value = checked_number(key, *node, range);
  in_force(key, as_toml(value), false);
  return value;
}

std::int64_t SectionReader::integer(std::string_view key, std::int64_t fallback, std::int64_t low,
                                    std::int64_t high, std::string_view fallback_words) {
  const std::string expected = fmt::format("an integer from {} to {}", low, high);
  const toml::node* node =
      take(key, expected, fallback_words.empty() ? fmt::format("{}", fallback) : std::string(fallback_words));
  const auto value = node ? node->value_exact<std::int64_t>() : fallback;
  if (!value || *value < low || *value > high) wrong(key, *node, expected);
  in_force(key, fmt::format("{}", *value), !node);
  return *value;
}

bool SectionReader::flag(std::string_view key, bool fallback) {
  const toml::node* node = take(key, "true or false", fmt::format("{}", fallback));
  const auto value = node ? node->value_exact<bool>() : fallback;
  if (!value) wrong(key, *node, "true or false");
  in_force(key, fmt::format("{}", *value), !node);
  return *value;
}

std::string SectionReader::text(std::string_view key, std::string fallback, std::string_view fallback_words) {
  const toml::node* node = take(key, "text", std::string(fallback_words));
  auto value = node ? node->value_exact<std::string>() : std::move(fallback);
  if (!value) wrong(key, *node, "text in quotes");
  in_force(key, value->empty() ? "none" : as_toml(std::string_view(*value)), !node);
  return *value;
}

std::filesystem::path SectionReader::existing_file(std::string_view key) {
  const std::string name = text(key, "", "none");
  if (!has(key)) return {};
  if (name.empty()) throw InputError(where(key), path(key) + " is empty", "give the name of a file");
  const std::filesystem::path file = log_.file.parent_path() / name;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw InputError(where(key),
                     fmt::format("{} = \"{}\": there is no file {}", path(key), name, file.string()),
                     "paths are relative to the case file; correct the path");
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(where(key), fmt::format("{} = \"{}\": {} is not a file", path(key), name, file.string()),
                     "name a file");
  return file;
}

std::vector<double> SectionReader::numbers(std::string_view key, std::size_t count, std::string fallback) {
  return checked_numbers(key, count, count, fmt::format("{} finite numbers in brackets", count), std::move(fallback));
}

std::vector<double> SectionReader::list(std::string_view key, std::size_t most, std::string fallback) {
  return checked_numbers(key, 1, most, fmt::format("1 to {} finite numbers in brackets", most), std::move(fallback));
}

std::vector<double> SectionReader::vector(std::string_view key, std::string fallback) {
  return checked_numbers(key, 2, 3, "2 finite numbers in brackets, in space 3", std::move(fallback));
}

std::vector<double> SectionReader::checked_numbers(std::string_view key, std::size_t least, std::size_t most,
                                                   const std::string& expected, std::string fallback) {
  const toml::node* node = take(key, expected, fallback);
  if (!node) return in_force(key, std::move(fallback), true), std::vector<double>{};
  const toml::array* array = node->as_array();
  if (!array || array->size() < least || array->size() > most) wrong(key, *node, expected);
  std::vector<double> values;
  std::string shown;
  for (const toml::node& element : *array) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) wrong(key, *node, expected);
    values.push_back(*value);
    shown += (shown.empty() ? "[" : ", ") + as_toml(*value);
  }
  in_force(key, shown + "]", false);
  log_.in_force.back().elements = values.size();
  return values;
}

std::optional<PlaceValue> SectionReader::place_value(std::string_view key, Range range, std::string_view fallback_words) {
  const std::string expected = range.words() + ", or of the place";
  const toml::node* node = take(key, expected, std::string(fallback_words));
  if (!node) return in_force(key, std::string(fallback_words), true), std::nullopt;
  PlaceValue value = value_of(key, *node, range, expected);
  in_force(key, shown_value(*node), false);
  return value;
}

std::vector<PlaceValue> SectionReader::place_vector(std::string_view key, std::string fallback) {
  const std::string expected = "2 finite numbers in brackets, in space 3, or of the place";
  const toml::node* node = take(key, expected, fallback);
  if (!node) return in_force(key, std::move(fallback), true), std::vector<PlaceValue>{};
  const toml::array* array = node->as_array();
  if (!array || array->size() < 2 || array->size() > 3) wrong(key, *node, expected);
  std::vector<PlaceValue> values;
  std::string shown;
  for (const toml::node& element : *array) {
    values.push_back(value_of(key, element, {}, expected));
    shown += (shown.empty() ? "[" : ", ") + shown_value(element);
  }
  in_force(key, shown + "]", false);
  log_.in_force.back().elements = values.size();
  return values;
}

PlaceValue SectionReader::value_of(std::string_view key, const toml::node& node, const Range& range,
                                   const std::string& expected) const {
  if (node.is_number()) return checked_number(key, node, range);
  if (!node.is_string() && !node.is_table()) wrong(key, node, expected);
  PlaceValue::Function of = node.is_string() ? formula(key, node) : table_along(key, *node.as_table(), range);
  const auto checked = [of = std::move(of), range, name = path(key), line = line_of(log_, node)](const Point3& at) {
    const double value = of(at);
    if (!std::isfinite(value) || !range.contains(value))
      throw InputError(line, fmt::format("{} is {} at ({}, {}, {})", name, value, at.x, at.y, at.z),
                       fmt::format("it takes {} at every place", range.words()));
    return value;
  };
  return {checked, shown_value(node)};
}

PlaceValue::Function SectionReader::formula(std::string_view key, const toml::node& node) const {
  const std::string text = *node.value_exact<std::string>();
  try {
    return parse_formula(text);
  } catch (const FormulaError& error) {
    const std::string place = error.column > 0 ? fmt::format(", column {} of the formula", error.column) : "";
    throw InputError(line_of(log_, node), fmt::format("{} = {}: {}{}", path(key), as_toml(std::string_view(text)), error.what(), place),
                     "give a formula of x, y and z, such as \"1 + 0.1*sin(pi*y)\"");
  }
}

PlaceValue::Function SectionReader::table_along(std::string_view key, const toml::table& table, const Range& range) const {
  constexpr auto remedy = "give { along = \"y\", at = [0, 0.5, 1], values = [1, 0.9, 1] }";
  const auto refuse_it = [&](const std::string& problem) {
    throw InputError(line_of(log_, table), fmt::format("{}: {}", path(key), problem), remedy);
  };
  for (const auto& [name, node] : table)
    if (name.str() != "along" && name.str() != "at" && name.str() != "values")
      refuse_it(fmt::format("a table has no \"{}\"", name.str()));
  const toml::node* along = table.get("along");
  if (!along || !along->is_string()) refuse_it("the table does not say along which coordinate");
  const auto list = [&](const char* name, const Range& of) {
    std::vector<double> numbers;
    const toml::node* node = table.get(name);
    if (!node || !node->is_array() || node->as_array()->empty()) refuse_it(fmt::format("the table has no list \"{}\"", name));
    for (const toml::node& element : *node->as_array()) numbers.push_back(checked_number(key, element, of));
    return numbers;
  };
  std::vector<double> at = list("at", {}), values = list("values", range);
  if (at.size() != values.size()) refuse_it(fmt::format("the table has {} places and {} values", at.size(), values.size()));
  if (std::ranges::adjacent_find(at, std::greater_equal<>()) != at.end()) refuse_it("the table's places do not ascend");
  return interpolate(formula(key, *along), std::move(at), std::move(values));
}

std::size_t SectionReader::choose(std::string_view key, std::optional<std::size_t> fallback,
                                  std::span<const std::string_view> names) {
  std::string expected = "one of";
  for (const std::string_view& name : names)
    expected += fmt::format("{} \"{}\"", &name == &names.front() ? "" : ",", name);
  const std::string fallback_words = fallback ? as_toml(names[*fallback]) : "required";
  const toml::node* node = take(key, expected, fallback_words);
  if (!node) {
    if (fallback) in_force(key, fallback_words, true);
    return fallback.value_or(0);
  }
  const auto word = node->value_exact<std::string>();
  if (!word) wrong(key, *node, expected);
  const auto found = std::ranges::find(names, with_hyphens(*word));
  if (found == names.end()) {
    const std::vector<std::string> candidates(names.begin(), names.end());
    throw InputError(where(key), fmt::format("{} = \"{}\" is not {}", path(key), *word, expected),
                     suggestion(with_hyphens(*word), candidates));
  }
  in_force(key, as_toml(*found), false);
  return static_cast<std::size_t>(found - names.begin());
}

void SectionReader::refuse(std::string_view key, const std::string& reason) const {
  if (has(key))
    throw InputError(where(key), fmt::format("{} is given but {}", path(key), reason), "remove it");
}

SectionReader SectionReader::section(std::string_view name) {
  const toml::node* node = take_section(name);
  if (node && !node->is_table())
    throw InputError(line_of(log_, *node),
                     fmt::format("{} = {} is not a section", path(name), shown_value(*node)),
                     fmt::format("write [{}] and its keys below it", path(name)));
  return {log_, node ? node->as_table() : nullptr, joined(prefix_, name),
          node ? line_of(log_, *node) : where_};
}

std::vector<SectionReader::Named> SectionReader::array_of_sections(std::string_view name) {
  const toml::node* node = take_section(name);
  std::vector<Named> sections;
  if (log_.listing) sections.push_back({std::string(name), nullptr, ""});
  if (!node) return sections;
  if (!node->is_array_of_tables())
    throw InputError(line_of(log_, *node), fmt::format("{} is not a list of sections", path(name)),
                     fmt::format("write [[{}]] with two brackets, once for each", name));
  for (const toml::node& element : *node->as_array())
    sections.push_back({std::string(name), element.as_table(), line_of(log_, element)});
  return sections;
}

std::vector<SectionReader::Named> SectionReader::named_sections(std::string_view name) {
  const toml::node* node = take_section(name);
  std::vector<Named> sections;
  if (log_.listing) sections.push_back({"NAME", nullptr, ""});
  if (!node) return sections;
  const std::string remedy = fmt::format("write [{}.NAME] and its keys below it", name);
  if (!node->is_table()) throw InputError(line_of(log_, *node), path(name) + " is not a section", remedy);
  for (const auto& [key, child] : *node->as_table()) {
    if (!child.is_table())
      throw InputError(line_of(log_, child), fmt::format("{}.{} is not a section", name, key.str()), remedy);
    sections.push_back({std::string(key.str()), child.as_table(), line_of(log_, child)});
  }
  return sections;
}

}  // namespace leonhard::app
