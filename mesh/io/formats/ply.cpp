// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/text/byte_reader.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type{};
  std::optional<PlyType> count_type;  ///< of a list's length; none for a single number
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
  std::optional<PlyFormat> format;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  ///< of the header
  std::size_t bytes = 0;  ///< of the header: the body begins there
};

PlyType read_type(TextScanner& scan) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> types{
      {{"char", PlyType::int8},
       {"int8", PlyType::int8},
       {"uchar", PlyType::uint8},
       {"uint8", PlyType::uint8},
       {"short", PlyType::int16},
       {"int16", PlyType::int16},
       {"ushort", PlyType::uint16},
       {"uint16", PlyType::uint16},
       {"int", PlyType::int32},
       {"int32", PlyType::int32},
       {"uint", PlyType::uint32},
       {"uint32", PlyType::uint32},
       {"float", PlyType::float32},
       {"float32", PlyType::float32},
       {"double", PlyType::float64},
       {"float64", PlyType::float64}}};
  const std::string_view word = scan.word("the type of a property");
  for (const auto& [name, type] : types)
    if (word == name) return type;
  scan.fail_found(word, "the type of a property (char, uchar, short, ushort, int, uint, float, double)");
}

PlyProperty read_property(TextScanner& scan) {
  PlyProperty property;
  if (scan.rest().starts_with("list ")) {
    scan.word("list");
    property.count_type = read_type(scan);
  }
  property.type = read_type(scan);
  property.name = scan.word("the name of a property");
  scan.expect_line_end("the property");
  return property;
}

PlyFormat read_format(TextScanner& scan) {
  const std::string_view word = scan.word("the format");
  const std::string_view version = scan.word("the version of the format");
  if (version != "1.0") scan.fail("the format has the version " + in_quotes(version), "1.0 can be read");
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::binary_little_endian;
  if (word == "binary_big_endian") return PlyFormat::binary_big_endian;
  scan.fail_found(word, "ascii, binary_little_endian or binary_big_endian");
}

/// Where the body begins: behind the line that reads end_header.
std::size_t body_offset(std::string_view bytes, const std::string& source) {
  constexpr std::string_view last = "end_header";
  const std::size_t found = bytes.find(last);
  const std::size_t newline = found == std::string_view::npos ? found : bytes.find('\n', found);
  if (!bytes.starts_with("ply") || newline == std::string_view::npos)
    throw InputError(source, "this is no PLY file: it has no header from ply to end_header",
                     "was it written completely?");
  return newline + 1;
}

PlyHeader read_header(std::string_view bytes, const std::string& source) {
  PlyHeader header;
  header.bytes = body_offset(bytes, source);
  TextScanner scan(bytes.substr(0, header.bytes), source, {});
  scan.need_line("ply");
  while (scan.next_line()) {
    const std::string_view keyword = scan.word("a keyword");
    if (keyword == "end_header") break;
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      header.format = read_format(scan);
    } else if (keyword == "element") {
      const std::string name(scan.word("the name of an element"));
      const std::int64_t count = scan.integer("the number of elements");
      if (count < 0) scan.fail("the number of elements is " + std::to_string(count));
      header.elements.push_back({name, static_cast<std::size_t>(count), {}});
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(scan));
    } else {
      scan.fail_found(keyword, "format, element, property or end_header");
    }
  }
  header.lines = scan.line();
  if (!header.format) scan.fail("the header has no line format");
  return header;
}

/// The numbers of the body, one after another.
class PlyNumbers {
 public:
  virtual ~PlyNumbers() = default;
  virtual double next(PlyType type, bool needed) = 0;  ///< needed: NaN and infinities are refused
  [[noreturn]] virtual void fail(std::string problem) const = 0;
  [[nodiscard]] virtual std::size_t bytes_left() const = 0;
  [[nodiscard]] virtual std::size_t line() const = 0;  ///< 0: the file has no lines
};

class PlyText final : public PlyNumbers {
 public:
  PlyText(std::string_view bytes, const std::string& source, const PlyHeader& header)
      : scan_(bytes.substr(header.bytes), source, {.lines_before = header.lines}) {}
  double next(PlyType, bool needed) override {
    scan_.need_word("a property");
    if (needed) return scan_.number("a property");
    scan_.word("a property");
    return 0;
  }
  void fail(std::string problem) const override { scan_.fail(std::move(problem)); }
  std::size_t bytes_left() const override { return scan_.bytes_left(); }
  std::size_t line() const override { return scan_.line(); }

 private:
  TextScanner scan_;
};

class PlyBytes final : public PlyNumbers {
 public:
  PlyBytes(std::string_view bytes, const std::string& source, const PlyHeader& header)
      : reader_(bytes, source, header.bytes,
                (*header.format == PlyFormat::binary_little_endian) == little_endian_is_foreign) {}
  double next(PlyType type, bool) override {
    switch (type) {
      case PlyType::int8:
        return reader_.take<std::int8_t>("a property");
      case PlyType::uint8:
        return reader_.take<std::uint8_t>("a property");
      case PlyType::int16:
        return reader_.take<std::int16_t>("a property");
      case PlyType::uint16:
        return reader_.take<std::uint16_t>("a property");
      case PlyType::int32:
        return reader_.take<std::int32_t>("a property");
      case PlyType::uint32:
        return reader_.take<std::uint32_t>("a property");
      case PlyType::float32:
        return static_cast<double>(reader_.take<float>("a property"));
      case PlyType::float64:
        break;
    }
    return reader_.take<double>("a property");
  }
  void fail(std::string problem) const override { reader_.fail(std::move(problem)); }
  std::size_t bytes_left() const override { return reader_.bytes_left(); }
  std::size_t line() const override { return 0; }

 private:
  ByteReader reader_;
};

class PlyBody {
 public:
  PlyBody(PlyNumbers& numbers, SurfaceBuilder& surface) : numbers_(numbers), surface_(surface) {}

  void read(const PlyElement& element) {
    if (element.count > numbers_.bytes_left() || (element.count > 0 && element.properties.empty()))
      numbers_.fail("the file cannot hold " + std::to_string(element.count) + " elements " +
                    in_quotes(element.name));
    if (element.name == "vertex") check_vertex(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      Point3 place{};
      for (const PlyProperty& property : element.properties) {
        if (element.name == "vertex") {
          read_of_vertex(property, place);
        } else {
          const bool corners = element.name == "face" &&
                               (property.name == "vertex_indices" || property.name == "vertex_index");
          read_list(property, corners);
        }
      }
      if (element.name == "vertex") surface_.add_point(place);
    }
  }

 private:
  static double* axis_of(const PlyProperty& property, Point3& place) {
    return property.name == "x"   ? &place.x
           : property.name == "y" ? &place.y
           : property.name == "z" ? &place.z
                                  : nullptr;
  }

  void check_vertex(const PlyElement& element) const {
    int found = 0;
    Point3 place;
    for (const PlyProperty& property : element.properties)
      if (!property.count_type && axis_of(property, place) != nullptr) ++found;
    if (found != 3) numbers_.fail("the element vertex needs the properties x, y and z, once each");
  }

  void read_of_vertex(const PlyProperty& property, Point3& place) {
    double* axis = axis_of(property, place);
    if (property.count_type || axis == nullptr) return read_list(property, false);
    *axis = numbers_.next(property.type, true);
  }

  std::int64_t whole(double number) const {
    if (number != std::floor(number) || std::abs(number) > 9e15)
      numbers_.fail("found " + std::to_string(number) + " where a whole number was expected");
    return static_cast<std::int64_t>(number);
  }

  /// A list, or a single number as a list of one.
  void read_list(const PlyProperty& property, bool corners) {
    const std::int64_t count = property.count_type ? whole(numbers_.next(*property.count_type, true)) : 1;
    if (count < 0 || static_cast<std::uint64_t>(count) > numbers_.bytes_left() + 1)
      numbers_.fail("the file cannot hold a list of " + std::to_string(count) + " numbers");
    for (std::int64_t i = 0; i < count; ++i) {
      const double number = numbers_.next(property.type, corners);
      if (corners) surface_.add_corner(whole(number));
    }
    if (corners) surface_.end_polygon(numbers_.line());
  }

  PlyNumbers& numbers_;
  SurfaceBuilder& surface_;
};

SurfaceFile read_body(const PlyHeader& header, PlyNumbers& numbers, const std::string& source) {
  SurfaceBuilder surface(source, 0);
  PlyBody body(numbers, surface);
  for (const PlyElement& element : header.elements) body.read(element);
  return std::move(surface).finish();
}

}  // namespace

SurfaceFile parse_ply(std::string_view bytes, const std::string& source) {
  const PlyHeader header = read_header(bytes, source);
  if (*header.format == PlyFormat::ascii) {
    PlyText text(bytes, source, header);
    return read_body(header, text, source);
  }
  PlyBytes binary(bytes, source, header);
  return read_body(header, binary, source);
}

}  // namespace leonhard::io
