// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace leonhard::io {

/// The number that begins at `raw`, stored in this machine's byte order or, swapped, in the other.
template <class Number>
[[nodiscard]] Number number_at(const char* raw, bool swapped) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), raw, sizeof(Number));
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

/// Whether numbers stored in little-endian order must be swapped to be read here.
inline constexpr bool little_endian_is_foreign = std::endian::native != std::endian::little;

/// Walks over the bytes of a binary file; what TextScanner is for text. Nothing is copied, so the bytes must outlive
/// the reader.
class ByteReader {
 public:
  /// bytes    the whole file
  /// source   names it in errors
  /// offset   of the first byte to read
  /// swapped  its numbers have the other byte order than this machine's
  ByteReader(std::string_view bytes, std::string source, std::size_t offset, bool swapped);

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t bytes_left() const { return bytes_.size() - offset_; }
  [[nodiscard]] std::string where() const;  ///< "source, byte offset"
  [[nodiscard]] const std::string& source() const { return source_; }
  /// The bytes from an offset on.
  [[nodiscard]] std::string_view rest_from(std::size_t offset) const { return bytes_.substr(offset); }
  /// Goes on by so many bytes, which are there.
  void skip(std::size_t count) { offset_ += count; }
  void set_swapped(bool swapped) { swapped_ = swapped; }
  [[nodiscard]] bool swapped() const { return swapped_; }

  /// The next number. throws InputError "file ends where <expected> was expected"
  template <class Number>
  Number take(const char* expected) {
    need(1, sizeof(Number), expected);
    const Number number = number_at<Number>(bytes_.data() + offset_, swapped_);
    offset_ += sizeof(Number);
    return number;
  }

  /// The next line of text, without its line break. throws InputError at the end of the file
  std::string_view line(const char* expected);

  /// Goes to behind the next place where `text` stands. throws InputError if there is none
  void skip_past(std::string_view text);

  /// throws InputError unless `count` things of `bytes_each` bytes are left: before anything is allocated for them
  void need(std::uint64_t count, std::size_t bytes_each, const char* expected) const;

  /// throws InputError(where(), problem, remedy)
  [[noreturn]] void fail(std::string problem, std::string remedy = {}) const;

 private:
  std::string_view bytes_;
  std::string source_;
  std::size_t offset_;
  bool swapped_;
};

}  // namespace leonhard::io
