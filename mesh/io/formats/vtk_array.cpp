// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/vtk_array.hpp"

#ifdef LEONHARD_HAS_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/text/byte_reader.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max();  ///< where the file alone says
constexpr std::string_view cut_short = "the file was cut short, or its sizes are wrong";

[[noreturn]] void fail(const XmlElement& array, const VtkEncoding& encoding, const std::string& problem,
                       std::string_view remedy = {}) {
  throw InputError(at_line(encoding.source, array.line),
                   "the array " + in_quotes(array.attribute("Name", array.name)) + " " + problem,
                   std::string(remedy));
}

// ---- bytes ----

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Hands out the bytes of an array in order, decoded from base64 or as they are. VTK pads base64 at the end
/// of a header and goes on; decoding four characters at a time passes over that.
class ByteStream {
 public:
  ByteStream(const XmlElement& array, const VtkEncoding& encoding, std::string_view text, bool base64)
      : array_(array), encoding_(encoding), text_(text), base64_(base64) {}

  std::string take(std::size_t count) {
    const std::size_t left = decoded_.size() + (base64_ ? text_.size() / 4 * 3 : text_.size());
    if (count > left)
      fail(array_, encoding_,
           "needs " + std::to_string(count) + " bytes more, but only " + std::to_string(left) + " are there",
           cut_short);
    if (!base64_) {
      const std::string bytes(text_.substr(0, count));
      text_.remove_prefix(count);
      return bytes;
    }
    decoded_.reserve(count + 3);
    while (decoded_.size() < count) decode_four();
    std::string bytes = decoded_.substr(0, count);
    decoded_.erase(0, count);
    return bytes;
  }

  /// A size of the header.
  std::uint64_t take_size() {
    std::string bytes = take(encoding_.header_bytes);
    if (encoding_.swapped) std::reverse(bytes.begin(), bytes.end());
    if (bytes.size() == 4) {
      std::uint32_t size = 0;
      std::memcpy(&size, bytes.data(), 4);
      return size;
    }
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), 8);
    return size;
  }

 private:
  void decode_four() {
    std::uint32_t bits = 0;
    int digits = 0, padding = 0;
    while (digits + padding < 4) {
      if (text_.empty()) fail(array_, encoding_, "ends inside its base64 data", cut_short);
      const char c = text_.front();
      text_.remove_prefix(1);
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
      if (c == '=' && digits >= 2) {
        ++padding;
        bits <<= 6;
        continue;
      }
      const int value = base64_value(c);
      if (value < 0 || padding > 0)
        fail(array_, encoding_, "holds a character that is no base64: " + in_quotes({&c, 1}));
      bits = bits << 6 | static_cast<std::uint32_t>(value);
      ++digits;
    }
    for (int i = 0; i < 3 - padding; ++i) decoded_ += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
  }

  const XmlElement& array_;
  const VtkEncoding& encoding_;
  std::string_view text_;
  bool base64_;
  std::string decoded_;
};

/// Blocks of one size, the last one possibly smaller, each compressed for itself.
std::string take_compressed(ByteStream& stream, const XmlElement& array, const VtkEncoding& encoding,
                            std::uint64_t expected_bytes) {
  const std::uint64_t blocks = stream.take_size(), block_size = stream.take_size(),
                      partial = stream.take_size();
  if (blocks > 0 && (block_size > std::numeric_limits<std::uint64_t>::max() / blocks || partial > block_size))
    fail(array, encoding, "has block sizes that contradict each other");
  const std::uint64_t total =
      blocks == 0 ? 0 : (blocks - 1) * block_size + (partial == 0 ? block_size : partial);
  if (expected_bytes != any_size && total != expected_bytes)
    fail(
        array, encoding,
        "holds " + std::to_string(total) + " bytes, but " + std::to_string(expected_bytes) + " are expected");
  std::vector<std::uint64_t> sizes;
  std::uint64_t compressed = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {  // a block count too large runs out of bytes here
    sizes.push_back(stream.take_size());
    compressed += std::min<std::uint64_t>(sizes.back(), std::numeric_limits<std::uint32_t>::max());
  }
  if (total / best_ratio(encoding.compressor) > compressed)
    fail(array, encoding, "cannot be as large as it says it is", cut_short);
  std::string bytes(total, '\0');
  std::uint64_t done = 0;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::string block = stream.take(sizes[b]);
    const std::uint64_t size = b + 1 == blocks && partial != 0 ? partial : block_size;
    if (!unpack(encoding.compressor, block, std::span(bytes).subspan(done, size)))
      fail(array, encoding, "holds a compressed block that cannot be unpacked");
    done += size;
  }
  return bytes;
}

std::string take_plain(ByteStream& stream, const XmlElement& array, const VtkEncoding& encoding,
                       std::uint64_t expected_bytes) {
  const std::uint64_t total = stream.take_size();
  if (expected_bytes != any_size && total != expected_bytes)
    fail(
        array, encoding,
        "holds " + std::to_string(total) + " bytes, but " + std::to_string(expected_bytes) + " are expected");
  return stream.take(total);
}

std::size_t appended_offset(const XmlElement& array, const VtkEncoding& encoding) {
  TextScanner scan(array.attributes.at("offset"), encoding.source, {.lines_before = array.line - 1});
  scan.need_line("the offset of an array");
  const std::int64_t offset = scan.integer("the offset of an array");
  if (offset < 0 || static_cast<std::uint64_t>(offset) > encoding.appended.size())
    fail(array, encoding,
         "begins " + std::to_string(offset) + " bytes into appended data of " +
             std::to_string(encoding.appended.size()) + " bytes",
         cut_short);
  return static_cast<std::size_t>(offset);
}

/// The bytes of a binary or appended array, unpacked.
std::string array_bytes(const XmlElement& array, const VtkEncoding& encoding, std::uint64_t expected_bytes) {
  const bool appended = array.attribute("format") == "appended";
  if (appended && !array.attributes.contains("offset"))
    fail(array, encoding, "is appended but has no offset");
  const std::string_view text =
      appended ? encoding.appended.substr(appended_offset(array, encoding)) : std::string_view(array.text);
  ByteStream stream(array, encoding, text, !appended || encoding.appended_is_base64);
  if (encoding.compressor != VtkCompressor::none)
    return take_compressed(stream, array, encoding, expected_bytes);
  return take_plain(stream, array, encoding, expected_bytes);
}

// ---- numbers ----

/// One of VTK's number types: its size, and how to append numbers of it to a vector.
template <class Wanted>
struct NumberType {
  std::string_view name;
  std::size_t size;
  void (*convert)(const std::string& bytes, bool swapped, std::vector<Wanted>& numbers);
};

template <class Stored, class Wanted>
void convert(const std::string& bytes, bool swapped, std::vector<Wanted>& numbers) {
  for (std::size_t i = 0; i + sizeof(Stored) <= bytes.size(); i += sizeof(Stored))
    numbers.push_back(static_cast<Wanted>(number_at<Stored>(bytes.data() + i, swapped)));
}

template <class Stored, class Wanted>
constexpr NumberType<Wanted> number_type(std::string_view name) {
  return {name, sizeof(Stored), &convert<Stored, Wanted>};
}

template <class Wanted>
const NumberType<Wanted>& type_of(const XmlElement& array, const VtkEncoding& encoding) {
  static constexpr std::array<NumberType<Wanted>, 10> types{
      number_type<std::int8_t, Wanted>("Int8"),   number_type<std::uint8_t, Wanted>("UInt8"),
      number_type<std::int16_t, Wanted>("Int16"), number_type<std::uint16_t, Wanted>("UInt16"),
      number_type<std::int32_t, Wanted>("Int32"), number_type<std::uint32_t, Wanted>("UInt32"),
      number_type<std::int64_t, Wanted>("Int64"), number_type<std::uint64_t, Wanted>("UInt64"),
      number_type<float, Wanted>("Float32"),      number_type<double, Wanted>("Float64")};
  const std::string name = array.attribute("type");
  const auto found =
      std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.name == name; });
  if (found == types.end())
    fail(array, encoding, "has the type " + in_quotes(name) + ", which is no number type");
  if (std::is_integral_v<Wanted> && name.starts_with("Float"))
    fail(array, encoding, "has the type " + in_quotes(name) + " where integers are expected");
  return *found;
}

template <class Wanted>
std::vector<Wanted> read_ascii(const XmlElement& array, const VtkEncoding& encoding,
                               std::optional<std::size_t> count, bool any_double) {
  std::vector<Wanted> numbers;
  TextScanner scan(array.text, encoding.source, {.lines_before = array.text_line - 1});
  while (scan.next_line())
    while (!scan.line_done()) {
      if constexpr (std::is_integral_v<Wanted>) {
        numbers.push_back(scan.integer("a whole number"));
      } else if (any_double) {
        const std::string_view word = scan.word("a number");
        const NumberFault fault = parse_number(word, numbers.emplace_back());
        if (fault != NumberFault::none && fault != NumberFault::not_finite) scan.fail_found(word, "a number");
      } else {
        numbers.push_back(scan.number("a number"));
      }
    }
  if (count && numbers.size() != *count)
    fail(array, encoding,
         "holds " + std::to_string(numbers.size()) + " numbers, but " + std::to_string(*count) +
             " are expected",
         cut_short);
  return numbers;
}

template <class Wanted>
std::vector<Wanted> read_numbers(const XmlElement& array, const VtkEncoding& encoding,
                                 std::optional<std::size_t> count, bool any_double = false) {
  const NumberType<Wanted>& type = type_of<Wanted>(array, encoding);
  const std::string format = array.attribute("format", "ascii");
  if (format == "ascii") return read_ascii<Wanted>(array, encoding, count, any_double);
  if (format != "binary" && format != "appended")
    fail(array, encoding, "has the unknown format " + in_quotes(format));
  if (count && *count > std::numeric_limits<std::size_t>::max() / type.size)
    fail(array, encoding, "is too large");
  const std::string bytes = array_bytes(array, encoding, count ? *count * type.size : any_size);
  std::vector<Wanted> numbers;
  numbers.reserve(bytes.size() / type.size);
  type.convert(bytes, encoding.swapped, numbers);
  return numbers;
}

/// A size of the header that append_vtk_bytes writes.
void append_size(std::string& bytes, std::uint64_t size) {
  const auto raw = std::bit_cast<std::array<char, 8>>(size);
  bytes.append(raw.data(), raw.size());
}

}  // namespace

VtkEncoding vtk_encoding(const XmlElement& root, const std::string& source) {
  VtkEncoding encoding;
  encoding.source = source;
  const std::string where = at_line(source, root.line);
  const bool file_is_little = root.attribute("byte_order", "LittleEndian") == "LittleEndian";
  encoding.swapped = file_is_little != (std::endian::native == std::endian::little);
  const std::string header_type = root.attribute("header_type", "UInt32");
  if (header_type != "UInt32" && header_type != "UInt64")
    throw InputError(where, "unknown header_type " + in_quotes(header_type), "known are UInt32 and UInt64");
  encoding.header_bytes = header_type == "UInt64" ? 8 : 4;
  const std::string compressor = root.attribute("compressor");
  const auto known = vtk_compressor_named(compressor);
  if (!known)
    throw InputError(where, "the file is compressed with " + in_quotes(compressor),
                     "write it with zlib or uncompressed");
  encoding.compressor = *known;
  if (*known != VtkCompressor::none && !can_unpack(*known))
    throw InputError(where,
                     std::string("the file is compressed with ") + name_of(*known) +
                         ", and this Leonhard was built without it",
                     "write it uncompressed, or build with LEONHARD_COMPRESSION=ON and the library");
  if (const XmlElement* appended = root.child("AppendedData")) {
    encoding.appended_is_base64 = appended->attribute("encoding", "raw") == "base64";
    const std::size_t underscore = appended->text.find('_');
    if (underscore == std::string_view::npos)
      throw InputError(at_line(source, appended->line),
                       "the appended data does not begin with an underscore");
    encoding.appended = appended->text.substr(underscore + 1);
  }
  return encoding;
}

std::vector<double> read_doubles(const XmlElement& array, const VtkEncoding& encoding,
                                 std::optional<std::size_t> count) {
  return read_numbers<double>(array, encoding, count);
}
std::vector<double> read_field_values(const XmlElement& array, const VtkEncoding& encoding,
                                      std::size_t count) {
  return read_numbers<double>(array, encoding, count, true);
}

std::vector<std::int64_t> read_integers(const XmlElement& array, const VtkEncoding& encoding,
                                        std::optional<std::size_t> count) {
  return read_numbers<std::int64_t>(array, encoding, count);
}

#ifdef LEONHARD_HAS_ZLIB

std::string_view vtk_compressor() { return "vtkZLibDataCompressor"; }

void append_vtk_bytes(std::string& appended, std::string_view bytes) {
  constexpr std::size_t block_size = std::size_t{1} << 18;
  constexpr int level = 3;  // near the size of the default level in a third of its time
  const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
  append_size(appended, blocks);
  append_size(appended, block_size);
  append_size(appended, bytes.size() % block_size);
  std::string packed;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::string_view block = bytes.substr(b * block_size, block_size);
    const std::size_t used = packed.size();
    uLongf size = ::compressBound(block.size());
    packed.resize(used + size);
    // Fails only for lack of memory or room; the room is compressBound's.
    if (::compress2(reinterpret_cast<Bytef*>(packed.data() + used), &size,
                    reinterpret_cast<const Bytef*>(block.data()), block.size(), level) != Z_OK)
      throw std::bad_alloc();
    packed.resize(used + size);
    append_size(appended, size);
  }
  appended += packed;
}

#else

std::string_view vtk_compressor() { return {}; }

void append_vtk_bytes(std::string& appended, std::string_view bytes) {
  append_size(appended, bytes.size());
  appended += bytes;
}

#endif

}  // namespace leonhard::io
