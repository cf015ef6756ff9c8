// SPDX-License-Identifier: MIT
// The one file that knows CLI11, which takes long to compile.
#include "leonhard/app/command_line/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <type_traits>

namespace leonhard::app {
namespace {

template <class Value>
constexpr bool is_list = false;
template <class Value>
constexpr bool is_list<std::vector<Value>> = true;
template <class Value, std::size_t n>
constexpr bool is_list<std::array<Value, n>> = true;

template <class Value>
void check_number(CLI::Option& added, const Option& option) {
  if (option.range)
    added.check(CLI::Range(static_cast<Value>(option.range->low), static_cast<Value>(option.range->high)));
  switch (option.rule) {
    case OptionRule::none:
      break;
    case OptionRule::positive:
      added.check(CLI::PositiveNumber);
      break;
    case OptionRule::not_negative:
      added.check(CLI::NonNegativeNumber);
      break;
    case OptionRule::bytes:
      added.transform(CLI::AsSizeValue(false));
      break;
  }
}

template <class Value>
CLI::Option* add(CLI::App& command, const Option& option, Value& target) {
  CLI::Option* added = command.add_option(option.names, target, option.help);
  if constexpr (is_list<Value>) {
    added->delimiter(',');
    if (option.length && option.length->least == option.length->most)
      added->expected(option.length->least);
    else if (option.length)
      added->expected(option.length->least, option.length->most);
  } else if constexpr (std::is_arithmetic_v<Value>) {
    check_number<Value>(*added, option);
  }
  if (!option.choices.empty()) added->check(CLI::IsMember(option.choices));
  return added;
}

CLI::Option* add(CLI::App& command, const Option& option, bool& target) {
  return command.add_flag(option.names, target, option.help);
}

void add_option(CLI::App& command, const Option& option) {
  CLI::Option* added = std::visit([&](auto* target) { return add(command, option, *target); }, option.target);
  if (option.required) added->required();
  if (option.shows_default) added->capture_default_str();
  if (!option.excludes.empty()) added->excludes(option.excludes);
}

}  // namespace

ExitCode run_command_line(const ProgramText& text, const std::vector<Command>& commands, int argument_count,
                          const char* const* arguments) {
  CLI::App program{text.description, text.name};
  program.set_version_flag("--version", text.version);
  program.require_subcommand(1);
  for (const Command& command : commands) {
    CLI::App* added = program.add_subcommand(command.name, command.help);
    for (const Option& option : command.options) add_option(*added, option);
  }
  program.footer(text.footer);  // of the program alone: subcommands take over what was set before they were added
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::Success& wish) {  // --help, --version
    (void)program.exit(wish);
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "leonhard: %s\nRun leonhard --help, or leonhard SUBCOMMAND --help.\n", error.what());
    return ExitCode::wrong_usage;
  }
  for (const Command& command : commands)
    if (program.got_subcommand(command.name)) return command.run();
  return ExitCode::wrong_usage;
}

}  // namespace leonhard::app
