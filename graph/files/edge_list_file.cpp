// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "leonhard/graph/files/listed_graph.hpp"
#include "leonhard/graph/graph_file.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::graph {
namespace {

/// The fields of a line, separated by semicolons, commas or tabs if the table has them, else by blanks; without quotation marks.
class EdgeFields {
 public:
  explicit EdgeFields(std::string_view text)
      : separator_(text.find(';') != std::string_view::npos    ? ';'
                   : text.find(',') != std::string_view::npos  ? ','
                   : text.find('\t') != std::string_view::npos ? '\t'
                                                               : ' ') {}

  const std::vector<std::string>& split(std::string_view line) {
    fields_.clear();
    std::string field;
    bool quoted = false, any = false;
    const auto end_field = [&] {
      if (separator_ != ' ' || any) fields_.push_back(trimmed(field));
      field.clear();
      any = false;
    };
    for (const char c : line) {
      if (c == '"') {
        quoted = !quoted;
        any = true;
      } else if (!quoted && (separator_ == ' ' ? is_blank(c) : c == separator_)) {
        end_field();
      } else {
        field += c;
        any = any || !is_blank(c);
      }
    }
    end_field();
    return fields_;
  }

 private:
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  static std::string trimmed(std::string_view field) {
    while (!field.empty() && is_blank(field.front())) field.remove_prefix(1);
    while (!field.empty() && is_blank(field.back())) field.remove_suffix(1);
    return std::string(field);
  }

  char separator_;
  std::vector<std::string> fields_;
};

/// Which columns hold an edge's ends and its weight.
struct EdgeColumns {
  std::size_t from = 0, to = 1;
  std::optional<std::size_t> weight;
  std::size_t least = 2;  ///< how many a line needs
};

std::string in_small_letters(std::string word) {
  std::ranges::transform(word, word.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

/// The columns that a header names in any order; none if it does not name both ends.
std::optional<EdgeColumns> named_columns(const std::vector<std::string>& header) {
  constexpr std::array<std::string_view, 6> from{"source", "from", "src", "node1", "u", "i"};
  constexpr std::array<std::string_view, 7> to{"target", "to", "dst", "dest", "node2", "v", "j"};
  constexpr std::array<std::string_view, 3> weight{"weight", "weights", "value"};
  const auto find = [&](const auto& names) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < header.size(); ++i)
      if (std::ranges::count(names, in_small_letters(header[i])) > 0) return i;
    return std::nullopt;
  };
  const auto source = find(from), target = find(to);
  if (!source || !target) return std::nullopt;
  return EdgeColumns{*source, *target, find(weight), std::max(*source, *target) + 1};
}

bool is_header(const io::TextScanner& scan) {
  const char first = scan.rest().front();
  return std::isalpha(static_cast<unsigned char>(first)) != 0 || first == '"';
}

/// Rows of an edge table as they stand.
struct EdgeTable {
  std::vector<std::array<std::string, 2>> ends;
  std::vector<double> weights;  ///< one a row, or none
  std::vector<std::uint32_t> lines;
};

EdgeTable read_table(io::TextScanner& scan, std::string_view text) {
  EdgeTable table;
  EdgeFields split(text);
  std::optional<EdgeColumns> columns;
  bool named = false;
  std::vector<std::string> words;  // of a first line: a header, or names of vertices if they come again
  std::uint32_t words_line = 0;
  for (bool first = true; scan.next_line(); first = false) {
    const std::vector<std::string>& fields = split.split(scan.rest());
    if (first && is_header(scan)) {
      columns = named_columns(fields);
      named = columns.has_value();
      if (named || fields.size() < 2 || fields[0] == "#") continue;
      if (std::ranges::none_of(
              fields, [](const std::string& f) { return f.find_first_of("0123456789") != f.npos; })) {
        words = fields;
        words_line = static_cast<std::uint32_t>(scan.line());
        continue;
      }
    }
    if (!columns)
      columns = EdgeColumns{0, 1, fields.size() > 2 ? std::optional<std::size_t>(2) : std::nullopt,
                            std::min<std::size_t>(fields.size(), 3)};
    if (fields.size() < 2) scan.fail("line ends where a vertex was expected", "give an edge's two vertices");
    if (fields.size() < columns->least || (columns->weight && fields.size() <= *columns->weight))
      scan.fail("line ends where an edge's weight, as on the first line was expected", "complete the line");
    if (!named && fields.size() > columns->least)
      scan.fail("found " + io::in_quotes(fields[columns->least]) + " where the line should end after " +
                    (columns->weight ? "an edge's weight" : "an edge's two vertices"),
                "name the columns in a first line: source,target,weight");
    table.ends.push_back({fields[columns->from], fields[columns->to]});
    table.lines.push_back(static_cast<std::uint32_t>(scan.line()));
    if (columns->weight) {
      double weight = 0;
      if (io::parse_number(fields[*columns->weight], weight) != io::NumberFault::none)
        scan.fail("found " + io::in_quotes(fields[*columns->weight]) +
                  " where an edge's weight, as on the first line was expected");
      table.weights.push_back(weight);
    }
  }
  const auto comes_again = [&](const std::array<std::string, 2>& ends) {
    return std::ranges::count(words, ends[0]) + std::ranges::count(words, ends[1]) > 0;
  };
  if (words.size() == 2 && table.weights.empty() && std::ranges::any_of(table.ends, comes_again)) {
    table.ends.insert(table.ends.begin(), {words[0], words[1]});
    table.lines.insert(table.lines.begin(), words_line);
  }
  if (table.ends.empty()) scan.fail("no edge was found", "give one edge a line, its two vertices");
  return table;
}

std::optional<std::int64_t> as_number(const std::string& word) {
  std::int64_t number = 0;
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

/// Numbers from 0, or from 1 where none is 0; names in the order in which they first come.
void number_ends(const EdgeTable& table, const std::string& source, detail::ListedGraph& listed,
                 GraphFile& file) {
  const auto is_named = [](const auto& ends) { return !as_number(ends[0]) || !as_number(ends[1]); };
  const auto name = std::ranges::find_if(table.ends, is_named);
  // One word among numbers is a mistake, not a name.
  const std::size_t named = static_cast<std::size_t>(std::ranges::count_if(table.ends, is_named));
  const auto line = [&](std::size_t row) { return at_line(source, table.lines[row]); };
  if (named > 0 && 2 * named < table.ends.size()) {
    const auto row = static_cast<std::size_t>(name - table.ends.begin());
    const std::string& word = as_number(table.ends[row][0]) ? table.ends[row][1] : table.ends[row][0];
    throw InputError(line(row), "found " + io::in_quotes(word) + " where a vertex was expected",
                     "most vertices have numbers");
  }
  std::unordered_map<std::string, std::uint32_t> number_of;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  if (named == 0)
    for (const auto& ends : table.ends)
      for (const std::string& end : ends) least = std::min(least, *as_number(end));
  const std::int64_t first = named == 0 && least == 1 ? 1 : 0;
  const auto vertex = [&](const std::string& end, std::size_t row) {
    if (named > 0) return number_of.emplace(end, static_cast<std::uint32_t>(number_of.size())).first->second;
    const std::int64_t number = *as_number(end);
    if (number < 0 || number >= std::numeric_limits<std::uint32_t>::max())
      throw InputError(line(row), "vertex " + end + " is out of range",
                       "number vertices from 0, below 2^32 - 1");
    return static_cast<std::uint32_t>(number - first);
  };
  for (std::size_t row = 0; row < table.ends.size(); ++row) {
    const std::uint32_t a = vertex(table.ends[row][0], row), b = vertex(table.ends[row][1], row);
    listed.entries.push_back({a, b, table.lines[row]});
    listed.vertices = std::max({listed.vertices, a + 1, b + 1});
  }
  file.first_number = static_cast<std::uint32_t>(first);
  if (named > 0)
    file.warnings.push_back(source +
                            ": vertices have names; they are numbered in the order in which these come");
  if (first == 1) file.warnings.push_back(source + ": no vertex has the number 0; numbers count from 1");
}

/// Whole weights as they are; others scaled, so that they keep six digits and more.
void take_weights(const EdgeTable& table, const std::string& source, detail::ListedGraph& listed,
                  GraphFile& file) {
  const auto is_whole = [](double w) { return w == std::floor(w) && std::abs(w) < 0x1p53; };
  if (std::ranges::all_of(table.weights, is_whole)) {
    for (const double w : table.weights) listed.weights.push_back(static_cast<std::int64_t>(w));
    return;
  }
  double largest = 0;
  for (std::size_t i = 0; i < table.weights.size(); ++i) {
    if (!(table.weights[i] >= 0))
      throw InputError(at_line(source, table.lines[i]), "an edge weighs " + mesh::words(table.weights[i]),
                       "weights are not negative");
    largest = std::max(largest, table.weights[i]);
  }
  double factor = 1;
  while (largest * factor < 1e6) factor *= 10;
  while (largest * factor >= 1e9) factor /= 10;
  for (const double w : table.weights)
    listed.weights.push_back(std::max<std::int64_t>(1, std::llround(w * factor)));
  file.warnings.push_back(source + ": weights are no whole numbers; they were multiplied by " +
                          mesh::words(factor) + " and rounded");
}

/// A stray large number would ask for memory beyond all measure.
void check_density(const std::string& source, const detail::ListedGraph& listed) {
  if (listed.vertices <= 1024 + 64 * listed.entries.size()) return;
  const auto largest = std::ranges::max_element(
      listed.entries, {}, [](const detail::ListedEdge& e) { return std::max(e.from, e.to); });
  throw InputError(at_line(source, largest->line),
                   "vertex " + std::to_string(listed.vertices - 1) + " in a list of " +
                       std::to_string(listed.entries.size()) + " edges",
                   "number the vertices one after another");
}

}  // namespace

GraphFile parse_edge_list(std::string_view text, const std::string& source) {
  std::string without_percent(text);  // two comment signs, the scanner knows one
  std::ranges::replace(without_percent, '%', '#');
  io::TextScanner scan(without_percent, source, {.comment = '#'});
  const EdgeTable table = read_table(scan, without_percent);
  GraphFile file;
  detail::ListedGraph listed;
  listed.source = source;
  number_ends(table, source, listed, file);
  take_weights(table, source, listed, file);
  check_density(source, listed);
  detail::assemble(std::move(listed), file);
  return file;
}

}  // namespace leonhard::graph
