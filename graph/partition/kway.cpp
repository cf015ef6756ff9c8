// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include "leonhard/graph/multilevel/kway_coarsen.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"
#include "leonhard/graph/multilevel/two_way_fm.hpp"
#include "leonhard/graph/partition/kway_flow.hpp"
#include "leonhard/graph/partition/kway_fm.hpp"
#include "leonhard/graph/partition/kway_initial.hpp"

namespace leonhard::graph::detail {
namespace {

constexpr std::uint32_t two_way_passes = 8;

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
    progress_("multilevel partition", 0);
    Candidate best =
        evolved(graph_, settings_.population, settings_.combinations, [&] { return from_nothing(); });
    return {std::move(best.part_of), progress_.stop_requested()};
  }

 private:
  /// Partitions made independently, then the better of two and the better of two others combined again and again.
  template <class Make>
  Candidate evolved(const KwayGraph& graph, std::uint32_t count, std::uint32_t combinations,
                    const Make& make) {
    std::vector<Candidate> population;
    for (std::uint32_t i = 0; i < count; ++i)
      if (i == 0 || !progress_.stop_requested()) population.push_back(make());
    for (std::uint32_t i = 0; i < combinations && !progress_.stop_requested(); ++i) {
      const Candidate& a = population[winner(population)];
      Candidate offspring = combined(graph, a, population[winner(population)]);
      Candidate& worst = *std::ranges::max_element(population, std::less<>{});
      if (offspring < worst) worst = std::move(offspring);
    }
    return std::move(*std::ranges::min_element(population, std::less<>{}));
  }

  /// Coarsened, partitioned where it is coarsest, refined on the way up.
  Candidate from_nothing() {
    const std::uint32_t size = std::max(settings_.coarsest, vertices_for_parts(settings_.coarsest_per_part));
    const Hierarchy levels(graph_, size, {}, random_, progress_.stop);
    const KwayGraph& coarsest = levels.coarsest();
    const auto bisected = [&] {
      std::vector<std::uint32_t> part_of = recursive_multilevel_bisection(
          coarsest, parts_, limit_on(coarsest), settings_.bisection, random_, progress_.stop);
      refine(coarsest, part_of, settings_.coarse);
      return valued(coarsest, std::move(part_of));
    };
    Candidate best = evolved(coarsest, settings_.coarse_population, settings_.coarse_combinations, bisected);
    if (levels.levels() == 1) return best;
    return rise(levels, levels.project(levels.levels() - 2, best.part_of), levels.levels() - 1);
  }

  /// What neither parent cuts stays joined on the way down; the better one is where the way up starts.
  Candidate combined(const KwayGraph& graph, const Candidate& a, const Candidate& b) {
    std::unordered_map<std::uint64_t, std::uint32_t> number;  // of a pair of parts
    std::vector<std::uint32_t> label;
    label.reserve(graph.size());
    for (std::uint32_t v = 0; v < graph.size(); ++v) {
      const std::uint64_t pair = std::uint64_t{a.part_of[v]} * parts_ + b.part_of[v];
      label.push_back(number.try_emplace(pair, static_cast<std::uint32_t>(number.size())).first->second);
    }
    const Hierarchy levels(graph, vertices_for_parts(10), std::move(label), random_, progress_.stop);
    return rise(levels, levels.to_coarsest((b < a ? b : a).part_of), levels.levels());
  }

  /// Refines on levels depth - 1, ... 0; part_of is of the first of them.
  Candidate rise(const Hierarchy& levels, std::vector<std::uint32_t> part_of, std::size_t depth) {
    while (depth-- > 0) {
      const KwayGraph& level = levels.level(depth);
      refine(level, part_of, &level == &graph_ ? settings_.finest : settings_.coarse);
      if (depth > 0) part_of = levels.project(depth - 1, part_of);
    }
    if (&levels.level(0) == &graph_) progress_("multilevel partition", ++cycles_ / total_cycles());
    return valued(levels.level(0), std::move(part_of));
  }

  Candidate valued(const KwayGraph& graph, std::vector<std::uint32_t> part_of) const {
    Candidate result;
    result.balanced = std::ranges::max(part_weights(graph, part_of, parts_)) <= limit_on(graph);
    result.cut = cut_of(graph, part_of);
    result.part_of = std::move(part_of);
    return result;
  }

  void refine(const KwayGraph& graph, std::vector<std::uint32_t>& part_of,
              const RefinementSettings& settings) {
    if (progress_.stop_requested()) return;
    const std::int64_t limit = limit_on(graph);
    const std::int64_t mean = graph.total_weight / parts_;
    if (parts_ == 2) {
      TwoWayFm(graph, {{mean, graph.total_weight - mean}, {limit, limit}}).refine(part_of, two_way_passes);
    } else {
      KwayFm fm(graph, parts_, limit, part_of, random_);
      fm.rebalance();
      for (std::uint32_t i = 0; i < settings.searches && !progress_.stop_requested(); ++i)
        if (fm.search_round(settings.patience, progress_.stop) == 0) break;
    }
    KwayFlow flow(graph, std::vector(parts_, KwayFlow::Room{mean, limit}), part_of, random_);
    for (std::uint32_t i = 0; i < settings.flows && !progress_.stop_requested(); ++i)
      if (flow.round(settings.strip, progress_.stop) == 0) break;
  }

  /// The better of two at random.
  std::size_t winner(const std::vector<Candidate>& population) {
    const auto count = static_cast<std::uint32_t>(population.size());
    const std::size_t i = random_.below(count), j = random_.below(count);
    return population[j] < population[i] ? j : i;
  }

  [[nodiscard]] std::uint32_t vertices_for_parts(std::uint32_t each) const {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(std::uint64_t{each} * parts_, graph_.size() + 1U));
  }
  [[nodiscard]] std::int64_t limit_on(const KwayGraph& graph) const {
    return &graph == &graph_ ? limit_ : limit_ + allowance(graph);
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
  settings.finest = {.patience = 5, .searches = 2, .flows = 2, .strip = {4, 6}};
  switch (effort) {
    case Effort::low:
      settings.coarsest = 200;
      settings.bisection.repeats = 1;
      settings.finest.flows = 1;
      settings.finest.strip.reach = 2;
      break;
    case Effort::normal:
      break;
    case Effort::high:
      settings.bisection = {.coarsest = 80, .tries = 10, .repeats = 10};
      settings.coarse = settings.finest = {.patience = 15, .searches = 5, .flows = 5, .strip = {8, 16}};
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
