// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "leonhard/app/exit_code.hpp"

/// What the program understands, as data: commands fill it in, command_line.cpp reads a command line by it, and whoever
/// lists options (help, manual pages, completion) reads it too.
namespace leonhard::app {

/// The variable that receives an option's value; its type is the value's, bool a flag's. Its value before is the default.
using OptionTarget = std::variant<bool*, int*, std::uint32_t*, std::uint64_t*, double*, std::string*,
                                  std::array<int, 2>*, std::vector<double>*, std::vector<std::uint32_t>*>;

/// Numbers that an option takes, ends included.
struct OptionRange {
  double low{}, high{};
};

/// How many values a list takes.
struct OptionLength {
  int least{}, most{};
};

/// Other conditions on a value.
enum class OptionRule {
  none,
  positive,
  not_negative,
  bytes,  ///< a size: 1024, 4GB, 3MiB
};

/// An option, a flag or an argument of a subcommand.
struct Option {
  std::string names;  ///< "-k,--parts"; without dashes an argument, told by its place
  std::string help;
  OptionTarget target;
  bool required = false;
  bool shows_default = false;            ///< in the help
  std::vector<std::string> choices{};    ///< words that are taken; none: all
  std::optional<OptionRange> range{};    ///< of a number
  OptionRule rule = OptionRule::none;    ///< of a number
  std::optional<OptionLength> length{};  ///< of a list, whose values stand between commas; none: any
  std::string excludes{};                ///< an option named before, with which this one cannot stand
};

/// A subcommand.
struct Command {
  std::string name;
  std::string help;
  std::vector<Option> options;    ///< in the order of the help
  std::function<ExitCode()> run;  ///< reads the options' targets, which it keeps alive
};

}  // namespace leonhard::app
