// SPDX-License-Identifier: MIT
#include "leonhard/app/command_line/command_line.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

#include "leonhard/app/commands/commands.hpp"

using namespace leonhard::app;

namespace {

struct Given {
  std::string word, choice = "a", text;
  int number = 3;
  double size = 0;
  bool flag = false;
  std::vector<double> list;
  std::uint64_t bytes = 0;
};

/// What a line of words after "program try" leaves in the variables.
ExitCode read(Given& given, const std::vector<std::string>& words) {
  bool ran = false;
  const std::vector<Command> commands{
      {.name = "try",
       .help = "Try",
       .options = {{"word", "A word", &given.word, true},
                   {.names = "--choice", .help = "Choose", .target = &given.choice, .choices = {"a", "b"}},
                   {.names = "-n,--number", .help = "N", .target = &given.number, .range = OptionRange{1, 9}},
                   {.names = "--size", .help = "S", .target = &given.size, .rule = OptionRule::positive},
                   {.names = "--list", .help = "L", .target = &given.list, .length = OptionLength{2, 4}},
                   {.names = "--bytes", .help = "B", .target = &given.bytes, .rule = OptionRule::bytes},
                   {.names = "--text", .help = "T", .target = &given.text, .excludes = "--choice"},
                   {"--flag", "F", &given.flag}},
       .run = [&ran] {
         ran = true;
         return ExitCode::goal_not_met;
       }}};
  std::vector<const char*> arguments{"program", "try"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  const ExitCode code = run_command_line({"program", "", "1", ""}, commands,
                                         static_cast<int>(arguments.size()), arguments.data());
  CHECK(ran == (code == ExitCode::goal_not_met));
  return code;
}

ExitCode code_of(const std::vector<std::string>& words) {
  Given given;
  return read(given, words);
}

}  // namespace

TEST_CASE("options_reach_their_variables_and_the_command_runs") {
  Given given;
  const std::vector<std::string> words{"here", "--choice", "b",     "-n",      "9",   "--size",
                                       "0.5",  "--list",   "1,2,3", "--bytes", "2KB", "--flag"};
  CHECK(read(given, words) == ExitCode::goal_not_met);
  CHECK(given.word == "here");
  CHECK(given.choice == "b");
  CHECK(given.number == 9);
  CHECK(given.size == 0.5);
  CHECK(given.list == std::vector<double>{1, 2, 3});
  CHECK(given.bytes == 2048);
  CHECK(given.flag);
}

TEST_CASE("what_an_option_does_not_take_is_wrong_usage") {
  CHECK(code_of({"w"}) == ExitCode::goal_not_met);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{},
                                             {"w", "--choice", "c"},
                                             {"w", "-n", "0"},
                                             {"w", "-n", "10"},
                                             {"w", "--size", "0"},
                                             {"w", "--list", "1"},
                                             {"w", "--list", "1,2,3,4,5"},
                                             {"w", "--text", "x", "--choice", "a"},
                                             {"w", "--unknown"},
                                             {"w", "-n", "x"}})
    CHECK(code_of(words) == ExitCode::wrong_usage);
}

TEST_CASE("every_option_of_every_subcommand_is_listed_once_with_its_help") {
  std::set<std::string> commands;
  for (const Command& command : all_commands()) {
    CAPTURE(command.name);
    CHECK(commands.insert(command.name).second);
    CHECK_FALSE(command.help.empty());
    std::set<std::string> names;
    for (const Option& option : command.options) {
      CAPTURE(option.names);
      CHECK(names.insert(option.names).second);
      CHECK_FALSE(option.help.empty());
    }
    CHECK(names.contains("--json"));
  }
  CHECK(commands.size() == 11);
}
