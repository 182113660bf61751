// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which knobs does a planner have?

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "vandplan/problem.h"

namespace vandplan {

/// What the vehicle drove last before it stands at the start.
enum class InitialGear { any, forward, reverse };

/// 1 forward, -1 reverse, 0 any.
[[nodiscard]] constexpr int direction_of(InitialGear gear) noexcept {
  return gear == InitialGear::forward ? 1 : gear == InitialGear::reverse ? -1 : 0;
}

/// Every knob, with its default, unit and range. A planner ignores what it has no use for.
struct PlanOptions {
  std::uint64_t seed = 1;
  std::optional<double> time_limit;             ///< wall clock [s]; >= 0; none: no limit
  std::optional<std::int64_t> max_iterations;   ///< >= 0; reproduces bit for bit; none: no limit
  std::int64_t max_nodes = 5000;                ///< of a search tree; >= 1
  Region region = Region::bounds;               ///< where samples are drawn
  double goal_bias = 0.05;                      ///< share of samples that are the goal; [0, 1]
  int max_parents = 50;                         ///< parents tried for one sample (OPT); >= 1
  bool try_goal = true;                         ///< RRT: try the goal from every new node
  double reverse_weight = 1.0;                  ///< cost of a metre in reverse; [1, 1000]
  double gear_change_cost = 0.0;                ///< cost of one gear change [m]; [0, 10000]
  InitialGear initial_gear = InitialGear::any;  ///< driven before the start; any: free choice
  int threads = 1;                              ///< that share the work; [1, 256]; same answer
  bool keep_tree = false;                       ///< return the search tree as well
  bool profile = false;                         ///< measure where the time goes (PlanResult)
  const std::atomic<bool>* stop = nullptr;      ///< the run ends soon after this becomes true
};

/// Describes one option for --set, for help and for result files.
struct OptionInfo {
  std::string_view name;                              ///< the field's name
  std::string_view summary;                           ///< meaning, unit and range
  std::string (*get)(const PlanOptions&);             ///< as JSON: a number, string, bool or null
  void (*set)(PlanOptions&, std::string_view value);  ///< throws InputError
};

/// Every option a user can set by name.
[[nodiscard]] std::span<const OptionInfo> option_table() noexcept;

/// Sets one option by name. Throws InputError naming it when there is none or the value is no good.
void set_option(PlanOptions& options, std::string_view name, std::string_view value);

/// Throws InputError naming the first option out of range.
void validate(const PlanOptions& options);

}  // namespace vandplan
