// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/text_scanner.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <system_error>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::io {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string reason(int error) { return std::generic_category().message(error); }

void refuse_what_is_no_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError(path.string(), "file does not exist",
                     "check the path, which is relative to the current folder");
  if (error) throw InputError(path.string(), "cannot read file: " + error.message(), "check its permissions");
  if (status.type() == std::filesystem::file_type::directory)
    throw InputError(path.string(), "is a folder, not a file", "name a file in it");
  if (status.type() != std::filesystem::file_type::regular)
    throw InputError(path.string(), "is a device or a pipe, not a file", "copy its contents to a file first");
}

}  // namespace

std::string read_whole_file(const std::filesystem::path& path) {
  refuse_what_is_no_file(path);
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw InputError(path.string(), "cannot read file: " + reason(errno), "check its permissions");
  std::error_code no_size;
  const std::uintmax_t expected = std::filesystem::file_size(path, no_size);
  std::string bytes(no_size ? 0 : static_cast<std::size_t>(expected) + 1, '\0');
  std::size_t used = 0;
  while (true) {  // until the end rather than the size: files in /proc claim to be empty
    if (used == bytes.size()) bytes.resize(2 * used + 4096);
    const std::size_t got = std::fread(bytes.data() + used, 1, bytes.size() - used, file.get());
    used += got;
    if (got == 0) break;
  }
  if (std::ferror(file.get())) throw InputError(path.string(), "cannot read file: " + reason(errno));
  bytes.resize(used);
  if (bytes.empty()) throw InputError(path.string(), "file is empty", "was it written completely?");
  return bytes;
}

NumberFault parse_number(std::string_view word, double& value) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return NumberFault::not_a_number;
  if (error == std::errc::result_out_of_range) {
    value = std::strtod(std::string(word).c_str(), nullptr);  // tells 1e999 from 1e-999, which rounds to 0
    return std::isfinite(value) ? NumberFault::none : NumberFault::too_large;
  }
  if (error != std::errc{}) return NumberFault::not_a_number;
  return std::isfinite(value) ? NumberFault::none : NumberFault::not_finite;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string shown = "\"";
  for (const char c : word.substr(0, longest)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    shown += control ? '?' : c;
  }
  return shown + (word.size() > longest ? "...\"" : "\"");
}

TextScanner::TextScanner(std::string_view text, std::string source, TextSyntax syntax)
    : text_(text), source_(std::move(source)), syntax_(syntax), line_(syntax.lines_before) {
  for (const char c : {' ', '\t', '\r', '\v', '\f'}) blank_[static_cast<unsigned char>(c)] = true;
  if (syntax_.extra_blank != '\0') blank_[static_cast<unsigned char>(syntax_.extra_blank)] = true;
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  const std::size_t zero = text_.find('\0');
  if (zero != std::string_view::npos) {
    const auto lines = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw InputError(at_line(source_, line_ + static_cast<std::size_t>(lines) + 1),
                     "found a zero byte where text was expected: this is a binary (or UTF-16) file",
                     "save it as plain text");
  }
}

bool TextScanner::take_line() {
  const std::size_t newline = text_.find('\n', next_);
  const std::size_t end = newline == std::string_view::npos ? text_.size() : newline;
  const std::string_view line = text_.substr(next_, end - next_);
  next_ = newline == std::string_view::npos ? end : newline + 1;
  ++line_;
  rest_ = syntax_.comment == '\0' ? line : line.substr(0, line.find(syntax_.comment));
  const bool has_comment = rest_.size() < line.size();
  trim();
  return has_comment;
}

bool TextScanner::next_line() {
  while (next_ < text_.size()) {
    take_line();
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  return false;
}

bool TextScanner::next_line_even_if_empty() {
  while (next_ < text_.size()) {
    const bool has_comment = take_line();
    if (!rest_.empty() || !has_comment) return true;
  }
  rest_ = {};
  return false;
}

void TextScanner::need_line(const char* expected) {
  if (!next_line())
    fail(std::string("file ends where ") + expected + " was expected",
         "the file was cut short, or a count is too large");
}

std::string TextScanner::where() const { return at_line(source_, std::max<std::size_t>(line_, 1)); }

std::size_t TextScanner::bytes_left() const { return rest_.size() + (text_.size() - next_); }

void TextScanner::trim() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  while (!rest_.empty() && is_blank(rest_.back())) rest_.remove_suffix(1);
}

bool TextScanner::at_key() const {
  if (rest_.empty()) return false;
  const char first = rest_.front();
  const bool letter = (first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z');
  return letter && rest_.find('=') != std::string_view::npos;
}

std::string_view TextScanner::key(const char* expected) {
  if (!at_key()) fail_found(rest_, expected);
  const std::size_t equals = rest_.find('=');
  std::string_view result = rest_.substr(0, equals);
  while (is_blank(result.back())) result.remove_suffix(1);  // ends at its first letter
  rest_.remove_prefix(equals + 1);
  trim();
  return result;
}

std::string_view TextScanner::word(const char* expected) {
  if (rest_.empty()) fail(std::string("line ends where ") + expected + " was expected");
  std::size_t length = 0;
  while (length < rest_.size() && !is_blank(rest_[length])) ++length;
  const std::string_view result = rest_.substr(0, length);
  while (length < rest_.size() && is_blank(rest_[length])) ++length;
  rest_.remove_prefix(length);
  return result;
}

double TextScanner::number(const char* expected) {
  const std::string_view found = word(expected);
  double value = 0;
  switch (parse_number(found, value)) {
    case NumberFault::none:
      return value;
    case NumberFault::not_a_number:
      fail_found(found, expected);
    case NumberFault::not_finite:
      fail(in_quotes(found) + " is not finite, where " + expected + " was expected",
           "NaN and infinities are bad input; find out what wrote them");
    case NumberFault::too_large:
      fail(in_quotes(found) + " is beyond the range of double, where " + expected + " was expected");
  }
  return value;
}

std::int64_t TextScanner::integer(const char* expected) {
  std::string_view found = word(expected);
  const std::string_view digits =
      found.size() > 1 && found.front() == '+' && found[1] != '-' ? found.substr(1) : found;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
    fail_found(found, expected);
  if (error != std::errc{}) fail(in_quotes(found) + " is too large, where " + expected + " was expected");
  return value;
}

std::int32_t TextScanner::integer32(const char* expected) {
  const std::int64_t value = integer(expected);
  if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
    fail(std::to_string(value) + " does not fit 32 bits, where " + expected + " was expected");
  return static_cast<std::int32_t>(value);
}

std::size_t TextScanner::count(const char* expected, std::size_t bytes_each) {
  const std::int64_t value = integer(expected);
  if (value < 0)
    fail("found " + std::to_string(value) + " where " + expected +
         " was expected: a count cannot be negative");
  // The last line may end without a line break, so one byte more than there is.
  if (static_cast<std::uint64_t>(value) > (bytes_left() + 1) / bytes_each)
    fail(std::string(expected) + " is " + std::to_string(value) + ", but the remaining " +
             std::to_string(bytes_left()) + " bytes of the file cannot hold so many",
         "correct the count, or the file was cut short");
  return static_cast<std::size_t>(value);
}

void TextScanner::expect_line_end(const char* after) {
  if (!rest_.empty()) fail("found " + in_quotes(rest_) + " where the line should end after " + after);
}

void TextScanner::fail_found(std::string_view found, const char* expected) const {
  fail("found " + in_quotes(found) + " where " + expected + " was expected");
}

void TextScanner::fail(std::string problem, std::string remedy) const {
  throw InputError(where(), std::move(problem), std::move(remedy));
}

}  // namespace leonhard::io
