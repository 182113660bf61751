// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "nasty/trial.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "nasty/naive_drive.h"
#include "nasty/naive_judge.h"
#include "nasty/naive_zones.h"
#include "nasty/nasty_world.h"
#include "support/draws.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/result_file.h"

namespace vandplan::nasty {
namespace {

/// Beyond the checker's tolerance, so that it has to accept [m].
constexpr double surely_clear = CollisionChecker::tolerance + 1e-6;

/// Paths that are longer make files that take longer than all the rest [m].
constexpr double longest_written = 300;

class Judgement {
 public:
  /// The default planner has so many times the usual iterations.
  Judgement(Scenario scenario, std::uint64_t seed, int patience)
      : scenario_(std::move(scenario)),
        patience_(patience),
        rng_(stream_seed(seed, 1)),
        problem_(made()) {
    for (std::size_t i = 0; i < scenario_.masks.size(); ++i) {  // for `expect_kept`
      Mask& mask = scenario_.masks[i];
      const std::string name = "mask" + std::to_string(i);
      (void)folder_.put(name + ".pgm", mask_to_pgm(mask));
      mask.map_file = folder_.put(name + ".yaml", mask_to_yaml(mask, name + ".pgm"));
    }
  }

  Trial trial() {
    if (!problem_) return {{}, true, 0};
    try_checker();
    try_planner(default_planner(), true);
    if (!scenario_.moving.empty()) return std::move(trial_);
    for (int i = 0; i < 2 && can_be_steered(); ++i) try_planner(any_other(), false);
    if (known_ && !is_rig() && chance(0.3, rng_)) try_to_drive(*known_);
    if (bound_ > least_ * (1 + 1e-9) + leeway_) {
      fault("a bound of " + std::to_string(bound_) + " m, and a path of " + std::to_string(least_));
    }
    if (proves_none_ && known_) fault("a proof that there is no path, and a path");
    return std::move(trial_);
  }

 private:
  std::optional<Problem> made() {
    try {
      return make_problem(scenario_);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  /// What the path costs where a metre costs its length, times the factors of zones and masks [m].
  [[nodiscard]] double lengthened(const Path& path) const {
    const bool is_priced = !scenario_.zones.empty() || !scenario_.masks.empty();
    const ZoneLook look = naive_look_at_zones(scenario_, path);
    return is_priced ? look.priced_length + 3 * look.unsure : length(path);
  }

  void fault(const std::string& what) { trial_.faults.push_back(what); }

  [[nodiscard]] bool is_rig() const { return scenario_.vehicle.trailer.has_value(); }

  /// Whether others than the default planner know how.
  [[nodiscard]] bool can_be_steered() const {
    const Vehicle& vehicle = scenario_.vehicle;
    return !is_rig() || std::abs(vehicle.hitch) < vehicle.trailer->wheelbase;
  }

  const Planner& any_other() {
    const auto count = static_cast<double>(planners().size() - 1);
    for (;;) {
      const Planner& planner = planners()[1 + static_cast<std::size_t>(uniform(0, count, rng_))];
      if (!scenario_.zones.empty() && !planner.can(Capability::gears)) continue;
      if (!is_rig() || planner.can(Capability::trailers)) return planner;
    }
  }

  PlanOptions options_for(const Planner& planner) {
    PlanOptions options;
    const bool is_slow = is_rig() && planner.name != default_planner().name;
    options.budget.max_iterations =
        static_cast<std::int64_t>(any_size(30, is_slow ? 60 : 300, rng_));
    if (planner.name == default_planner().name) *options.budget.max_iterations *= patience_;
    options.budget.seed = rng_();
    if (honours(planner, "region") && chance(0.7, rng_)) options.planner.set("region", "scene");
    if (chance(0.25, rng_)) {
      options.clearance.margin = any_size(1e-4, 0.5, rng_) * scenario_.vehicle.width;
      if (chance(0.6, rng_)) options.clearance.margin_ramp = any_size(0.01, 100, rng_);
    }
    if (honours(planner, "min_stroke") && chance(0.15, rng_)) {
      options.planner.set("min_stroke", any_size(0.01, 10, rng_));
    }
    constexpr Steering kinds[] = {Steering::reeds_shepp, Steering::continuous_between_stops,
                                  Steering::continuous};
    const bool steers =
        is_rig() ? planner.can(Capability::steering_of_rigs) : planner.can(Capability::steering);
    if (steers && chance(0.7, rng_)) options.steering = kinds[rng_() % 3];
    options.cost = cost_for(planner);
    if (planner.can(Capability::gears) && chance(0.2, rng_)) {
      options.cost.gears = chance(0.5, rng_) ? AllowedGears::forward : AllowedGears::reverse;
    }
    return options;
  }

  CostOptions cost_for(const Planner& planner) {
    if (planner.can(Capability::time) && chance(0.1, rng_)) return {.measure = CostMeasure::time};
    if (!planner.can(Capability::prices) || chance(0.3, rng_)) return {};
    CostOptions cost = shortest_style;
    if (chance(0.5, rng_)) return cost;
    if (chance(0.2, rng_)) cost.forward_weight = uniform(1, 3, rng_);
    cost.reverse_weight = uniform(1, 3, rng_);
    cost.gear_change_cost = uniform(0, 10, rng_);
    if (chance(0.3, rng_)) cost.clearance_weight = any_size(0.1, 10, rng_);
    if (chance(0.3, rng_)) cost.clearance_distance = any_size(0.05, 10, rng_);
    if (chance(0.3, rng_)) cost.curvature_change_cost = any_size(0.01, 20, rng_);
    if (chance(0.3, rng_)) cost.initial_gear = InitialGear::reverse;
    return cost;
  }

  void try_planner(const Planner& planner, bool on_more_threads) {
    PlanOptions options = options_for(planner);
    const PlanResult result = plan(*problem_, planner, options);
    expect_good(planner, options, result);
    if (!on_more_threads) return;
    options.budget.threads = 5;
    const PlanResult other = plan(*problem_, planner, options);
    if (other.path != result.path || other.status != result.status || other.cost != result.cost ||
        other.lower_bound != result.lower_bound || other.iterations != result.iterations) {
      fault(planner.name + ": another answer on 5 threads");
    }
  }

  void expect_good(const Planner& planner, const PlanOptions& options, const PlanResult& result) {
    if (result.status == PlanStatus::rejected) fault(planner.name + " rejected: " + result.reason);
    const AllowedGears gears = options.cost.gears;
    if (options.clearance.margin == 0 && gears == AllowedGears::both) {
      if (is_length(result.rule)) bound_ = std::max(bound_, result.lower_bound.value_or(0.0));
      proves_none_ |= result.status == PlanStatus::no_path && planner.properties.family != "smooth";
    }
    if (!result.path) return;
    ++trial_.paths;
    if (!known_) known_ = *result.path;
    const double least = lengthened(*result.path);
    if (least < least_) {
      least_ = least;
      leeway_ = leeway_of(*result.path);
    }
    const std::string flaw = naive_flaw(scenario_, *result.path);
    if (!flaw.empty()) fault(planner.name + ", says the naive judge: " + flaw);
    expect_priced(planner, result);
    if (!scenario_.moving.empty()) expect_unmet(options, result);
    for (const Segment& segment : result.path->segments) {
      const bool is_wrong = gears == AllowedGears::forward   ? segment.length < 0.0
                            : gears == AllowedGears::reverse ? segment.length > 0.0
                                                             : false;
      if (is_wrong) fault(planner.name + " drives in a gear that is not allowed");
    }
    if (length(*result.path) < longest_written) expect_kept(planner, options, result);
  }

  /// The drive meets nobody.
  void expect_unmet(const PlanOptions& options, const PlanResult& result) {
    if (!result.speeds) return fault("a path among what moves, and no times");
    const std::string flaw =
        naive_flaw_of_drive(scenario_, {*result.path, *result.speeds}, options.clearance.margin);
    if (!flaw.empty()) fault("the drive " + flaw);
  }

  /// If a path costs its length, zones and masks make it as much dearer as naive sums say.
  void expect_priced(const Planner& planner, const PlanResult& result) {
    if (!is_length(result.rule) || result.rule.measure == CostMeasure::time) return;
    const ZoneLook look = naive_look_at_zones(scenario_, *result.path);
    if (scenario_.zones.empty() && scenario_.masks.empty()) return;
    const double off = std::abs(result.cost - look.priced_length);
    if (off > 3 * look.unsure + 1e-3 * (1 + look.priced_length)) {
      fault(planner.name + ": a cost of " + std::to_string(result.cost) +
            " m, and a naive sum of " + std::to_string(look.priced_length));
    }
  }

  /// Speeds along a path are those of its vehicle; and it is smoothed, and planned along.
  void try_to_drive(const Path& path) {
    Scenario driven = scenario_;
    driven.vehicle.limits.max_acceleration = any_size(0.01, 10, rng_);
    if (chance(0.5, rng_)) driven.vehicle.limits.max_jerk = any_size(0.01, 50, rng_);
    const TimedPath drive{path, speed_profile(path, driven.vehicle, speed_options(driven, path))};
    const DriveCheck check = check_drive(make_problem(driven), drive);
    if (!check.valid) fault("speeds: " + check.reason);
    const double least = naive_look_at_zones(driven, path).least_duration;
    if (drive.speeds.duration < 0.99 * least - 0.1) fault("speeds too high for zones");
    for (const SmoothMethod method : {SmoothMethod::clothoids, SmoothMethod::optimised}) {
      try_planner(smoother(path, method), false);
    }
    try_planner(warm_started(path), false);
    try_to_smooth(path);
  }

  /// The smoothed path is no dearer than the one given, and keeps to its vias.
  void try_to_smooth(const Path& path) {
    PlanOptions options = options_for(smoother(path, SmoothMethod::optimised));
    options.clearance = {};
    const Smoothed smoothed = smooth(*problem_, path, SmoothMethod::optimised, options);
    const PlanResult& result = smoothed.result;
    if (!smoothed.given_fault.empty()) return;
    if (!result.path) return fault("smoothing loses a path: " + result.reason);
    if (result.cost > smoothed.given_cost * (1 + 1e-9)) fault("smoothing makes a path dearer");
    const std::string flaw = naive_flaw(scenario_, *result.path);
    if (!flaw.empty()) fault("smoothed, says the naive judge: " + flaw);
    if (result.via.size() != scenario_.via.size()) fault("smoothing loses a via");
  }

  /// How much longer a path to the very goal may be than `path`, which ends a little beside it and
  /// whose poses coordinates round: the shortest path that far sideways, sqrt(8 R times the
  /// distance). So little a goal is moved where it is the start.
  double leeway_of(const Path& path) const {
    const Pose end = end_pose(path);
    const double far = std::max({std::abs(end.x), std::abs(end.y), 1.0});
    constexpr double allowed_beside = 1e-6;
    const bool has_set = !scenario_.goal_set.empty();
    const double beside =
        has_set ? allowed_beside : std::hypot(end.x - scenario_.goal.x, end.y - scenario_.goal.y);
    const double rounding = far * std::numeric_limits<double>::epsilon();
    constexpr double moved = 1e-9;
    return std::sqrt(8 * scenario_.vehicle.min_turning_radius * (beside + rounding + moved));
  }

  /// Files hold what was planned, and it is still good.
  void expect_kept(const Planner& planner, const PlanOptions& options, const PlanResult& result) {
    const ScenarioFile read = scenario_from_yaml(to_yaml(scenario_), "world.yaml", scenario_.map);
    const ResultRecord record{.scenario = scenario_.name,
                              .planner = planner.name,
                              .options = complete(planner, options, scenario_.vehicle),
                              .result = result};
    const std::string file = folder_.put("result.json", results_to_json(read, {record}));
    const std::vector<ResultRecord> records = read_results(file, read);
    if (records.size() != 1 || records[0].result.path != result.path) {
      return fault(planner.name + ": another path in the file");
    }
    const PathCheck check =
        check_path(make_problem(read.scenario), *records[0].result.path, records[0].claims);
    if (!check.valid) fault(planner.name + ": read again it is rejected: " + check.reason);
    if (scenario_.moving.empty()) return;
    const std::optional<SpeedProfile>& speeds = records[0].result.speeds;
    if (!speeds) return fault("no times in the file");
    const DriveCheck again =
        check_drive(make_problem(read.scenario), {*records[0].result.path, *speeds},
                    {options.clearance.margin});
    if (!again.valid) fault("read again the times are rejected: " + again.reason);
  }

  /// The checker accepts nothing that is hit, and everything that is clear by its tolerance.
  void try_checker() {
    const Task& task = problem_->task();
    const double reach = 2 * task.vehicle.wheelbase + task.vehicle.min_turning_radius;
    for (int i = 0; i < 20; ++i) {
      const LocalPose base = chance(0.5, rng_) ? task.start : task.goal;
      const double shift = any_size(1e-4, 1, rng_) * reach;
      const LocalPose pose =
          compose(base, {uniform(-shift, shift, rng_), uniform(-shift, shift, rng_),
                         uniform(-1, 1, rng_) * shift / reach});
      const Pose outside = to_scenario(*problem_->world(), pose);
      const bool is_free = task.checker->tractor_is_free(pose);
      if (is_free && !naive_hit(scenario_, outside, -allowed_depth).empty()) {
        fault("the checker accepts a pose that hits " +
              naive_hit(scenario_, outside, -allowed_depth));
      }
      if (!is_free && is_inside(outside) && naive_hit(scenario_, outside, surely_clear).empty()) {
        fault("the checker refuses a pose that is clear");
      }
    }
  }

  [[nodiscard]] bool is_inside(const Pose& pose) const {
    const Bounds& b = scenario_.bounds;
    return pose.x > b.x_min + 1e-6 && pose.x < b.x_max - 1e-6 && pose.y > b.y_min + 1e-6 &&
           pose.y < b.y_max - 1e-6;
  }

  Scenario scenario_;
  std::optional<Path> known_;  ///< the first one
  int patience_;
  Rng rng_;
  std::optional<Problem> problem_;
  TemporaryFolder folder_;
  Trial trial_;
  double bound_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
  double leeway_ = 0.0;  ///< of the path of that length
  bool proves_none_ = false;
};

Trial tried(Scenario scenario, std::uint64_t seed, int patience = 1) {
  try {
    return Judgement(std::move(scenario), seed, patience).trial();
  } catch (const std::exception& error) {
    return {{std::string("throws: ") + error.what()}, false, 0};
  }
}

}  // namespace

Trial try_world(std::uint64_t seed) { return tried(nasty_world(seed), seed); }

Trial try_world_patiently(std::uint64_t seed) {
  constexpr int patience = 25;
  return tried(nasty_world(seed), seed, patience);
}

Trial try_world_of_a_rig(std::uint64_t seed) { return tried(nasty_world_of_a_rig(seed), seed); }

Trial try_world_of_goals(std::uint64_t seed) { return tried(nasty_world_of_goals(seed), seed); }

Trial try_world_of_zones(std::uint64_t seed) { return tried(nasty_world_of_zones(seed), seed); }

Trial try_world_of_movers(std::uint64_t seed) {
  constexpr int patience = 20;  // refuges are looked for after 1500 iterations
  return tried(nasty_world_of_movers(seed), seed, patience);
}

std::string save_world(std::uint64_t seed, const std::string& folder) {
  Scenario scenario = nasty_world(seed);
  const std::string name = folder + "/nasty-" + std::to_string(seed);
  const auto write = [](const std::string& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
  };
  if (scenario.map) {
    scenario.map_file = "nasty-" + std::to_string(seed) + ".map.yaml";
    write(folder + "/" + scenario.map_file,
          map_to_yaml(*scenario.map, "nasty-" + std::to_string(seed) + ".pgm"));
    write(name + ".pgm", map_to_pgm(*scenario.map));
  }
  write(name + ".yaml", to_yaml(scenario));
  return name + ".yaml";
}

}  // namespace vandplan::nasty
