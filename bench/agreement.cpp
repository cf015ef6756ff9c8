// SPDX-License-Identifier: MIT
// The long run: predicates against rational arithmetic on points chosen to hurt them, for as many calls as one asks.
//   bench_agreement [CALLS_A_PREDICATE [SEED [THREADS]]]
// Prints a table of calls, ties and disagreements; the exit code is 1 if there is a disagreement, which is printed as C++.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Sign;
using leonhard::testing::as_source;
using leonhard::testing::Quadruple;
using leonhard::testing::Quintuple;
using leonhard::testing::Random;

namespace {

struct Orient2d {
  static constexpr const char* name = "orient2d";
  static Sign ours(const Quadruple& q) { return k::orient2d(q[0], q[1], q[2]); }
  static Sign truth(const Quadruple& q) { return k::exact::orient2d(q[0], q[1], q[2]); }
  static bool holds_perturbed(const Quadruple&, Sign) { return true; }
};

struct Incircle {
  static constexpr const char* name = "incircle";
  static Sign ours(const Quadruple& q) { return k::incircle(q[0], q[1], q[2], q[3]); }
  static Sign truth(const Quadruple& q) { return k::exact::incircle(q[0], q[1], q[2], q[3]); }
  /// The perturbed form agrees where there is no tie, and turns with a swap where there is one.
  static bool holds_perturbed(const Quadruple& q, Sign truth) {
    const Sign s = k::incircle_perturbed(q[0], q[1], q[2], q[3]);
    return truth != Sign::zero ? s == truth : k::incircle_perturbed(q[1], q[0], q[2], q[3]) == -s;
  }
};

struct Orient3d {
  static constexpr const char* name = "orient3d";
  static Sign ours(const Quintuple& q) { return k::orient3d(q[0], q[1], q[2], q[3]); }
  static Sign truth(const Quintuple& q) { return k::exact::orient3d(q[0], q[1], q[2], q[3]); }
  static bool holds_perturbed(const Quintuple&, Sign) { return true; }
};

struct Insphere {
  static constexpr const char* name = "insphere";
  static Sign ours(const Quintuple& q) { return k::insphere(q[0], q[1], q[2], q[3], q[4]); }
  static Sign truth(const Quintuple& q) { return k::exact::insphere(q[0], q[1], q[2], q[3], q[4]); }
  static bool holds_perturbed(const Quintuple& q, Sign truth) {
    const Sign s = k::insphere_perturbed(q[0], q[1], q[2], q[3], q[4]);
    return truth != Sign::zero ? s == truth : k::insphere_perturbed(q[1], q[0], q[2], q[3], q[4]) == -s;
  }
};

struct Count {
  std::uint64_t calls = 0, ties = 0, disagreements = 0;
};

/// One thread's share of the calls: every family in turn.
template <class P, class Families>
std::vector<Count> ask(const Families& families, std::uint64_t calls, std::uint64_t seed) {
  static std::mutex printing;
  Random random(seed);
  std::vector<Count> counts(families.size());
  for (std::uint64_t i = 0; i < calls; ++i) {
    Count& count = counts[i % families.size()];
    const auto points = families[i % families.size()].draw(random);
    const Sign truth = P::truth(points);
    ++count.calls;
    count.ties += truth == Sign::zero;
    if (P::ours(points) == truth && P::holds_perturbed(points, truth)) continue;
    ++count.disagreements;
    const std::lock_guard lock(printing);
    std::printf("%s disagrees: %s\n", P::name, as_source(points).c_str());
  }
  return counts;
}

/// returns  the number of disagreements
template <class P, class Families>
std::uint64_t compare(const Families& families, std::uint64_t calls, std::uint64_t seed, unsigned threads) {
  std::vector<std::vector<Count>> shares(threads);
  std::vector<std::thread> workers;
  for (unsigned t = 0; t < threads; ++t)
    workers.emplace_back(
        [&, t] { shares[t] = ask<P>(families, (calls + threads - 1) / threads, seed * 1000 + t); });
  for (std::thread& worker : workers) worker.join();

  Count sum;
  for (std::size_t f = 0; f < families.size(); ++f) {
    Count family;
    for (const auto& share : shares) {
      family.calls += share[f].calls;
      family.ties += share[f].ties;
      family.disagreements += share[f].disagreements;
    }
    std::printf("%-9s %-56s %12llu %12llu %6llu\n", P::name, families[f].name,
                static_cast<unsigned long long>(family.calls), static_cast<unsigned long long>(family.ties),
                static_cast<unsigned long long>(family.disagreements));
    sum.calls += family.calls;
    sum.ties += family.ties;
    sum.disagreements += family.disagreements;
  }
  std::printf("%-9s %-56s %12llu %12llu %6llu\n", P::name, "all", static_cast<unsigned long long>(sum.calls),
              static_cast<unsigned long long>(sum.ties), static_cast<unsigned long long>(sum.disagreements));
  std::fflush(stdout);
  return sum.disagreements;
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int i, std::uint64_t otherwise) {
    return i < count ? std::strtoull(arguments[i], nullptr, 10) : otherwise;
  };
  const std::uint64_t calls = number(1, 100'000), seed = number(2, 1);
  const auto threads = static_cast<unsigned>(number(3, 2));
  if (calls == 0 || threads == 0) {
    std::fputs("usage: bench_agreement [CALLS_A_PREDICATE [SEED [THREADS]]], numbers from 1 on\n", stderr);
    return 1;
  }
  std::printf("%-9s %-56s %12s %12s %6s\n", "predicate", "points", "calls", "ties", "wrong");
  std::uint64_t wrong = compare<Orient2d>(leonhard::testing::point_families(), calls, seed, threads);
  wrong += compare<Incircle>(leonhard::testing::point_families(), calls, seed, threads);
  wrong += compare<Orient3d>(leonhard::testing::point_families3(), calls, seed, threads);
  wrong += compare<Insphere>(leonhard::testing::point_families3(), calls, seed, threads);
  std::printf("%llu calls of each predicate, seed %llu: %llu disagreements\n",
              static_cast<unsigned long long>(calls), static_cast<unsigned long long>(seed),
              static_cast<unsigned long long>(wrong));
  return wrong == 0 ? 0 : 1;
}
