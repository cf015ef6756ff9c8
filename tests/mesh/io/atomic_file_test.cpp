// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/atomic_file.hpp"

#include <doctest/doctest.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

using namespace leonhard;
namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "leonhard-test-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path operator/(const char* name) const { return path_ / name; }
  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(path_), {}); }

 private:
  fs::path path_;
};

std::string contents(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string failure(const fs::path& path, const std::string& bytes) {
  try {
    io::write_file_atomically(path, bytes);
  } catch (const OutputError& error) {
    CHECK(error.path() == path);
    return error.what();
  }
  return "written";
}

}  // namespace

TEST_CASE("file_appears_whole_on_commit_and_nothing_else_stays") {
  const Folder folder;
  const std::string large(3'000'001, 'x');
  {
    AtomicFile file(folder / "a.txt");
    file.write("begin ");
    file.write(large);
    CHECK_FALSE(fs::exists(folder / "a.txt"));
    file.commit();
  }
  CHECK(contents(folder / "a.txt") == "begin " + large);
  CHECK(folder.files() == 1);
}

TEST_CASE("file_without_commit_leaves_the_old_one_and_no_temporary") {
  const Folder folder;
  io::write_file_atomically(folder / "a.txt", "old");
  {
    AtomicFile file(folder / "a.txt");
    file.write("new");
    AtomicFile moved(std::move(file));
    moved.write("er");
    CHECK(folder.files() == 2);
  }
  CHECK(contents(folder / "a.txt") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("two_files_of_one_target_do_not_disturb_each_other") {
  const Folder folder;
  AtomicFile first(folder / "a.txt"), second(folder / "a.txt");
  first.write("first");
  second.write("second");
  first.commit();
  CHECK(contents(folder / "a.txt") == "first");
  second.commit();
  CHECK(contents(folder / "a.txt") == "second");
  CHECK(folder.files() == 1);
}

TEST_CASE("replacing_a_file_keeps_its_permissions_and_follows_links") {
  const Folder folder;
  io::write_file_atomically(folder / "real.txt", "old");
  ::chmod((folder / "real.txt").c_str(), 0640);
  fs::create_symlink("real.txt", folder / "link.txt");
  io::write_file_atomically(folder / "link.txt", "new");
  CHECK(fs::is_symlink(folder / "link.txt"));
  CHECK(contents(folder / "real.txt") == "new");
  CHECK((fs::status(folder / "real.txt").permissions() & fs::perms::all) == fs::perms{0640});
}

TEST_CASE("writing_to_a_full_device_is_an_output_error") {
  if (!fs::exists("/dev/full")) {
    MESSAGE("skipped: there is no /dev/full here");
    return;
  }
  CHECK(failure("/dev/full", "some bytes") == "cannot write /dev/full: No space left on device");
  CHECK(failure("/dev/full", std::string(3'000'000, 'x')).find("No space left") != std::string::npos);
  CHECK(fs::is_character_file("/dev/full"));
  CHECK(failure("/dev/null", "some bytes") == "written");
}

TEST_CASE("targets_that_cannot_be_written_are_output_errors_that_name_them") {
  const Folder folder;
  CHECK(failure(folder / "missing/a.txt", "x").find("missing/a.txt: No such file") != std::string::npos);
  CHECK(failure(folder.path(), "x").find("it is a folder") != std::string::npos);
  io::write_file_atomically(folder / "file", "x");
  CHECK(failure(folder / "file/a.txt", "x").find("Not a directory") != std::string::npos);
  if (fs::exists("/proc/self"))
    CHECK(failure("/proc/leonhard.txt", "x").find("/proc/leonhard.txt: ") != std::string::npos);
  else
    MESSAGE("skipped: there is no /proc here");
}

TEST_CASE("a_folder_without_the_right_to_write_is_an_output_error") {
  const Folder folder;
  const fs::path closed = folder / "closed";
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  // Root may write anywhere, so as root the file is written by a child that has become nobody.
  if (::geteuid() != 0) {
    CHECK(failure(closed / "a.txt", "x").find("Permission denied") != std::string::npos);
  } else {
    fs::permissions(folder.path(), fs::perms::all);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      constexpr uid_t nobody = 65534;
      if (::setgid(nobody) != 0 || ::setuid(nobody) != 0) ::_exit(3);
      try {
        io::write_file_atomically(closed / "a.txt", "x");
      } catch (const OutputError& error) {
        ::_exit(std::string(error.what()).find("Permission denied") != std::string::npos ? 0 : 1);
      }
      ::_exit(2);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
  }
  fs::permissions(closed, fs::perms::owner_all);
}

TEST_CASE("full_disc_is_an_output_error_and_leaves_the_old_file_alone") {
  const Folder folder;
  const fs::path disc = folder / "disc";
  fs::create_directory(disc);
  if (::mount("none", disc.c_str(), "tmpfs", 0, "size=64k") != 0) {
    MESSAGE("skipped: mounting a small disc needs rights that are not there: " << std::strerror(errno));
    return;
  }
  io::write_file_atomically(disc / "a.txt", "old");
  CHECK(failure(disc / "a.txt", std::string(200'000, 'x')).find("No space left on device") !=
        std::string::npos);
  CHECK(contents(disc / "a.txt") == "old");
  CHECK(std::distance(fs::directory_iterator(disc), {}) == 1);
  ::umount(disc.c_str());
}
