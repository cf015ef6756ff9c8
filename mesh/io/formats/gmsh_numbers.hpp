// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/text/byte_reader.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

/// The numbers of a Gmsh file one after another, from text or from binary data between lines of text.
class GmshNumbers {
 public:
  virtual ~GmshNumbers() = default;

  /// The next line of text that is not empty, without blanks at its ends; "" at the end of the file.
  virtual std::string_view text_line() = 0;
  virtual std::int32_t integer(const char* expected) = 0;  ///< 4 bytes in binary
  virtual std::uint64_t size(const char* expected) = 0;    ///< 8 bytes in binary
  virtual double real(const char* expected) = 0;
  virtual double any_real(const char* expected) = 0;  ///< NaN and infinities too
  /// throws InputError unless the file can hold so many more things; each takes so many numbers
  virtual void need(std::uint64_t count, std::size_t numbers_each, const char* expected) = 0;
  virtual void skip_past(std::string_view line) = 0;     ///< to behind a line of text
  [[nodiscard]] virtual std::uint32_t line() const = 0;  ///< of the file; 0 in a binary one
  [[nodiscard]] virtual std::string where() const = 0;
  [[noreturn]] virtual void fail(std::string problem, std::string remedy = {}) const = 0;
};

class GmshText final : public GmshNumbers {
 public:
  GmshText(std::string_view text, const std::string& source) : scan_(text, source, {}) {}

  std::string_view text_line() override {
    scan_.expect_line_end("the numbers of the section");
    line_ = scan_.next_line() ? scan_.rest() : std::string_view{};
    while (!scan_.line_done()) scan_.word("a word");
    return line_;
  }
  std::int32_t integer(const char* expected) override {
    scan_.need_word(expected);
    return scan_.integer32(expected);
  }
  std::uint64_t size(const char* expected) override {
    scan_.need_word(expected);
    const std::int64_t value = scan_.integer(expected);
    if (value < 0) scan_.fail("found " + std::to_string(value) + " where " + expected + " was expected");
    return static_cast<std::uint64_t>(value);
  }
  double real(const char* expected) override {
    scan_.need_word(expected);
    return scan_.number(expected);
  }
  double any_real(const char* expected) override {
    scan_.need_word(expected);
    const std::string_view word = scan_.word(expected);
    double value = 0;
    const NumberFault fault = parse_number(word, value);
    if (fault != NumberFault::none && fault != NumberFault::not_finite) scan_.fail_found(word, expected);
    return value;
  }
  void need(std::uint64_t count, std::size_t numbers_each, const char* expected) override {
    if (count > (scan_.bytes_left() + 1) / (2 * numbers_each))  // a digit and a blank each
      scan_.fail("the remaining " + std::to_string(scan_.bytes_left()) + " bytes of the file cannot hold " +
                     std::to_string(count) + " " + expected,
                 "correct the count, or the file was cut short");
  }
  void skip_past(std::string_view line) override {
    while (text_line() != line)
      if (line_.empty())
        scan_.fail("the file ends where " + std::string(line) + " was expected", "it was cut short");
  }
  std::uint32_t line() const override { return static_cast<std::uint32_t>(scan_.line()); }
  std::string where() const override { return scan_.where(); }
  void fail(std::string problem, std::string remedy) const override {
    scan_.fail(std::move(problem), std::move(remedy));
  }

 private:
  TextScanner scan_;
  std::string_view line_;
};

class GmshBytes final : public GmshNumbers {
 public:
  GmshBytes(std::string_view bytes, const std::string& source, std::size_t offset, bool swapped)
      : reader_(bytes, source, offset, swapped) {}

  std::string_view text_line() override {
    std::string_view line;
    while (line.empty() && reader_.bytes_left() > 0) {
      line = reader_.line("a line");
      while (line.ends_with(' ')) line.remove_suffix(1);
    }
    return line;
  }
  std::int32_t integer(const char* expected) override { return reader_.take<std::int32_t>(expected); }
  std::uint64_t size(const char* expected) override { return reader_.take<std::uint64_t>(expected); }
  double real(const char* expected) override { return reader_.take<double>(expected); }
  double any_real(const char* expected) override { return real(expected); }
  void need(std::uint64_t count, std::size_t numbers_each, const char* expected) override {
    reader_.need(count, 4 * numbers_each, expected);
  }
  void skip_past(std::string_view line) override { reader_.skip_past("\n" + std::string(line)); }
  std::uint32_t line() const override { return 0; }
  std::string where() const override { return reader_.where(); }
  void fail(std::string problem, std::string remedy) const override {
    reader_.fail(std::move(problem), std::move(remedy));
  }

 private:
  ByteReader reader_;
};

}  // namespace leonhard::io
