// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/gmsh_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/gmsh_elements.hpp"
#include "leonhard/mesh/io/formats/gmsh_groups.hpp"
#include "leonhard/mesh/io/formats/gmsh_numbers.hpp"

namespace leonhard::io {

namespace {

using namespace gmsh_elements;

enum class GmshVersionRead { v1, v2, v4_0, v4_1 };

constexpr std::uint64_t most_nodes = std::numeric_limits<IdRaw>::max() / 2;

/// Which id a node's tag has. Tags are any positive numbers, mostly 1, 2, 3, ...
class NodeTags {
 public:
  void reserve(std::size_t count) { tags_.reserve(count); }
  void add(std::uint64_t tag) {
    in_order_ = in_order_ && (tags_.empty() || tag == tags_.back().first + 1);
    tags_.emplace_back(tag, tags_.size());
  }
  /// returns a tag that comes twice, if there is one
  std::optional<std::uint64_t> finish() {
    if (in_order_) return std::nullopt;
    std::sort(tags_.begin(), tags_.end());
    const auto twice = std::adjacent_find(tags_.begin(), tags_.end(),
                                          [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice == tags_.end()) return std::nullopt;
    return twice->first;
  }
  [[nodiscard]] std::optional<VertexId> find(std::uint64_t tag) const {
    if (tags_.empty() || tag < tags_.front().first || tag > tags_.back().first) return std::nullopt;
    if (in_order_) return VertexId::from(tag - tags_.front().first);
    const auto found = std::lower_bound(tags_.begin(), tags_.end(), std::pair(tag, std::size_t{0}));
    if (found->first != tag) return std::nullopt;
    return VertexId::from(found->second);
  }

 private:
  std::vector<std::pair<std::uint64_t, std::size_t>> tags_;
  bool in_order_ = true;
};

class GmshParser {
 public:
  GmshParser(GmshNumbers& numbers, GmshVersionRead version, const std::string& source)
      : numbers_(numbers), version_(version), source_(source) {}

  GmshData parse() {
    for (std::string line(numbers_.text_line()); !line.empty(); line = numbers_.text_line()) {
      if (line.front() != '$')
        numbers_.fail("found " + in_quotes(line) + " where a section ($...) was expected");
      read_section(line.substr(1));
    }
    for (const char* section : {"Nodes", "Elements"})
      if (!sections_.contains(section))
        numbers_.fail(std::string("the file ends without a section $") + section, "it was cut short");
    if (of_higher_order_ > 0)
      data_.warnings.push_back(std::to_string(of_higher_order_) +
                               " elements are of higher order; they were read by their corners");
    std::move(groups_).finish(data_, !has_blocks());
    return std::move(data_);
  }

 private:
  [[nodiscard]] bool has_blocks() const {
    return version_ == GmshVersionRead::v4_0 || version_ == GmshVersionRead::v4_1;
  }

  /// What a section is called in version 2 and 4; "" if it is none of those that are read.
  [[nodiscard]] static std::string known_name(const std::string& name) {
    if (name == "NOD" || name == "ParametricNodes") return "Nodes";
    if (name == "ELM") return "Elements";
    static const std::set<std::string> known{"Nodes", "Elements", "Entities", "PartitionedEntities",
                                             "PhysicalNames"};
    return known.contains(name) ? name : "";
  }

  void read_section(const std::string& name) {
    const std::string known = known_name(name);
    if (!known.empty()) {
      if (!sections_.insert(known).second) numbers_.fail("the section $" + name + " comes a second time");
      if (known == "PhysicalNames") read_names();
      if (known == "Entities") read_entities(false);
      if (known == "PartitionedEntities") read_entities(true);
      if (known == "Nodes") has_blocks() ? read_node_blocks() : read_nodes(name == "ParametricNodes");
      if (known == "Elements") has_blocks() ? read_element_blocks() : read_elements();
      const std::string_view end = numbers_.text_line();
      const std::string expected = (version_ == GmshVersionRead::v1 ? "$END" : "$End") + name;
      if (end != expected)
        numbers_.fail(end.empty() ? "the file ends inside the section $" + name
                                  : "found " + in_quotes(end) + " where " + expected + " was expected",
                      "a count is wrong, or the file was cut short");
      return;
    }
    if (name == "NodeData" || name == "ElementData") return read_values(name);
    if (name != "Comments" && name != "GhostElements")
      data_.warnings.push_back(numbers_.where() + ": the section $" + name + " was passed over");
    numbers_.skip_past("$End" + name);
  }

  /// A line of text, whose numbers and words are read one by one.
  TextScanner line_scanner(const char* expected) {
    const std::string_view text = numbers_.text_line();
    if (text.empty())
      numbers_.fail(std::string("the file ends where ") + expected + " was expected", "it was cut short");
    TextScanner scan(text, source_, {.lines_before = std::max<std::size_t>(numbers_.line(), 1) - 1});
    scan.next_line();
    return scan;
  }

  std::size_t read_line_count(const char* expected) {
    TextScanner scan = line_scanner(expected);
    const std::int64_t count = scan.integer(expected);
    scan.expect_line_end(expected);
    if (count < 0) scan.fail("found " + std::to_string(count) + " where " + expected + " was expected");
    return static_cast<std::size_t>(count);
  }

  void read_names() {
    const std::size_t count = read_line_count("the number of names");
    for (std::size_t i = 0; i < count; ++i) {
      TextScanner scan = line_scanner("the name of a physical group");
      const std::int32_t dimension = scan.integer32("the dimension of a physical group");
      const Marker group = magnitude(scan.integer32("the number of a physical group"));
      std::string_view name = scan.rest();
      if (name.size() < 2 || name.front() != '"' || name.back() != '"')
        scan.fail("found " + in_quotes(name) + " where a name in quotation marks was expected");
      name = name.substr(1, name.size() - 2);
      if (std::any_of(name.begin(), name.end(),
                      [](char c) { return c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }))
        scan.fail("the name " + in_quotes(name) + " holds a control character or a quotation mark");
      if (!data_.names.emplace(std::pair(dimension, group), name).second)
        scan.fail("the physical group " + std::to_string(group) + " of dimension " +
                  std::to_string(dimension) + " gets a second name");
    }
  }

  /// Values by nodes or elements; text of one entry a line before them, in binary files too.
  void read_values(const std::string& section) {
    GmshValues result;
    result.of_nodes = section == "NodeData";
    if (!sections_.contains(result.of_nodes ? "Nodes" : "Elements"))
      numbers_.fail("the section $" + section + " comes before what it is about");
    const std::size_t strings = read_line_count("the number of string tags");
    for (std::size_t i = 0; i < strings; ++i) {
      TextScanner scan = line_scanner("a string tag");
      std::string_view text = scan.rest();
      if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        text = text.substr(1, text.size() - 2);
      if (i == 0) result.name = text;
    }
    const std::size_t reals = read_line_count("the number of real tags");
    for (std::size_t i = 0; i < reals; ++i) line_scanner("a real tag");
    const std::size_t integers = read_line_count("the number of integer tags");
    std::array<std::size_t, 3> tags{};  // time step, components, rows
    for (std::size_t i = 0; i < integers; ++i) {
      const std::size_t tag = read_line_count("an integer tag");
      if (i < tags.size()) tags[i] = tag;
    }
    constexpr std::size_t most_components = 1000;
    if (integers < tags.size() || tags[1] == 0 || tags[1] > most_components)
      numbers_.fail("the integer tags of $" + section + " state no number of components from 1 to " +
                    std::to_string(most_components) + " and no number of rows");
    result.components = tags[1];
    numbers_.need(tags[2], 1 + result.components, "rows of values");
    result.rows.reserve(tags[2]);
    result.values.reserve(tags[2] * result.components);
    for (std::size_t i = 0; i < tags[2]; ++i) {
      const std::int32_t tag = numbers_.integer("the number of a node or an element");
      const auto row = static_cast<std::uint64_t>(std::max(tag, 0));
      result.rows.push_back(result.of_nodes ? node(row).index() : row);
      for (std::size_t k = 0; k < result.components; ++k)
        result.values.push_back(numbers_.any_real("a value"));
    }
    const std::string_view end = numbers_.text_line();
    if (end != "$End" + section)
      numbers_.fail("found " + in_quotes(end) + " where $End" + section + " was expected",
                    "a count is wrong, or the file was cut short");
    data_.values.push_back(std::move(result));
  }

  Marker magnitude(std::int32_t group) const {
    if (group == std::numeric_limits<std::int32_t>::min())
      numbers_.fail("the number of a physical group is too large");
    return std::abs(group);
  }

  void read_entities(bool partitioned) {
    if (partitioned) read_partition_head();
    std::array<std::uint64_t, 4> counts{};
    for (std::uint64_t& count : counts) count = numbers_.size("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      const std::uint64_t count = counts[static_cast<std::size_t>(dimension)];
      numbers_.need(count, dimension == 0 ? 5 : 8, "entities");
      for (std::uint64_t i = 0; i < count; ++i) read_entity(dimension, partitioned);
    }
  }

  void read_partition_head() {
    numbers_.size("the number of partitions");
    const std::uint64_t ghosts = numbers_.size("the number of ghost entities");
    numbers_.need(ghosts, 2, "ghost entities");
    for (std::uint64_t i = 0; i < 2 * ghosts; ++i) numbers_.integer("a ghost entity or its partition");
  }

  /// What an entity is to the elements on it.
  struct GmshEntity {
    Marker group = 0;
    Marker number = 0;     ///< of the entity, or of the one that a partition cut it from
    bool is_seam = false;  ///< made by a partition, within an entity of higher dimension
  };

  void read_entity(int dimension, bool partitioned) {
    const std::int32_t tag = numbers_.integer("the number of an entity");
    GmshEntity entity;
    entity.number = magnitude(tag);
    if (partitioned) {
      const std::int32_t parent_dimension = numbers_.integer("the dimension of an entity's parent");
      entity.number = magnitude(numbers_.integer("the number of an entity's parent"));
      entity.is_seam = parent_dimension > dimension;
      const std::uint64_t partitions = numbers_.size("the number of partitions of an entity");
      numbers_.need(partitions, 1, "partitions");
      for (std::uint64_t i = 0; i < partitions; ++i) numbers_.integer("the number of a partition");
    }
    const bool is_place = dimension == 0 && version_ == GmshVersionRead::v4_1;
    for (int i = 0; i < (is_place ? 3 : 6); ++i) numbers_.real("a corner of the box about an entity");
    const std::uint64_t groups = numbers_.size("the number of physical groups of an entity");
    numbers_.need(groups, 1, "physical groups");
    std::vector<Marker> all;
    for (std::uint64_t i = 0; i < groups; ++i)
      all.push_back(magnitude(numbers_.integer("the number of a physical group")));
    if (!all.empty()) entity.group = all.front();
    for (std::size_t i = 1; dimension > 0 && !entity.is_seam && i < all.size(); ++i)
      groups_.note_several(dimension, all.front(), all[i]);
    entities_[{dimension, tag}] = entity;
    if (dimension == 0) return;
    const std::uint64_t bounding = numbers_.size("the number of entities that bound another");
    numbers_.need(bounding, 1, "bounding entities");
    for (std::uint64_t i = 0; i < bounding; ++i) numbers_.integer("the number of an entity");
  }

  // ---- nodes ----

  void add_point() {
    const double x = numbers_.real("the x coordinate of a node"),
                 y = numbers_.real("the y coordinate of a node");
    const Point3 p{x, y, numbers_.real("the z coordinate of a node")};
    if (!is_finite(p))
      numbers_.fail(
          "node " + std::to_string(data_.points.size()) + " (from 0) has a coordinate that is not finite",
          "NaN and infinities are bad input; find out what wrote them");
    data_.points.push_back(p);
  }

  void need_nodes(std::uint64_t count, std::size_t numbers_each) {
    numbers_.need(count, numbers_each, "nodes");
    if (count > most_nodes)
      numbers_.fail("there are " + std::to_string(count) + " nodes, more than ids can number");
    data_.points.reserve(data_.points.size() + count);
    tags_.reserve(data_.points.size() + count);
  }

  void check_tags() {
    if (const auto twice = tags_.finish())
      numbers_.fail("the node " + std::to_string(*twice) + " comes twice",
                    "give each node a number of its own");
  }

  void read_nodes(bool parametric) {
    const std::size_t count = read_line_count("the number of nodes");
    need_nodes(count, 4);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t tag = numbers_.integer("the number of a node");
      if (tag < 0) numbers_.fail("a node has the number " + std::to_string(tag));
      tags_.add(static_cast<std::uint64_t>(tag));
      add_point();
      if (!parametric) continue;
      const std::int32_t dimension = numbers_.integer("the dimension of a node's entity");
      numbers_.integer("the number of a node's entity");
      for (int k = 0; k < (dimension == 1 || dimension == 2 ? dimension : 0); ++k)
        numbers_.real("a parameter of a node");
    }
    check_tags();
  }

  /// Version 4.1 gives all tags of a block before the coordinates, 4.0 one by one, and in another order of the header.
  void read_node_blocks() {
    const bool is_old = version_ == GmshVersionRead::v4_0;
    const std::uint64_t blocks = numbers_.size("the number of blocks of nodes");
    const std::uint64_t total = numbers_.size("the number of nodes");
    if (!is_old) {
      numbers_.size("the least number of a node");
      numbers_.size("the largest number of a node");
    }
    numbers_.need(blocks, 4, "blocks");
    need_nodes(total, 4);
    for (std::uint64_t b = 0; b < blocks; ++b) {
      std::int32_t dimension = numbers_.integer("the dimension of an entity");
      if (is_old) {
        dimension = numbers_.integer("the dimension of an entity");
      } else {
        numbers_.integer("the number of an entity");
      }
      const std::int32_t parametric = numbers_.integer("whether nodes have parameters");
      if (dimension < 0 || dimension > 3 || (parametric != 0 && parametric != 1))
        numbers_.fail("the header of a block of nodes makes no sense (dimension " +
                      std::to_string(dimension) + ", parametric " + std::to_string(parametric) + ")");
      const std::uint64_t count = numbers_.size("the number of nodes of a block");
      if (count > total - data_.points.size())
        numbers_.fail("the blocks hold more nodes than the section declares");
      for (std::uint64_t i = 0; !is_old && i < count; ++i) tags_.add(numbers_.size("the number of a node"));
      for (std::uint64_t i = 0; i < count; ++i) {
        if (is_old) tags_.add(old_node());
        add_point();
        for (int k = 0; k < (parametric == 1 ? dimension : 0); ++k) numbers_.real("a parameter of a node");
      }
    }
    if (data_.points.size() != total)
      numbers_.fail("the section declares " + std::to_string(total) + " nodes, but its blocks hold " +
                    std::to_string(data_.points.size()));
    check_tags();
  }

  // ---- elements ----

  const ElementType& type_of(std::int32_t number) const {
    const auto found = std::find_if(element_types.begin(), element_types.end(),
                                    [&](const ElementType& type) { return type.number == number; });
    if (found == element_types.end())
      numbers_.fail(
          "the file has elements of type " + std::to_string(number),
          "lines, triangles, quadrilaterals, tetrahedra, hexahedra, prisms and pyramids can be read");
    return *found;
  }

  VertexId node(std::uint64_t tag) const {
    const auto id = tags_.find(tag);
    if (!id) numbers_.fail("an element names node " + std::to_string(tag) + ", which the file does not have");
    return *id;
  }

  void need_nodes_first() const {
    if (!sections_.contains("Nodes")) numbers_.fail("the section $Elements comes before $Nodes");
  }

  /// An element after its tags. next: reads the tag of a node
  template <class Next>
  void read_element(const ElementType& type, std::uint64_t element, const GmshEntity& entity,
                    const Next& next) {
    CellOnEntity result{{{}, entity.group, numbers_.line(), element}, entity.number};
    const bool is_taken = type.list != list_count && !entity.is_seam;
    const std::size_t corners = is_taken ? corners_in_list[type.list] : 0;
    for (std::size_t k = 0; k < type.nodes; ++k) {
      const std::uint64_t tag = next();
      if (k < corners) result.cell.corners[k] = node(tag);
    }
    if (!is_taken) return;
    if (type.nodes > corners) ++of_higher_order_;
    groups_.add(type.list, result);
  }

  std::uint64_t old_node() {
    const std::int32_t tag = numbers_.integer("a node of an element");
    if (tag < 0) numbers_.fail("an element names node " + std::to_string(tag));
    return static_cast<std::uint64_t>(tag);
  }

  void read_old_element(const ElementType& type, std::int32_t element, std::int32_t tags) {
    GmshEntity entity;
    for (std::int32_t i = 0; i < tags; ++i) {
      const std::int32_t tag = numbers_.integer("a tag of an element");
      if (i == 0) entity.group = magnitude(tag);
      if (i == 1) entity.number = magnitude(tag);
    }
    if (version_ == GmshVersionRead::v1 &&
        numbers_.integer("the number of nodes of an element") != static_cast<std::int32_t>(type.nodes))
      numbers_.fail("an element of type " + std::to_string(type.number) +
                    " has another number of nodes than " + std::to_string(type.nodes));
    read_element(type, static_cast<std::uint64_t>(std::max(element, 0)), entity, [&] { return old_node(); });
  }

  void check_tag_count(std::int32_t tags) const {
    if (tags < 0) numbers_.fail("an element has " + std::to_string(tags) + " tags");
    numbers_.need(static_cast<std::uint64_t>(tags), 1, "tags");
  }

  void read_elements() {
    need_nodes_first();
    const std::size_t count = read_line_count("the number of elements");
    if (numbers_.line() == 0) return read_old_blocks(count);
    numbers_.need(count, 4, "elements");
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t element = numbers_.integer("the number of an element");
      const ElementType& type = type_of(numbers_.integer("the type of an element"));
      const std::int32_t tags =
          version_ == GmshVersionRead::v1 ? 2 : numbers_.integer("the number of tags of an element");
      check_tag_count(tags);
      read_old_element(type, element, tags);
    }
  }

  /// Binary: elements of one type under one header.
  void read_old_blocks(std::size_t count) {
    for (std::size_t done = 0; done < count;) {
      const ElementType& type = type_of(numbers_.integer("the type of elements"));
      const std::int32_t many = numbers_.integer("the number of elements of a block");
      const std::int32_t tags = numbers_.integer("the number of tags of an element");
      check_tag_count(tags);
      if (many <= 0 || static_cast<std::uint64_t>(many) > count - done)
        numbers_.fail("a block of " + std::to_string(many) + " elements where " +
                      std::to_string(count - done) + " are left");
      numbers_.need(static_cast<std::uint64_t>(many), 1 + type.nodes + static_cast<std::size_t>(tags),
                    "elements");
      for (std::int32_t i = 0; i < many; ++i) {
        const std::int32_t element = numbers_.integer("the number of an element");
        read_old_element(type, element, tags);
      }
      done += static_cast<std::size_t>(many);
    }
  }

  void read_element_blocks() {
    need_nodes_first();
    const bool is_old = version_ == GmshVersionRead::v4_0;
    const std::uint64_t blocks = numbers_.size("the number of blocks of elements");
    const std::uint64_t total = numbers_.size("the number of elements");
    if (!is_old) {
      numbers_.size("the least number of an element");
      numbers_.size("the largest number of an element");
    }
    numbers_.need(blocks, 4, "blocks");
    std::uint64_t done = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      std::int32_t tag =
          numbers_.integer("the number of an entity");  // of 4.1 its dimension, of 4.0 then the dimension
      const std::int32_t second = numbers_.integer("the number of an entity");
      if (!is_old) tag = second;
      const ElementType& type = type_of(numbers_.integer("the type of elements"));
      const std::uint64_t count = numbers_.size("the number of elements of a block");
      numbers_.need(count, 1 + type.nodes, "elements");
      const GmshEntity entity = entity_of(type, tag);
      for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t element = is_old ? old_node() : numbers_.size("the number of an element");
        read_element(type, element, entity,
                     [&] { return is_old ? old_node() : numbers_.size("a node of an element"); });
      }
      done += count;
    }
    if (done != total)
      numbers_.fail("the section declares " + std::to_string(total) + " elements, but its blocks hold " +
                    std::to_string(done));
  }

  GmshEntity entity_of(const ElementType& type, std::int32_t tag) const {
    const int dimension = type.list == list_count ? 0 : dimension_of_list[type.list];
    if (const auto found = entities_.find({dimension, tag}); found != entities_.end()) return found->second;
    GmshEntity entity;
    entity.number = magnitude(tag);
    return entity;
  }

  GmshNumbers& numbers_;
  GmshVersionRead version_;
  const std::string& source_;
  GmshData data_;
  std::set<std::string> sections_;
  std::map<std::pair<int, std::int32_t>, GmshEntity> entities_;
  NodeTags tags_;
  GmshGroups groups_;
  std::size_t of_higher_order_ = 0;
};

/// What the section $MeshFormat says.
struct GmshFormat {
  GmshVersionRead version = GmshVersionRead::v4_1;
  bool is_binary = false, swapped = false;
  std::size_t bytes = 0;  ///< of the section: what follows begins there
};

/// A binary file shows its byte order by the integer 1.
bool is_swapped(std::string_view bytes, std::size_t offset, const std::string& source) {
  ByteReader reader(bytes, source, offset, false);
  const auto one = reader.take<std::int32_t>("the integer 1, which tells the byte order");
  if (one == 1) return false;
  if (number_at<std::int32_t>(bytes.data() + offset, true) == 1) return true;
  throw InputError(source, "the integer after the format is neither 1 nor a 1 in the other byte order",
                   "the file was damaged, perhaps by a transfer as text");
}

GmshFormat read_format(std::string_view bytes, const std::string& source) {
  const std::size_t start = bytes.find("$MeshFormat");
  const std::size_t line_begin = start == std::string_view::npos ? start : bytes.find('\n', start);
  const std::size_t line_end =
      line_begin == std::string_view::npos ? line_begin : bytes.find('\n', line_begin + 1);
  if (line_end == std::string_view::npos ||
      bytes.substr(0, start).find_first_not_of(" \t\r\n") != std::string_view::npos)
    throw InputError(source, "does not begin with $MeshFormat", "give a mesh of Gmsh, format 2.2 or 4.1");
  const auto lines_before = static_cast<std::size_t>(
      std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(line_begin), '\n'));
  TextScanner scan(bytes.substr(line_begin + 1, line_end - line_begin - 1), source,
                   {.lines_before = lines_before + 1});
  scan.need_line("the format");
  const double version = scan.number("the version of the format");
  const std::int64_t kind = scan.integer("0 for text or 1 for binary"),
                     size = scan.integer("the size of a number");
  GmshFormat format;
  if (version == 4) {
    format.version = GmshVersionRead::v4_0;
  } else if (version == 2.2 || version == 2.1 || version == 2) {
    format.version = GmshVersionRead::v2;
  } else if (version != 4.1) {
    scan.fail("the format has another version than 2.2, 4 and 4.1", "save it again (Gmsh: -format msh41)");
  }
  if ((kind != 0 && kind != 1) || size != 8)
    scan.fail("the line of the format makes no sense", "expected is \"4.1 0 8\"");
  format.is_binary = kind == 1;
  format.bytes = line_end + 1;
  if (format.is_binary) {
    format.swapped = is_swapped(bytes, format.bytes, source);
    format.bytes += sizeof(std::int32_t);
  }
  return format;
}

/// The scanner of a text stands before $EndMeshFormat here, and so does the one of binary data.
GmshData parse_body(GmshNumbers& numbers, const GmshFormat& format, const std::string& source) {
  const std::string_view end = numbers.text_line();
  if (end != "$EndMeshFormat") numbers.fail("found " + in_quotes(end) + " where $EndMeshFormat was expected");
  return GmshParser(numbers, format.version, source).parse();
}

/// Version 1 has no section of the format.
bool is_version_1(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && bytes.substr(begin).starts_with("$NOD");
}

}  // namespace

GmshData parse_gmsh_data(std::string_view bytes, const std::string& source) {
  if (is_version_1(bytes)) {
    GmshText numbers(bytes, source);
    return GmshParser(numbers, GmshVersionRead::v1, source).parse();
  }
  const GmshFormat format = read_format(bytes, source);
  if (format.is_binary) {
    GmshBytes numbers(bytes, source, format.bytes, format.swapped);
    return parse_body(numbers, format, source);
  }
  GmshText numbers(bytes, source);
  numbers.text_line();  // $MeshFormat
  numbers.text_line();  // the line just read
  return parse_body(numbers, format, source);
}

}  // namespace leonhard::io
