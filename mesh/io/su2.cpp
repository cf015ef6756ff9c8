// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/su2.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/cell_soup.hpp"
#include "leonhard/mesh/io/did_you_mean.hpp"
#include "leonhard/mesh/io/marker_notes.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

// VTK's numbers, which SU2 uses.
constexpr std::int64_t line_type = 3, triangle_type = 5, quadrilateral_type = 9;

/// Bytes that the shortest possible entry of a section takes, line break included.
constexpr std::size_t shortest_cell = 8, shortest_point = 4, shortest_edge = 6;

/// What a tag cannot hold: blanks and quotation marks are dropped by readers, % begins a comment.
constexpr const char* never_in_tags = " \t%\"'";

std::string unnamed_tag(Marker marker) { return "marker_" + std::to_string(marker); }

class Su2Parser {
 public:
  Su2Parser(std::string_view text, const std::string& source) : scan_(text, source, {.comment = '%'}) {
    soup_.source = source;
    notes_ = read_marker_notes(text, '%');
  }

  MeshFile parse() {
    while (scan_.next_line()) {
      if (!scan_.at_key()) {
        if (skipping_) continue;
        scan_.fail_found(scan_.rest(), "a keyword (NDIME=, NELEM=, NPOIN=, NMARK=, MARKER_TAG=)");
      }
      read_section(std::string(scan_.key("a keyword")));
    }
    check_complete();
    number_markers();
    MeshFile result = assemble(std::move(soup_), EdgeRule::edges_are_the_boundary);
    result.warnings.insert(result.warnings.begin(), warnings_.begin(), warnings_.end());
    return result;
  }

 private:
  void read_section(const std::string& keyword) {
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

  void read_dimension() {
    const std::int64_t dimension = scan_.integer("the dimension of the mesh");
    if (dimension != 2)
      scan_.fail("NDIME= " + std::to_string(dimension) + ": only meshes of the plane can be read",
                 "give a mesh with NDIME= 2");
    scan_.expect_line_end("NDIME=");
  }

  void read_zone_count() {
    if (scan_.integer("the number of zones") != 1)
      scan_.fail("the file holds several zones", "give each zone in a file of its own");
    scan_.expect_line_end("NZONE=");
  }

  /// The next line of a section, which must not be the next section already.
  void need_entry(const char* entry, std::size_t index, std::size_t count) {
    const bool ended = !scan_.next_line();
    if (ended || scan_.at_key())
      scan_.fail((ended ? std::string("the file ends") : "found the keyword " + in_quotes(scan_.rest())) +
                     " where " + entry + " " + std::to_string(index + 1) + " of " + std::to_string(count) +
                     " was expected",
                 "the file was cut short, or the count is too large");
  }

  VertexId read_vertex(const char* expected) {
    const std::int64_t id = scan_.integer(expected);
    if (id < 0 || static_cast<std::uint64_t>(id) >= std::numeric_limits<IdRaw>::max())
      scan_.fail("found " + std::to_string(id) + " where " + expected +
                 " was expected: vertices are numbered from 0");
    return VertexId::from(static_cast<std::size_t>(id));
  }

  /// The number at the end of an entry says nothing, since entries are taken in their order; but it should
  /// agree.
  void compare_number(const char* entry, std::size_t index, std::int64_t number) {
    if (number == static_cast<std::int64_t>(index) || number_warned_) return;
    number_warned_ = true;
    warnings_.push_back(scan_.where() + ": " + entry + " " + std::to_string(index) +
                        " says that its number is " + std::to_string(number) +
                        "; entries are numbered in the file's order, from 0");
  }

  /// A point may end with its number, or with its numbers in a part and in the whole mesh (or a z of 0 and
  /// its number): two numbers have no one meaning, so only one is looked at.
  void read_point_numbers(std::size_t index) {
    if (scan_.line_done()) return;
    const std::int64_t number = scan_.integer("the point's number");
    if (scan_.line_done()) {
      compare_number("point", index, number);
    } else {
      scan_.integer("the point's number in the whole mesh");
    }
  }

  void read_cells() {
    const std::size_t count = scan_.count("the number of cells", shortest_cell);
    scan_.expect_line_end("NELEM=");
    soup_.cells.reserve(count);
    for (std::size_t c = 0; c < count; ++c) {
      need_entry("cell", c, count);
      const std::int64_t type = scan_.integer("the type of a cell (5 triangle, 9 quadrilateral)");
      if (type != triangle_type && type != quadrilateral_type)
        scan_.fail("cell " + std::to_string(c) + " has the type " + std::to_string(type) +
                       ", which is no cell of the plane",
                   "use 5 (triangle) or 9 (quadrilateral)");
      Cell cell;
      cell.corner_count = type == triangle_type ? 3 : 4;
      cell.line = static_cast<std::uint32_t>(scan_.line());
      for (std::uint32_t i = 0; i < cell.corner_count; ++i)
        cell.corners[i] = read_vertex("a vertex of the cell");
      if (!scan_.line_done()) compare_number("cell", c, scan_.integer("the cell's number"));
      scan_.expect_line_end("the cell");
      soup_.cells.push_back(cell);
    }
  }

  void read_points() {
    const std::size_t count = scan_.count("the number of points", shortest_point);
    if (!scan_.line_done()) scan_.count("the number of points without halo", 1);
    scan_.expect_line_end("NPOIN=");
    soup_.points.reserve(count);
    for (std::size_t p = 0; p < count; ++p) {
      need_entry("point", p, count);
      const double x = scan_.number("the x coordinate of a point");
      const double y = scan_.number("the y coordinate of a point");
      read_point_numbers(p);
      scan_.expect_line_end("the point");
      soup_.points.push_back({x, y});
    }
  }

  void read_marker_count() {
    marker_count_ = scan_.count("the number of markers", 1);
    scan_.expect_line_end("NMARK=");
  }

  void read_marker() {
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
    tags_.push_back(tag);
    scan_.need_line("MARKER_ELEMS=");
    if (scan_.key("MARKER_ELEMS=") != "MARKER_ELEMS")
      scan_.fail("the marker " + in_quotes(tag) + " has no MARKER_ELEMS= line after its MARKER_TAG=");
    const std::size_t count = scan_.count("the number of edges of the marker", shortest_edge);
    scan_.expect_line_end("MARKER_ELEMS=");
    for (std::size_t e = 0; e < count; ++e) {
      need_entry("boundary edge", e, count);
      read_boundary_edge(tag);
    }
  }

  void read_boundary_edge(const std::string& tag) {
    const std::int64_t type = scan_.integer("the type of a boundary edge (3 line)");
    if (type != line_type)
      scan_.fail("the marker " + in_quotes(tag) + " has an element of type " + std::to_string(type) +
                     ", but a boundary of the plane is made of lines",
                 type == 1 ? "this is one part of a partitioned mesh; give the whole" : "use 3 (line)");
    const VertexId from = read_vertex("a vertex of the boundary edge");
    const VertexId to = read_vertex("a vertex of the boundary edge");
    if (!scan_.line_done()) scan_.integer("the boundary edge's number");
    scan_.expect_line_end("the boundary edge");
    soup_.edges.push_back({from, to, static_cast<Marker>(tags_.size())});
  }

  void check_complete() const {
    for (const char* section : {"NDIME", "NELEM", "NPOIN", "NMARK"})
      if (!sections_.contains(section))
        scan_.fail(std::string("the file ends without a section ") + section + "=",
                   "it was cut short, or is no SU2 mesh");
    if (tags_.size() != marker_count_)
      scan_.fail(
          "NMARK= declares " + std::to_string(marker_count_) + " markers, but the file has " +
              std::to_string(tags_.size()),
          tags_.size() < marker_count_ ? "the file was cut short, or correct NMARK=" : "correct NMARK=");
  }

  /// Markers are numbered 1, 2, ... in the file's order while it is read. If the notes name every tag, their
  /// numbers take over.
  void number_markers() {
    std::vector<Marker> number_of_tag(tags_.size());
    for (std::size_t i = 0; i < tags_.size(); ++i) {
      const auto noted = std::find_if(notes_.begin(), notes_.end(),
                                      [&](const auto& note) { return note.second == tags_[i]; });
      if (noted == notes_.end()) {
        notes_.clear();
        break;
      }
      number_of_tag[i] = noted->first;
    }
    if (notes_.empty()) {
      for (std::size_t i = 0; i < tags_.size(); ++i) notes_.emplace(static_cast<Marker>(i + 1), tags_[i]);
    } else {
      for (MarkedEdge& edge : soup_.edges)
        edge.marker = number_of_tag[static_cast<std::size_t>(edge.marker) - 1];
    }
    std::erase_if(notes_, [](const auto& note) {
      return note.second == unnamed_tag(note.first) ||
             note.second.find_first_of(never_in_tags) != std::string::npos;
    });
    soup_.marker_names = std::move(notes_);
  }

  TextScanner scan_;
  CellSoup soup_;
  std::map<Marker, std::string> notes_;
  std::set<std::string> sections_;
  std::vector<std::string> tags_;
  std::size_t marker_count_ = 0;
  bool skipping_ = false;       ///< inside a section that is not known
  bool number_warned_ = false;  ///< one warning about entry numbers is enough
  std::vector<std::string> warnings_;
};

/// The tag of every marker of the boundary, and the names of the others.
std::map<Marker, std::string> tags_of(const TriangleMesh& mesh) {
  std::map<Marker, std::string> tags = mesh.marker_names;
  for (const MarkedEdge& edge : mesh.boundary) tags.try_emplace(edge.marker, unnamed_tag(edge.marker));
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

void append_line(std::string& text, std::initializer_list<std::size_t> numbers) {
  for (const std::size_t number : numbers) {
    append_number(text, number);
    text += ' ';
  }
  text.back() = '\n';
}

}  // namespace

MeshFile parse_su2(std::string_view text, const std::string& source) {
  return Su2Parser(text, source).parse();
}

MeshFile read_su2(const std::filesystem::path& path) {
  return parse_su2(read_whole_file(path), path.string());
}

std::string format_su2(const TriangleMesh& mesh) {
  const std::map<Marker, std::string> tags = tags_of(mesh);
  std::map<Marker, std::vector<MarkedEdge>> edges_of;
  for (const MarkedEdge& edge : mesh.boundary) edges_of[edge.marker].push_back(edge);

  std::string text = format_marker_notes(tags, '%');
  text.reserve(text.size() + 64 * mesh.vertex_count() + 40 * mesh.triangle_count());
  text += "NDIME= 2\nNELEM= " + std::to_string(mesh.triangle_count()) + "\n";
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& c = mesh.corners[t];
    append_line(text, {triangle_type, c[0].index(), c[1].index(), c[2].index(), t.index()});
  }
  text += "NPOIN= " + std::to_string(mesh.vertex_count()) + "\n";
  for (const VertexId v : mesh.points.ids()) {
    append_number(text, mesh.points[v].x);
    text += ' ';
    append_number(text, mesh.points[v].y);
    text += ' ';
    append_line(text, {v.index()});
  }
  text += "NMARK= " + std::to_string(edges_of.size()) + "\n";
  for (const auto& [marker, edges] : edges_of) {
    text += "MARKER_TAG= " + tags.at(marker) + "\nMARKER_ELEMS= " + std::to_string(edges.size()) + "\n";
    for (const MarkedEdge& edge : edges) append_line(text, {line_type, edge.from.index(), edge.to.index()});
  }
  return text;
}

void write_su2(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}

}  // namespace leonhard::io
