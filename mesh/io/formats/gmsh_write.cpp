// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/gmsh_write.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "leonhard/mesh/io/number_text.hpp"

namespace leonhard::io {

namespace {

/// Numbers as text, each with a blank after it, or as their bytes.
class GmshOutput {
 public:
  explicit GmshOutput(bool binary) : binary_(binary) {}

  void text(const std::string& line) { bytes_ += line; }
  void integer(std::int32_t number) { append(number); }
  void size(std::size_t number) { append(std::uint64_t{number}); }
  void real(double number) { append(number); }
  void end_line() {
    if (binary_) return;
    if (bytes_.back() == ' ') bytes_.pop_back();
    bytes_ += '\n';
  }
  /// $EndNAME, on a line of its own.
  void end_section(const std::string& name) { bytes_ += (binary_ ? "\n$End" : "$End") + name + "\n"; }

  [[nodiscard]] bool is_binary() const { return binary_; }
  [[nodiscard]] std::string finish() && { return std::move(bytes_); }

 private:
  template <class Number>
  void append(Number number) {
    if (binary_) {
      const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
      bytes_.append(raw.data(), raw.size());
    } else {
      append_number(bytes_, number);
      bytes_ += ' ';
    }
  }

  bool binary_;
  std::string bytes_;
};

/// The cells of one type, with what Gmsh calls them.
struct CellList {
  const std::vector<GmshCell>* cells;
  std::int32_t type;
  int dimension;
  std::size_t corner_count;
  Marker ungrouped = 1;  ///< number of the entity of cells in no group: one that no group has

  [[nodiscard]] Marker entity_of(const GmshCell& cell) const {
    return cell.group != 0 ? cell.group : ungrouped;
  }
};

/// Numbers of entities that no group of their dimension has.
void number_ungrouped(std::vector<CellList>& lists) {
  for (const int dimension : {1, 2, 3}) {
    std::set<Marker> groups;
    for (const CellList& list : lists)
      if (list.dimension == dimension)
        for (const GmshCell& cell : *list.cells) groups.insert(cell.group);
    Marker ungrouped = 1;
    while (groups.contains(ungrouped)) ++ungrouped;
    for (CellList& list : lists)
      if (list.dimension == dimension) list.ungrouped = ungrouped;
  }
}

std::vector<CellList> lists_of(const GmshData& data) {
  std::vector<CellList> lists;
  const auto add = [&](const std::vector<GmshCell>& cells, std::int32_t type, int dimension,
                       std::size_t corners) {
    if (!cells.empty()) lists.push_back({&cells, type, dimension, corners});
  };
  add(data.lines, 1, 1, 2);
  add(data.triangles, 2, 2, 3);
  add(data.quadrilaterals, 3, 2, 4);
  add(data.tetrahedra, 4, 3, 4);
  add(data.hexahedra, 5, 3, 8);
  add(data.prisms, 6, 3, 6);
  add(data.pyramids, 7, 3, 5);
  number_ungrouped(lists);
  return lists;
}

/// The number of a cell: its own, or one more than that of the cell before.
std::size_t number_of(const GmshCell& cell, std::size_t before) {
  return cell.tag != 0 ? cell.tag : before + 1;
}

std::size_t cell_count(const std::vector<CellList>& lists) {
  std::size_t count = 0;
  for (const CellList& list : lists) count += list.cells->size();
  return count;
}

void write_format(GmshOutput& out, const GmshForm& form) {
  out.text(std::string("$MeshFormat\n") + (form.version == GmshVersion::v2_2 ? "2.2" : "4.1") +
           (form.binary ? " 1 8\n" : " 0 8\n"));
  if (form.binary) out.integer(1);  // shows the byte order
  out.end_section("MeshFormat");
}

/// The section is there even if it is empty: it says that groups are what they are, see parse_gmsh_data.
void write_names(GmshOutput& out, const GmshData& data) {
  out.text("$PhysicalNames\n" + std::to_string(data.names.size()) + "\n");
  for (const auto& [group, name] : data.names)
    out.text(std::to_string(group.first) + " " + std::to_string(group.second) + " \"" + name + "\"\n");
  out.text("$EndPhysicalNames\n");
}

void write_coordinates(GmshOutput& out, const Point3& p) {
  for (const double x : {p.x, p.y, p.z}) out.real(x);
}

/// $NodeData or $ElementData, the same in both versions: rows of a 32-bit number and doubles.
void write_values(GmshOutput& out, const GmshValues& field) {
  const std::string section = field.of_nodes ? "NodeData" : "ElementData";
  out.text("$" + section + "\n1\n\"" + field.name + "\"\n1\n0\n3\n0\n" + std::to_string(field.components) +
           "\n" + std::to_string(field.rows.size()) + "\n");
  for (std::size_t i = 0; i < field.rows.size(); ++i) {
    out.integer(static_cast<std::int32_t>(field.rows[i] + (field.of_nodes ? 1 : 0)));
    for (std::size_t k = 0; k < field.components; ++k) out.real(field.values[i * field.components + k]);
    out.end_line();
  }
  out.end_section(section);
}

// ---- version 2.2 ----

void write_nodes(GmshOutput& out, const GmshData& data) {
  out.text("$Nodes\n" + std::to_string(data.points.size()) + "\n");
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    out.integer(static_cast<std::int32_t>(i + 1));
    write_coordinates(out, data.points[i]);
    out.end_line();
  }
  out.end_section("Nodes");
}

void write_elements(GmshOutput& out, const std::vector<CellList>& lists) {
  constexpr std::int32_t tags = 2;  // group and entity
  out.text("$Elements\n" + std::to_string(cell_count(lists)) + "\n");
  std::size_t number = 0;
  for (const CellList& list : lists) {
    if (out.is_binary())
      for (const std::int32_t entry : {list.type, static_cast<std::int32_t>(list.cells->size()), tags})
        out.integer(entry);
    for (const GmshCell& cell : *list.cells) {
      number = number_of(cell, number);
      out.integer(static_cast<std::int32_t>(number));
      if (!out.is_binary())
        for (const std::int32_t entry : {list.type, tags}) out.integer(entry);
      out.integer(cell.group);
      out.integer(list.entity_of(cell));
      for (std::size_t k = 0; k < list.corner_count; ++k)
        out.integer(static_cast<std::int32_t>(cell.corners[k].index() + 1));
      out.end_line();
    }
  }
  out.end_section("Elements");
}

// ---- version 4.1 ----

struct Box {
  Point3 low, high;
  void include(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// Entities of a list by number: which group, and the box about them.
struct Entity {
  Marker group;
  Box box;
};

void add_entities(const CellList& list, const std::vector<Point3>& points,
                  std::map<Marker, Entity>& entities) {
  for (const GmshCell& cell : *list.cells)
    for (std::size_t k = 0; k < list.corner_count; ++k) {
      const Point3& p = points[cell.corners[k].index()];
      entities.try_emplace(list.entity_of(cell), Entity{cell.group, {p, p}}).first->second.box.include(p);
    }
}

void write_entities(GmshOutput& out, const std::vector<CellList>& lists, const std::vector<Point3>& points) {
  std::array<std::map<Marker, Entity>, 4> entities;  // by dimension
  for (const CellList& list : lists)
    add_entities(list, points, entities[static_cast<std::size_t>(list.dimension)]);
  out.text("$Entities\n");
  for (const auto& of_dimension : entities) out.size(of_dimension.size());
  out.end_line();
  for (const auto& of_dimension : entities)
    for (const auto& [number, entity] : of_dimension) {
      out.integer(number);
      write_coordinates(out, entity.box.low);
      write_coordinates(out, entity.box.high);
      out.size(entity.group != 0 ? 1 : 0);
      if (entity.group != 0) out.integer(entity.group);
      out.size(0);  // the entities that bound it are not told
      out.end_line();
    }
  out.end_section("Entities");
}

/// All nodes in one block, as the inner nodes of the last list's first entity.
void write_node_block(GmshOutput& out, const std::vector<CellList>& lists,
                      const std::vector<Point3>& points) {
  const CellList& last = lists.back();
  out.text("$Nodes\n");
  for (const std::size_t entry : {std::size_t{1}, points.size(), std::size_t{1}, points.size()})
    out.size(entry);
  out.end_line();
  out.integer(last.dimension);
  out.integer(last.entity_of(last.cells->front()));
  out.integer(0);  // no parameters
  out.size(points.size());
  out.end_line();
  for (std::size_t i = 0; i < points.size(); ++i) {
    out.size(i + 1);
    out.end_line();
  }
  for (const Point3& p : points) {
    write_coordinates(out, p);
    out.end_line();
  }
  out.end_section("Nodes");
}

/// Where the run of cells of one entity ends that begins at `begin`. Runs, not whole entities, keep the cells' order.
std::size_t run_end(const CellList& list, std::size_t begin) {
  std::size_t end = begin;
  while (end < list.cells->size() &&
         list.entity_of((*list.cells)[end]) == list.entity_of((*list.cells)[begin]))
    ++end;
  return end;
}

void write_element_blocks(GmshOutput& out, const std::vector<CellList>& lists) {
  std::size_t blocks = 0;
  for (const CellList& list : lists)
    for (std::size_t begin = 0; begin < list.cells->size(); begin = run_end(list, begin)) ++blocks;
  const std::size_t total = cell_count(lists);
  out.text("$Elements\n");
  for (const std::size_t entry : {blocks, total, std::size_t{1}, total}) out.size(entry);
  out.end_line();
  std::size_t number = 0;
  for (const CellList& list : lists)
    for (std::size_t begin = 0, end = 0; begin < list.cells->size(); begin = end) {
      end = run_end(list, begin);
      out.integer(list.dimension);
      out.integer(list.entity_of((*list.cells)[begin]));
      out.integer(list.type);
      out.size(end - begin);
      out.end_line();
      for (std::size_t i = begin; i < end; ++i) {
        number = number_of((*list.cells)[i], number);
        out.size(number);
        for (std::size_t k = 0; k < list.corner_count; ++k) out.size((*list.cells)[i].corners[k].index() + 1);
        out.end_line();
      }
    }
  out.end_section("Elements");
}

}  // namespace

std::string format_gmsh_data(const GmshData& data, const GmshForm& form) {
  const std::vector<CellList> lists = lists_of(data);
  GmshOutput out(form.binary);
  write_format(out, form);
  write_names(out, data);
  if (form.version == GmshVersion::v2_2) {
    write_nodes(out, data);
    write_elements(out, lists);
  } else {
    write_entities(out, lists, data.points);
    write_node_block(out, lists, data.points);
    write_element_blocks(out, lists);
  }
  for (const GmshValues& field : data.values) write_values(out, field);
  return std::move(out).finish();
}

}  // namespace leonhard::io
