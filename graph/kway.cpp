// SPDX-License-Identifier: MIT
#include "leonhard/graph/kway.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include "leonhard/graph/kway_balance.hpp"
#include "leonhard/graph/kway_coarsen.hpp"
#include "leonhard/graph/kway_flow.hpp"
#include "leonhard/graph/kway_fm.hpp"
#include "leonhard/graph/kway_initial.hpp"
#include "leonhard/graph/kway_random.hpp"

namespace leonhard::graph::detail {
namespace {

/// A partition and what it is worth.
struct Candidate {
  std::vector<std::uint32_t> part_of;
  bool balanced = false;
  std::int64_t cut = std::numeric_limits<std::int64_t>::max();

  [[nodiscard]] bool operator<(const Candidate& other) const {
    return balanced != other.balanced ? balanced : cut < other.cut;
  }
};

class Partitioner {
 public:
  Partitioner(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit, const KwaySettings& settings,
              std::uint64_t seed, const Progress& progress)
      : graph_(graph),
        parts_(parts),
        limit_(limit),
        settings_(settings),
        random_(seed),
        progress_(progress) {}

  KwayResult operator()() {
    std::vector<Candidate> population;
    for (std::uint32_t i = 0; i < settings_.population; ++i) {
      if (i > 0 && progress_.stop_requested()) break;
      population.push_back(from_nothing());
    }
    for (std::uint32_t i = 0; i < settings_.combinations && !progress_.stop_requested(); ++i)
      replace(population, combined(population[winner(population)], population[winner(population)]));
    Candidate& best = *std::ranges::min_element(population, std::less<>{});
    return {std::move(best.part_of), progress_.stop_requested()};
  }

 private:
  Candidate from_nothing() {
    const Hierarchy levels(graph_, coarsest_size(), {}, random_, progress_.stop);
    return rise(levels, recursive_multilevel_bisection(levels.coarsest(), parts_, limit_, settings_.bisection,
                                                       random_, progress_.stop));
  }

  /// What neither parent cuts stays joined; of the same parent twice, a new descent that keeps its cuts.
  Candidate combined(const Candidate& a, const Candidate& b) {
    std::unordered_map<std::uint64_t, std::uint32_t> number;  // of a pair of parts
    std::vector<std::uint32_t> label;
    label.reserve(graph_.size());
    for (std::uint32_t v = 0; v < graph_.size(); ++v) {
      const std::uint64_t pair = std::uint64_t{a.part_of[v]} * parts_ + b.part_of[v];
      label.push_back(number.try_emplace(pair, static_cast<std::uint32_t>(number.size())).first->second);
    }
    const Hierarchy levels(graph_, coarsest_size(), std::move(label), random_, progress_.stop);
    return rise(levels, levels.to_coarsest((b < a ? b : a).part_of));
  }

  Candidate rise(const Hierarchy& levels, std::vector<std::uint32_t> part_of) {
    for (std::size_t depth = levels.levels(); depth-- > 0;) {
      const double risen = 1 - static_cast<double>(depth) / static_cast<double>(levels.levels());
      progress_("multilevel partition", std::min(1.0, (cycles_ + risen) / total_cycles()));
      if (depth + 1 < levels.levels()) part_of = levels.project(depth, part_of);
      if (!progress_.stop_requested())
        refine(levels.level(depth), part_of, depth == 0 ? settings_.finest : settings_.coarse);
    }
    ++cycles_;
    Candidate result;
    result.balanced = keep_limit(graph_, parts_, limit_, part_of);
    result.cut = cut_of(graph_, part_of);
    result.part_of = std::move(part_of);
    return result;
  }

  void refine(const KwayGraph& graph, std::vector<std::uint32_t>& part_of,
              const RefinementSettings& settings) {
    KwayFm fm(graph, parts_, limit_, part_of, random_);
    fm.rebalance();
    for (std::uint32_t i = 0; i < settings.searches && !progress_.stop_requested(); ++i)
      if (fm.search_round(settings.patience, progress_.stop) == 0) break;
    const KwayFlow::Room room{graph.total_weight / parts_, limit_};
    KwayFlow flow(graph, std::vector(parts_, room), part_of, random_);
    for (std::uint32_t i = 0; i < settings.flows && !progress_.stop_requested(); ++i)
      if (flow.round(settings.reach, progress_.stop) == 0) break;
  }

  /// The better of two at random.
  std::size_t winner(const std::vector<Candidate>& population) {
    const auto count = static_cast<std::uint32_t>(population.size());
    const std::size_t i = random_.below(count), j = random_.below(count);
    return population[j] < population[i] ? j : i;
  }

  static void replace(std::vector<Candidate>& population, Candidate offspring) {
    Candidate& worst = *std::ranges::max_element(population, std::less<>{});
    if (offspring < worst) worst = std::move(offspring);
  }

  [[nodiscard]] std::uint32_t coarsest_size() const {
    return std::max(settings_.coarsest, settings_.coarsest_per_part * parts_);
  }
  [[nodiscard]] double total_cycles() const { return settings_.population + settings_.combinations; }

  const KwayGraph& graph_;
  std::uint32_t parts_;
  std::int64_t limit_;
  const KwaySettings& settings_;
  Random random_;
  const Progress& progress_;
  std::uint32_t cycles_ = 0;
};

}  // namespace

KwaySettings settings_of(Effort effort) {
  KwaySettings settings;
  settings.finest.searches = 2;
  settings.finest.reach = 2;
  switch (effort) {
    case Effort::low:
      settings.coarsest = 100;
      settings.bisection.repeats = 1;
      settings.coarse.flows = settings.finest.flows = 0;
      break;
    case Effort::normal:
      break;
    case Effort::high:
      settings.bisection.repeats = 10;
      settings.coarse = settings.finest = {15, 5, 5, 8};
      settings.population = 8;
      settings.combinations = 40;
      break;
  }
  return settings;
}

KwayResult multilevel_kway(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
                           const KwaySettings& settings, std::uint64_t seed, const Progress& progress) {
  return Partitioner(graph, parts, limit, settings, seed, progress)();
}

}  // namespace leonhard::graph::detail
