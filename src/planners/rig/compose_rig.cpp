// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/compose_rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "planners/anytime/provers.h"
#include "planners/anytime/shares.h"
#include "planners/rig/behind_tractor.h"
#include "planners/rig/proposed.h"
#include "planners/rig/rig_workers.h"
#include "planners/rig/searches.h"
#include "vandplan/random.h"

namespace vandplan::rig {
namespace {

using anytime::Progress, anytime::Share;

/// Searches for open ways and for narrow ones.
constexpr std::array<LineSettings, 3> quick_kinds = {
    {{3, 8, 1, 32, 1, 0}, {2.2, 8, 2, 32, 1, 1}, {1.5, 8, 4, 32, 1, 2}}};
/// Searches with small steps, which look for good drives rather than for the next one.
constexpr std::array<LineSettings, 1> careful_kinds = {{{1, 1.7, 1, 32, 1, 3}}};
/// Searches that drive forward alone. A drive that backs up is found sooner, so the other searches
/// hardly ever find the way around.
constexpr std::array<LineSettings, 1> forward_kinds = {{{2.2, 2, 1, 32, 1, 4, true}}};

/// Streams of random numbers, one for each worker.
enum Stream : std::uint64_t {
  of_quick,
  of_careful,
  of_forward,
  of_tractor,
  of_best,
  of_bare,
  of_proposals
};

/// Iterations of a worker in a round: while there is no drive, and with one. Rounds grow.
struct Shares {
  std::int64_t until_drive;
  std::int64_t with_drive;
};
constexpr Shares quick_shares{48, 96}, careful_shares{48, 96}, forward_shares{16, 32};
constexpr Shares tractor_shares{16, 96}, bare_shares{128, 0};
constexpr Shares best_shares{0, 192};

/// Doublings of a round while there is no drive.
constexpr std::int64_t most_doublings = 5;
/// Distance of start and goal that is far [turning radii of the rig]. The searches take long there.
constexpr double far_apart = 12;
/// Work of the first path of the tractor over a far way.
constexpr std::int64_t work_of_far_way = 400;
/// Steps of proving in a round that nothing as wide as a body gets to the goal. More of them delay
/// the first path on a site, fewer the proof.
constexpr std::int64_t steps_of_proof = 256;

Share share(const Shares& shares, std::int64_t first_round) {
  return [shares, first_round](const Progress& now) {
    if (now.has_path) return anytime::growing_share(shares.with_drive, now.rounds_with_path);
    if (now.rounds < first_round) return std::int64_t{0};
    return shares.until_drive << std::min(now.rounds - first_round, most_doublings);
  };
}

bool is_far(const Task& task) {
  const double apart = std::hypot(task.goal.x - task.start.x, task.goal.y - task.start.y);
  return apart > far_apart * turning_radius(task.vehicle);
}

/// The drive along a known path; none if that is not free.
std::optional<anytime::Drive> drive_along(const Setting& setting, const Path& known) {
  auto commands = commands::exact_commands(setting.task, known.segments);
  if (!commands) return std::nullopt;
  return Improver(setting, {.commands = *std::move(commands)}, 0).drive();
}

// What proves bounds and that there is no path: they get steps of proofs, and no iterations.
void add_provers(anytime::Portfolio& portfolio, const Setting& setting) {
  const Share nothing = [](const Progress&) { return 0; };
  portfolio.slots.push_back({.name = "wall prover",
                             .worker = anytime::wall_prover(setting.task, &setting.towed,
                                                            setting.pricing.rule().only_gear()),
                             .share = nothing});
  portfolio.slots.back().proofs = [](const Progress& now) {
    return now.has_path ? 0 : steps_of_proof;
  };
  if (!anytime::has_rules_of_ground(setting.task)) return;
  portfolio.slots.push_back(
      {.name = "zone prover",
       .worker = anytime::zone_prover(setting.task, *portfolio.pricing, false),
       .share = nothing});
  portfolio.slots.back().proofs = anytime::share_of_zone_prover();
}

// Adds the workers to a portfolio that has the pricing of the run and no slots.
void add_workers(anytime::Portfolio& portfolio, const Task& task, const PlanOptions& options,
                 const anytime::Given& given) {
  const auto setting =
      std::make_shared<const Setting>(task, options, *portfolio.pricing, given.site);
  const auto seed = [&options](std::uint64_t stream) {
    return stream_seed(options.budget.seed, stream);
  };
  const auto add = [&portfolio](std::string_view name, std::unique_ptr<anytime::Worker> worker,
                                Share iterations) {
    portfolio.slots.push_back(
        {.name = name, .worker = std::move(worker), .share = std::move(iterations)});
  };
  const auto seek = [&](std::string_view name, std::unique_ptr<ChainSource> source, Stream stream,
                        Share iterations) {
    add(name, std::make_unique<ChainSeeker>(setting, std::move(source), seed(stream)),
        std::move(iterations));
  };
  const bool begins_far = is_far(task);
  const std::int64_t first_search = begins_far ? 1 : 0;
  std::vector<const Task*> tasks;
  for (const Task& with : setting->wheels) tasks.push_back(&with);
  const auto searches = [&](std::span<const LineSettings> kinds) {
    return std::make_unique<Searches>(setting, kinds, tasks);
  };
  const std::int64_t first_work = begins_far ? work_of_far_way : 128;
  const Share of_path = share(tractor_shares, 0);
  Share behind = [begins_far, of_path](const Progress& now) {
    const bool is_first = begins_far && now.rounds == 0 && !now.has_path;
    return is_first ? 2 * work_of_far_way : of_path(now);
  };
  if (given.known != nullptr) portfolio.drive = drive_along(*setting, *given.known);
  seek("quick searches", searches(quick_kinds), of_quick, share(quick_shares, first_search));
  seek("careful searches", searches(careful_kinds), of_careful,
       share(careful_shares, first_search));
  seek("forward searches", searches(forward_kinds), of_forward,
       share(forward_shares, first_search));
  if (setting->bare) {
    seek("searches without margin", std::make_unique<BareSearches>(setting, seed(of_bare)), of_bare,
         share(bare_shares, first_search));
  }
  seek("behind the tractor",
       std::make_unique<BehindTractor>(setting, first_work, stream_seed(seed(of_tractor), 0)),
       of_tractor, std::move(behind));
  add("best", std::make_unique<BestImprover>(setting, seed(of_best)), share(best_shares, 0));
  for (std::size_t i = 0; i < given.sources.size(); ++i) {
    const NamedSource& source = given.sources[i];
    add(source.name,
        std::make_unique<ChainSeeker>(
            setting, std::make_unique<Proposed>(setting, source.make(task, setting->options)),
            stream_seed(seed(of_proposals), i)),
        [turn = source.share](const Progress& now) {
          return now.has_path ? anytime::growing_share(turn, now.rounds_with_path) : turn;
        });
  }
  add_provers(portfolio, *setting);
}

}  // namespace

anytime::Portfolio compose(const Task& task, const PlanOptions& options, double time_price,
                           const anytime::Given& given) {
  auto pricing =
      std::make_unique<planning::Pricing>(planning::pricing_of(task, options, time_price));
  const anytime::CostBound bound(task, *pricing);
  const anytime::Finisher finisher(
      task, *pricing, {.stroke = options.planner.number("min_stroke"), .is_finished = true});
  anytime::Portfolio portfolio{.pricing = std::move(pricing),
                               .relaxed = nullptr,
                               .bound = bound,
                               .finisher = finisher,
                               .slots = {},
                               .gap = options.budget.target_gap};
  add_workers(portfolio, task, options, given);
  return portfolio;
}

}  // namespace vandplan::rig
