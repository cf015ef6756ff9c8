// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace leonhard {

/// Bad input: what is wrong, where, and what to do. Thrown before anything was changed or written.
///
/// what() reads "where: problem; remedy", for example
///   "wing.su2:118: vertex 9001 of triangle 17 does not exist, the file declares 5233 vertices; correct the
///    triangle or NPOIN".
class InputError : public std::runtime_error {
 public:
  /// where    file and line ("wing.dat:12"), a case file's key, or the argument's name; may be empty
  /// problem  what is wrong, naming ids, values and coordinates
  /// remedy   what the user should do; may be empty
  InputError(std::string where, std::string problem, std::string remedy = {})
      : std::runtime_error(join(where, problem, remedy)),
        where_(std::move(where)),
        problem_(std::move(problem)),
        remedy_(std::move(remedy)) {}

  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] const std::string& remedy() const { return remedy_; }

 private:
  static std::string join(const std::string& where, const std::string& problem, const std::string& remedy) {
    return (where.empty() ? "" : where + ": ") + problem + (remedy.empty() ? "" : "; " + remedy);
  }
  std::string where_, problem_, remedy_;
};

/// "file:line", the form in which every reader says where.
[[nodiscard]] inline std::string at_line(const std::string& file, std::size_t line) {
  return file + ":" + std::to_string(line);
}

}  // namespace leonhard
