// SPDX-License-Identifier: MIT
#include "tests/app/program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace leonhard::test {

Ran run(const std::string& arguments, const std::filesystem::path& folder, const std::string& program) {
  const ScratchFolder scratch;
  const auto out = scratch.path() / "out", err = scratch.path() / "err";
  // PETSc and MPI keep what they allocate at their start, in modules that are gone when the leak sanitizer looks for
  // names to suppress: sanitized builds look for leaks in every subcommand but solve.
  const std::string environment = arguments.starts_with("solve") ? "ASAN_OPTIONS=detect_leaks=0 " : "";
  const std::string command = "cd '" + folder.string() + "' && " + environment + "'" +
                              (program.empty() ? LEONHARD_PROGRAM : program) + "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "' </dev/null";
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): the shell redirects
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(out), text_of(err)};
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "leonhard-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no scratch folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::write(const std::string& name, const std::string& text) const {
  const auto file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<int> numbers_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<int> numbers;
  for (int number; in >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace leonhard::test
