// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2_parser.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/did_you_mean.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::io {

namespace {

/// Bytes that the shortest possible entry of a section takes, line break included.
constexpr std::size_t shortest_cell = 8, shortest_point = 4, shortest_boundary_element = 6;

/// What a tag cannot hold: blanks and quotation marks are dropped by readers, % begins a comment.
constexpr const char* never_in_tags = " \t%\"'";

}  // namespace

std::string su2_unnamed_tag(Marker marker) { return "marker_" + std::to_string(marker); }

std::map<Marker, std::string> su2_tags(const std::map<Marker, std::string>& names,
                                       const std::set<Marker>& used) {
  std::map<Marker, std::string> tags = names;
  for (const Marker marker : used) tags.try_emplace(marker, su2_unnamed_tag(marker));
  std::set<std::string> seen;
  for (const auto& [marker, tag] : tags) {
    if (!seen.insert(tag).second)
      throw InputError("marker " + std::to_string(marker),
                       "its name \"" + tag + "\" is also that of another marker",
                       "an SU2 file tells markers apart by name; give each its own");
    if (tag.find_first_of(never_in_tags) != std::string::npos)
      throw InputError(
          "marker " + std::to_string(marker),
          "its name \"" + tag + "\" holds a blank, a quotation mark or %, which an SU2 file cannot",
          "write it with _ instead");
  }
  return tags;
}

// ---- zones ----

namespace {

/// Where the keyword stands at the beginning of a line, from `from` on; npos if nowhere.
std::size_t find_keyword(std::string_view text, std::string_view keyword, std::size_t from) {
  for (std::size_t at = text.find(keyword, from); at != std::string_view::npos;
       at = text.find(keyword, at + 1)) {
    const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is 0
    const std::size_t after = text.find_first_not_of(" \t", at + keyword.size());
    const bool begins =
        text.substr(line, at - line).find_first_not_of(" \t\r\xEF\xBB\xBF") == std::string_view::npos;
    if (begins && after != std::string_view::npos && text[after] == '=') return at;
  }
  return std::string_view::npos;
}

/// The number after the first such keyword of a text.
std::int64_t number_after(const Su2Zone& zone, const std::string& source, std::string_view keyword) {
  const std::size_t at = find_keyword(zone.text, keyword, 0);
  if (at == std::string_view::npos) return 0;
  const auto lines = std::count(zone.text.begin(), zone.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::string_view line = zone.text.substr(at, zone.text.find('\n', at) - at);
  TextScanner scan(line, source,
                   {.comment = '%', .lines_before = zone.lines_before + static_cast<std::size_t>(lines)});
  scan.next_line();
  scan.key("a keyword");
  return scan.integer("a number");
}

/// "zone 1 (12 cells, 9 points), zone 2 (...)".
std::string zone_list(const std::vector<Su2Zone>& zones, const std::string& source) {
  std::string list;
  for (std::size_t i = 0; i < zones.size(); ++i)
    list += (i == 0 ? "zone " : ", zone ") + std::to_string(i + 1) + " (" +
            std::to_string(number_after(zones[i], source, "NELEM")) + " cells, " +
            std::to_string(number_after(zones[i], source, "NPOIN")) + " points)";
  return list;
}

std::vector<Su2Zone> su2_zones(std::string_view text) {
  std::vector<Su2Zone> zones;
  std::size_t at = find_keyword(text, "IZONE", 0), lines = 0, counted = 0;
  while (at != std::string_view::npos) {
    const std::size_t next = find_keyword(text, "IZONE", at + 1);
    lines += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                 text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    zones.push_back({text.substr(at, next - at), lines});
    at = next;
  }
  return zones;
}

}  // namespace

Su2Zone find_su2_zone(std::string_view text, const std::string& source, std::optional<std::size_t> zone) {
  const std::int64_t count = number_after({text}, source, "NZONE");
  if (count <= 1) {
    if (zone.value_or(1) == 1) return {text};
    throw InputError(source, "there is no zone " + std::to_string(*zone) + ": the file has one",
                     "leave out --zone");
  }
  const std::vector<Su2Zone> zones = su2_zones(text);
  if (zones.size() != static_cast<std::size_t>(count))
    throw InputError(source,
                     "NZONE= declares " + std::to_string(count) + " zones, but the file has " +
                         std::to_string(zones.size()) + " (IZONE=)",
                     "the file was cut short, or correct NZONE=");
  if (!zone || *zone < 1 || *zone > zones.size())
    throw InputError(
        source,
        (zone ? "there is no zone " + std::to_string(*zone) + ", but " : "the file holds several zones: ") +
            zone_list(zones, source),
        "name one: --zone 1");
  return zones[*zone - 1];
}

int su2_dimension(const Su2Zone& zone, const std::string& source) {
  const std::int64_t dimension = number_after(zone, source, "NDIME");
  if (dimension != 2 && dimension != 3)
    throw InputError(source, "the file does not tell its dimension (NDIME= 2 or 3)",
                     "was it written completely?");
  return static_cast<int>(dimension);
}

// ---- sections ----

Su2Parser::Su2Parser(std::string_view text, const Su2Zone& zone, const std::string& source, int dimension)
    : scan_(zone.text, source, {.comment = '%', .lines_before = zone.lines_before}),
      dimension_(dimension),
      notes_(read_marker_notes(text, '%')) {}

void Su2Parser::read_sections() {
  while (scan_.next_line()) {
    if (!scan_.at_key()) {
      if (skipping_) continue;
      scan_.fail_found(scan_.rest(), "a keyword (NDIME=, NELEM=, NPOIN=, NMARK=, MARKER_TAG=)");
    }
    read_section(std::string(scan_.key("a keyword")));
  }
  check_complete();
  number_markers();
}

void Su2Parser::read_section(const std::string& keyword) {
  static const std::vector<std::string> known{"NDIME",      "NELEM", "NPOIN", "NMARK",
                                              "MARKER_TAG", "NZONE", "IZONE"};
  const bool is_known = std::find(known.begin(), known.end(), keyword) != known.end();
  const bool is_first = sections_.insert(keyword).second;
  skipping_ = !is_known;
  if (is_known && !is_first && keyword != "MARKER_TAG")
    scan_.fail("the keyword " + keyword + "= comes a second time", "remove one of the two sections");
  if (keyword == "NDIME") return read_dimension();
  if (keyword == "NELEM") return read_cells();
  if (keyword == "NPOIN") return read_points();
  if (keyword == "NMARK") return read_marker_count();
  if (keyword == "MARKER_TAG") return read_marker();
  if (is_known || !is_first) return;  // NZONE and IZONE have been looked at before
  const std::string suggestion = did_you_mean(keyword, known);
  if (!suggestion.empty()) scan_.fail("unknown keyword " + keyword + "=", suggestion);
  warnings_.push_back(scan_.where() + ": the section " + keyword + "= is not known and was skipped");
}

void Su2Parser::read_dimension() {
  const std::int64_t dimension = scan_.integer("the dimension of the mesh");
  if (dimension != dimension_)
    scan_.fail("NDIME= " + std::to_string(dimension) + ": only meshes of " +
                   (dimension_ == 2 ? "the plane" : "space") + " can be read here",
               "give a mesh with NDIME= " + std::to_string(dimension_));
  scan_.expect_line_end("NDIME=");
}

/// The next line of a section, which must not be the next section already.
void Su2Parser::need_entry(const char* entry, std::size_t index, std::size_t count) {
  const bool ended = !scan_.next_line();
  if (ended || scan_.at_key())
    scan_.fail((ended ? std::string("the file ends") : "found the keyword " + in_quotes(scan_.rest())) +
                   " where " + entry + " " + std::to_string(index + 1) + " of " + std::to_string(count) +
                   " was expected",
               "the file was cut short, or the count is too large");
}

VertexId Su2Parser::read_vertex(const char* expected) {
  const std::int64_t id = scan_.integer(expected);
  if (id < 0 || static_cast<std::uint64_t>(id) >= std::numeric_limits<IdRaw>::max())
    scan_.fail("found " + std::to_string(id) + " where " + expected +
               " was expected: vertices are numbered from 0");
  return VertexId::from(static_cast<std::size_t>(id));
}

/// The number at the end of an entry says nothing, since entries are taken in their order; but it should
/// agree.
void Su2Parser::compare_number(const char* entry, std::size_t index, std::int64_t number) {
  if (number == static_cast<std::int64_t>(index) || number_warned_) return;
  number_warned_ = true;
  warnings_.push_back(scan_.where() + ": " + entry + " " + std::to_string(index) +
                      " says that its number is " + std::to_string(number) +
                      "; entries are numbered in the file's order, from 0");
}

namespace {

std::optional<std::int64_t> as_whole_number(std::string_view word) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

}  // namespace

/// A point may end with its number, or with its numbers in a part and in the whole mesh; in the plane a third coordinate may
/// come before, which a decimal point shows: two whole numbers have no one meaning, so only one is looked at.
void Su2Parser::read_point_numbers(std::size_t index) {
  if (scan_.line_done()) return;
  const std::string_view word = scan_.word("the point's number");
  std::optional<std::int64_t> number = as_whole_number(word);
  if (!number) {
    double z = 0;
    if (dimension_ == 3 || parse_number(word, z) != NumberFault::none)
      scan_.fail_found(word, "the point's number");
    check_height(z, index);
    if (scan_.line_done()) return;
    number = scan_.integer("the point's number");
  }
  if (scan_.line_done()) {
    compare_number("point", index, *number);
  } else {
    scan_.integer("the point's number in the whole mesh");
    if (dimension_ == 2 && !scan_.line_done()) scan_.integer("the point's number in the whole mesh");
  }
}

void Su2Parser::check_height(double z, std::size_t index) {
  if (!height_) height_ = z;
  if (z != *height_)
    scan_.fail("point " + std::to_string(index) + " has the third coordinate " + mesh::words(z) +
                   " unlike the others, which have " + mesh::words(*height_),
               "a mesh of the plane lies in z = const; a mesh of space has NDIME= 3");
}

void Su2Parser::read_cells() {
  const std::size_t count = scan_.count("the number of cells", shortest_cell);
  scan_.expect_line_end("NELEM=");
  reserve(count, 0);
  for (std::size_t c = 0; c < count; ++c) {
    need_entry("cell", c, count);
    read_cell(c);
    if (!scan_.line_done()) compare_number("cell", c, scan_.integer("the cell's number"));
    scan_.expect_line_end("the cell");
  }
}

void Su2Parser::read_points() {
  const std::size_t count = scan_.count("the number of points", shortest_point);
  if (!scan_.line_done()) scan_.count("the number of points without halo", 1);
  scan_.expect_line_end("NPOIN=");
  reserve(0, count);
  for (std::size_t p = 0; p < count; ++p) {
    need_entry("point", p, count);
    read_coordinates();
    read_point_numbers(p);
    scan_.expect_line_end("the point");
  }
}

void Su2Parser::read_marker_count() {
  marker_count_ = scan_.count("the number of markers", 1);
  scan_.expect_line_end("NMARK=");
}

std::string Su2Parser::read_tag() {
  std::string tag;
  for (const char c : scan_.rest())
    if (c != ' ' && c != '\t' && c != '"' && c != '\'') tag += c;
  if (tag.empty()) scan_.fail("MARKER_TAG= gives no name");
  if (std::any_of(tag.begin(), tag.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    scan_.fail("the marker's name " + in_quotes(tag) + " holds a control character", "choose a plain name");
  if (std::find(tags_.begin(), tags_.end(), tag) != tags_.end())
    scan_.fail("the marker " + in_quotes(tag) + " comes a second time",
               "give the two parts different names, or join them");
  if (tags_.size() >= static_cast<std::size_t>(std::numeric_limits<Marker>::max()))
    scan_.fail("too many markers");
  return tag;
}

void Su2Parser::read_marker() {
  if (scan_.rest() == "SEND_RECEIVE") return pass_over_halo();
  const std::string tag = read_tag();
  tags_.push_back(tag);
  scan_.need_line("MARKER_ELEMS=");
  if (scan_.key("MARKER_ELEMS=") != "MARKER_ELEMS")
    scan_.fail("the marker " + in_quotes(tag) + " has no MARKER_ELEMS= line after its MARKER_TAG=");
  const std::size_t count = scan_.count("the number of elements of the marker", shortest_boundary_element);
  scan_.expect_line_end("MARKER_ELEMS=");
  std::size_t vertices = 0;
  for (std::size_t e = 0; e < count; ++e) {
    need_entry("boundary element", e, count);
    if (scan_.rest().starts_with("1 ") || scan_.rest().starts_with("1\t")) {
      ++vertices;
      continue;
    }
    read_boundary_element(tag, static_cast<Marker>(tags_.size()));
    if (!scan_.line_done()) scan_.integer("the boundary element's number");
    scan_.expect_line_end("the boundary element");
  }
  if (vertices > 0)
    warnings_.push_back(scan_.where() + ": " + std::to_string(vertices) + " elements of the marker " +
                        in_quotes(tag) + " are single vertices (type 1), which were left out");
}

/// What a part of a mesh sends and receives: elements of type 1, after a line SEND_RECV= or not.
void Su2Parser::pass_over_halo() {
  if (halo_markers_++ == 0)
    warnings_.push_back(scan_.where() +
                        ": markers SEND_RECEIVE were left out: the file is one part of a partitioned mesh");
  scan_.need_line("MARKER_ELEMS=");
  if (scan_.key("MARKER_ELEMS=") != "MARKER_ELEMS") scan_.fail("SEND_RECEIVE has no MARKER_ELEMS= line");
  const std::size_t count = scan_.count("the number of elements of the marker", 2);
  scan_.expect_line_end("MARKER_ELEMS=");
  for (std::size_t e = 0; e < count;) {
    const bool ended = !scan_.next_line();
    if (!ended && scan_.at_key() && scan_.rest().starts_with("SEND_RECV")) continue;
    ++e;
    if (ended || scan_.at_key())
      scan_.fail("an element of SEND_RECEIVE is missing", "the file was cut short");
  }
}

void Su2Parser::check_complete() const {
  for (const char* section : {"NDIME", "NELEM", "NPOIN", "NMARK"})
    if (!sections_.contains(section))
      scan_.fail(std::string("the file ends without a section ") + section + "=",
                 "it was cut short, or is no SU2 mesh");
  const std::size_t found = tags_.size() + halo_markers_;
  if (found != marker_count_)
    scan_.fail("NMARK= declares " + std::to_string(marker_count_) + " markers, but the file has " +
                   std::to_string(found),
               found < marker_count_ ? "the file was cut short, or correct NMARK=" : "correct NMARK=");
}

/// Markers are numbered 1, 2, ... in the file's order while it is read. If the notes name every tag, their
/// numbers take over.
void Su2Parser::number_markers() {
  std::vector<Marker> number_of_tag(tags_.size());
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    const auto noted =
        std::find_if(notes_.begin(), notes_.end(), [&](const auto& note) { return note.second == tags_[i]; });
    if (noted == notes_.end()) {
      notes_.clear();
      break;
    }
    number_of_tag[i] = noted->first;
  }
  if (notes_.empty()) {
    for (std::size_t i = 0; i < tags_.size(); ++i) notes_.emplace(static_cast<Marker>(i + 1), tags_[i]);
  } else {
    renumber(number_of_tag);
  }
  std::erase_if(notes_, [](const auto& note) {
    return note.second == su2_unnamed_tag(note.first) ||
           note.second.find_first_of(never_in_tags) != std::string::npos;
  });
}

}  // namespace leonhard::io
