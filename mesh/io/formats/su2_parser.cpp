// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2_parser.hpp"

#include <algorithm>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/did_you_mean.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"

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

Su2Parser::Su2Parser(std::string_view text, const std::string& source, int dimension)
    : scan_(text, source, {.comment = '%'}), dimension_(dimension), notes_(read_marker_notes(text, '%')) {}

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
  skipping_ = false;
  if (keyword != "MARKER_TAG" && !sections_.insert(keyword).second)
    scan_.fail("the keyword " + keyword + "= comes a second time", "remove one of the two sections");
  if (keyword == "NDIME") return read_dimension();
  if (keyword == "NELEM") return read_cells();
  if (keyword == "NPOIN") return read_points();
  if (keyword == "NMARK") return read_marker_count();
  if (keyword == "MARKER_TAG") return read_marker();
  if (keyword == "NZONE") return read_zone_count();
  static const std::vector<std::string> known{"NDIME", "NELEM", "NPOIN", "NMARK", "MARKER_TAG", "NZONE"};
  const std::string suggestion = did_you_mean(keyword, known);
  if (!suggestion.empty()) scan_.fail("unknown keyword " + keyword + "=", suggestion);
  warnings_.push_back(scan_.where() + ": the section " + keyword + "= is not known and was skipped");
  skipping_ = true;
}

void Su2Parser::read_dimension() {
  const std::int64_t dimension = scan_.integer("the dimension of the mesh");
  if (dimension != dimension_)
    scan_.fail("NDIME= " + std::to_string(dimension) + ": only meshes of " +
                   (dimension_ == 2 ? "the plane" : "space") + " can be read here",
               "give a mesh with NDIME= " + std::to_string(dimension_));
  scan_.expect_line_end("NDIME=");
}

void Su2Parser::read_zone_count() {
  if (scan_.integer("the number of zones") != 1)
    scan_.fail("the file holds several zones", "give each zone in a file of its own");
  scan_.expect_line_end("NZONE=");
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

/// A point may end with its number, or with its numbers in a part and in the whole mesh (or a z of 0 and
/// its number): two numbers have no one meaning, so only one is looked at.
void Su2Parser::read_point_numbers(std::size_t index) {
  if (scan_.line_done()) return;
  const std::int64_t number = scan_.integer("the point's number");
  if (scan_.line_done()) {
    compare_number("point", index, number);
  } else {
    scan_.integer("the point's number in the whole mesh");
  }
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
  const std::string tag = read_tag();
  tags_.push_back(tag);
  scan_.need_line("MARKER_ELEMS=");
  if (scan_.key("MARKER_ELEMS=") != "MARKER_ELEMS")
    scan_.fail("the marker " + in_quotes(tag) + " has no MARKER_ELEMS= line after its MARKER_TAG=");
  const std::size_t count = scan_.count("the number of elements of the marker", shortest_boundary_element);
  scan_.expect_line_end("MARKER_ELEMS=");
  for (std::size_t e = 0; e < count; ++e) {
    need_entry("boundary element", e, count);
    read_boundary_element(tag, static_cast<Marker>(tags_.size()));
    if (!scan_.line_done()) scan_.integer("the boundary element's number");
    scan_.expect_line_end("the boundary element");
  }
}

void Su2Parser::check_complete() const {
  for (const char* section : {"NDIME", "NELEM", "NPOIN", "NMARK"})
    if (!sections_.contains(section))
      scan_.fail(std::string("the file ends without a section ") + section + "=",
                 "it was cut short, or is no SU2 mesh");
  if (tags_.size() != marker_count_)
    scan_.fail("NMARK= declares " + std::to_string(marker_count_) + " markers, but the file has " +
                   std::to_string(tags_.size()),
               tags_.size() < marker_count_ ? "the file was cut short, or correct NMARK=" : "correct NMARK=");
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
