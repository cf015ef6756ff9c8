// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

/// Coarse enough for a second, fine enough for the flow to look like one.
const char* const coarse_case =
    "title = \"coarse\"\n[flow]\nmach = 0.5\nalpha_deg = 1.25\n[[body]]\nname = \"airfoil\"\nnaca = "
    "\"0012\"\nspacing = 0.03\n"
    "[farfield]\ndistance = 20\n[mesher]\ngrowth = 0.15\n[partition]\nparts = 4\n";

}  // namespace

TEST_CASE("solve_writes_a_complete_report") {
  const ScratchFolder scratch;
  scratch.write("case.toml", coarse_case);
  const auto ran = run("solve case.toml -o out --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["outcome"] == "converged");
  CHECK(report["residual_drop_orders"] >= 8.0);
  CHECK(report["cl"].get<double>() == doctest::Approx(0.179).epsilon(0.1).scale(0));
  CHECK(report["euler"]["balances"] == true);
  CHECK(report["area"]["equal"] == true);
  CHECK(report["partition"]["parts"] == 4);
  CHECK(report["ordering"][1]["bandwidth"] < report["ordering"][0]["bandwidth"]);
  CHECK(json::parse(text_of(scratch.path() / "out/report.json")) == report);
  for (const auto& name : report["files"]) {
    CHECK(std::filesystem::file_size(scratch.path() / "out" / name.get<std::string>()) > 100);
  }
  for (const char* name :
       {"report.html", "report.json", "history.csv", "surface.csv", "field.vtu", "mesh.su2", "mesh.png",
        "mesh-close-up.png", "mach.png", "cp.png", "history.png", "partition.png", "matrix.png"}) {
    CHECK_MESSAGE(std::filesystem::exists(scratch.path() / "out" / name), name);
  }
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path() / "out"), {}) ==
        static_cast<std::ptrdiff_t>(report["files"].size()));

  const std::string page = text_of(scratch.path() / "out/report.html");
  CHECK(page.find("://") == std::string::npos);  // nothing from the network
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("balances") != std::string::npos);
  CHECK(run("draw out/field.vtu --field mach -o mach.svg", scratch.path()).exit_code == 0);
}

TEST_CASE("solve_gives_the_same_bits_for_one_and_two_threads") {
  const ScratchFolder scratch;
  scratch.write("case.toml", std::string(coarse_case) + "[solver]\nresidual_drop_orders = 3\n");
  const json one = json::parse(run("solve case.toml -o one --threads 1 --json", scratch.path()).out);
  const json two = json::parse(run("solve case.toml -o two --threads 2 --json", scratch.path()).out);
  CHECK(one["mesh"]["fingerprint"] == two["mesh"]["fingerprint"]);
  CHECK(text_of(scratch.path() / "one/surface.csv") == text_of(scratch.path() / "two/surface.csv"));
  CHECK(one["residual_drop_orders"] == two["residual_drop_orders"]);
}

TEST_CASE("a_case_cuts_its_mesh_by_any_method_and_into_no_more_parts_than_triangles") {
  const ScratchFolder scratch;
  std::map<std::string, std::size_t> cut;
  for (const char* method : {"coordinate", "cuthill-mckee", "spectral", "multilevel"}) {
    scratch.write("case.toml",
                  std::string(coarse_case) + "method = \"" + method + "\"\n[solver]\nmax_iterations = 2\n");
    const json report =
        json::parse(run("solve case.toml -o " + std::string(method) + " --json", scratch.path()).out);
    CHECK(report["partition"]["method"] == method);
    CHECK(report["partition"]["parts"] == 4);
    cut[method] = report["partition"]["cut"];
  }
  CHECK(cut["multilevel"] < cut["spectral"]);
  CHECK(cut["spectral"] < cut["cuthill-mckee"]);
  std::string many = coarse_case;
  many.replace(many.find("parts = 4"), 9, "parts = 1000000");
  scratch.write("case.toml", many + "[solver]\nmax_iterations = 2\n");
  const json report = json::parse(run("solve case.toml -o many --json", scratch.path()).out);
  CHECK(report["partition"]["parts"] == report["mesh"]["triangles"]);
}

TEST_CASE("a_goal_not_met_is_code_3_and_says_which") {
  const ScratchFolder scratch;
  scratch.write("case.toml", std::string(coarse_case) + "[solver]\nmax_iterations = 2\n");
  const auto ran = run("solve case.toml -o out", scratch.path());
  CHECK(ran.exit_code == 3);
  CHECK(ran.out.find("iteration") != std::string::npos);
  CHECK(std::filesystem::exists(scratch.path() / "out/report.html"));
}

TEST_CASE("a_dry_run_prints_every_key_and_writes_nothing") {
  const ScratchFolder scratch;
  scratch.write("case.toml", coarse_case);
  const auto ran = run("solve case.toml -o out --dry-run", scratch.path());
  CHECK(ran.exit_code == 0);
  for (const char* key :
       {"flow.mach", "flow.gamma", "solver.limiter", "mesher.growth", "body.airfoil.spacing"}) {
    CHECK_MESSAGE(ran.out.find(key) != std::string::npos, key);
  }
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "out"));
}

TEST_CASE("an_interrupt_ends_the_march_within_seconds_writes_what_it_has_and_is_code_4") {
  const ScratchFolder scratch;
  // Explicit and out of reach: it would march for minutes.
  scratch.write(
      "case.toml",
      std::string(coarse_case) +
          "[solver]\nmarching = \"explicit\"\nresidual_drop_orders = 15\nmax_iterations = 100000000\n"
          "settle_window = 0\n");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (chdir(scratch.path().c_str()) != 0) _exit(99);
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // as in run()
    execl(LEONHARD_PROGRAM, "leonhard", "solve", "case.toml", "-o", "out", "--quiet",
          static_cast<char*>(nullptr));
    _exit(98);
  }
  std::this_thread::sleep_for(std::chrono::seconds(3));
  kill(child, SIGINT);
  const auto asked = std::chrono::steady_clock::now();
  int status = 0;
  waitpid(child, &status, 0);
  // The march ends within a tenth of a second; the rest is drawing the pictures of what there is.
  CHECK(std::chrono::steady_clock::now() - asked < std::chrono::seconds(20));
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 4);
  CHECK(json::parse(text_of(scratch.path() / "out/report.json"))["outcome"] == "stopped");
}
