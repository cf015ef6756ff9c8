// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/text/byte_reader.hpp"

#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::io {

ByteReader::ByteReader(std::string_view bytes, std::string source, std::size_t offset, bool swapped)
    : bytes_(bytes), source_(std::move(source)), offset_(std::min(offset, bytes.size())), swapped_(swapped) {}

std::string ByteReader::where() const { return source_ + ", byte " + std::to_string(offset_); }

std::string_view ByteReader::line(const char* expected) {
  need(1, 1, expected);
  const std::size_t newline = std::min(bytes_.find('\n', offset_), bytes_.size());
  std::string_view text = bytes_.substr(offset_, newline - offset_);
  offset_ = std::min(newline + 1, bytes_.size());
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

void ByteReader::skip_past(std::string_view text) {
  const std::size_t found = bytes_.find(text, offset_);
  if (found == std::string_view::npos)
    fail("the file ends where " + std::string(text) + " was expected", "it was cut short");
  offset_ = found + text.size();
}

void ByteReader::need(std::uint64_t count, std::size_t bytes_each, const char* expected) const {
  if (count <= bytes_left() / bytes_each) return;
  if (count == 1) fail(std::string("file ends where ") + expected + " was expected", "it was cut short");
  fail(std::to_string(count) + " " + expected + " take at least " + std::to_string(bytes_each) +
           " bytes each, but only " + std::to_string(bytes_left()) + " bytes are left",
       "the file was cut short, or its counts are wrong");
}

void ByteReader::fail(std::string problem, std::string remedy) const {
  throw InputError(where(), std::move(problem), std::move(remedy));
}

}  // namespace leonhard::io
