// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace leonhard::io {

/// The bytes of a whole file.
/// throws InputError if the file is missing, not readable, a folder or a device, or empty
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path);

/// How a text format separates its words.
struct TextSyntax {
  char comment = '\0';           ///< the rest of the line after it is skipped; '\0': no comments
  char extra_blank = '\0';       ///< counts as a blank besides space, tab and carriage return
  std::size_t lines_before = 0;  ///< of the file before the text, where that is only a part of it
};

/// Walks over the lines and words of a text in memory; every reader of text stands on it.
///
/// A word that is not what the format wants throws InputError with file, line, what was found and what was
/// expected. NaN, infinities and numbers beyond double are refused. Nothing is copied, so the text must
/// outlive the scanner.
class TextScanner {
 public:
  /// text    a file's bytes; a UTF-8 byte order mark is skipped
  /// source  names the text in errors
  /// throws InputError if the text holds a zero byte (a binary file)
  TextScanner(std::string_view text, std::string source, TextSyntax syntax);

  /// Go to the next line that holds more than blanks and a comment. false at the end of the text, where
  /// line() stays on the last line.
  bool next_line();

  /// Go to the next line, be it empty: a line of blanks counts, one that holds a comment alone does not. For formats in
  /// which an empty line means something. false at the end of the text.
  bool next_line_even_if_empty();

  /// As next_line, but throws the error of a file cut short: "file ends where <expected> was expected".
  void need_line(const char* expected);

  [[nodiscard]] std::size_t line() const { return line_; }  ///< number of the current line, from 1
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] std::string where() const;  ///< "source:line"
  [[nodiscard]] std::string_view rest() const {
    return rest_;
  }  ///< what is not yet read of the line, without blanks at its ends
  [[nodiscard]] bool line_done() const { return rest_.empty(); }
  [[nodiscard]] std::size_t bytes_left() const;  ///< of the text, after the current word

  /// Whether the line reads KEY=...: begins with a letter and holds an equals sign.
  [[nodiscard]] bool at_key() const;
  /// KEY of a line that reads KEY=..., without blanks; the rest of the line is what follows the equals sign.
  /// throws InputError if at_key() is false
  std::string_view key(const char* expected);

  /// The next word of the line. throws InputError if the line has no more
  std::string_view word(const char* expected);
  /// The next word as a finite number.
  double number(const char* expected);
  /// The next word as a whole number.
  std::int64_t integer(const char* expected);
  /// The next word as a whole number that fits 32 bits.
  std::int32_t integer32(const char* expected);
  /// The next word as a number of things still to come, each of which takes at least bytes_each bytes of the
  /// file: a count that the rest of the file cannot hold is refused before anything is allocated for it.
  std::size_t count(const char* expected, std::size_t bytes_each);
  /// throws InputError if the line holds another word
  void expect_line_end(const char* after);

  /// throws InputError(where(), "found `found` where <expected> was expected")
  [[noreturn]] void fail_found(std::string_view found, const char* expected) const;
  /// throws InputError(where(), problem, remedy)
  [[noreturn]] void fail(std::string problem, std::string remedy = {}) const;

 private:
  [[nodiscard]] bool is_blank(char c) const { return blank_[static_cast<unsigned char>(c)]; }
  void trim();
  /// Take the next line, blanks and comment off; returns whether there was a comment.
  bool take_line();

  std::string_view text_;
  std::string source_;
  TextSyntax syntax_;
  std::array<bool, 256> blank_{};  ///< by character
  std::size_t next_ = 0;           ///< offset of the line after the current one
  std::size_t line_ = 0;
  std::string_view rest_;
};

/// How a number is read anywhere: the whole word, decimal or exponent form, a leading + allowed, finite.
enum class NumberFault { none, not_a_number, not_finite, too_large };
/// value is set if the answer is none.
NumberFault parse_number(std::string_view word, double& value);

/// A word as it is quoted in messages: in quotation marks, unprintable bytes as ?, long words shortened.
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace leonhard::io
