// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which knobs does a run have?

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "vandplan/path.h"

namespace vandplan {

class SiteTable;

// ---- What can a planner do? ----
//
// A planner says so in its properties (planner.h). An option that needs more is refused.

/// What not every planner can do.
enum class Capability : std::uint8_t {
  prices,    ///< minimises the prices of `CostOptions`; without it the cost is the length
  time,      ///< minimises `CostMeasure::time`
  gears,     ///< keeps to `CostOptions::gears`
  steering,  ///< keeps to `PlanOptions::steering`; without it paths are those of `reeds_shepp`
  steering_of_rigs,  ///< keeps to that steering with a trailer, too
  threads,           ///< uses `BudgetOptions::threads`
  target_gap,        ///< proves lower bounds, so that `BudgetOptions::target_gap` ends a run
  primitives,        ///< uses `PlanOptions::primitives`
  moving,            ///< avoids `Task::moving`; answers then have speeds, too
  trailers,          ///< plans for vehicles with a trailer
  goal_sets,         ///< takes `Task::goal_set`; without it `plan` gives it single goals in turn
  via,   ///< takes `Task::via` and `GoalRegion::straight`; without it `plan` gives it legs
  site,  ///< uses `PlanOptions::site`
};

/// Name of the capability: "prices", "steering_of_rigs", ...
[[nodiscard]] std::string_view name_of(Capability capability) noexcept;
/// The capability of that name. Throws InputError naming "capabilities" for another name.
[[nodiscard]] Capability capability_named(std::string_view name);
/// All capabilities, in the order of the enumeration.
[[nodiscard]] std::span<const Capability> all_capabilities() noexcept;

/// A set of capabilities.
class Capabilities {
 public:
  constexpr Capabilities() noexcept = default;
  constexpr Capabilities(std::initializer_list<Capability> members) noexcept {
    for (const Capability member : members) add(member);
  }

  [[nodiscard]] constexpr bool has(Capability capability) const noexcept {
    return (bits_ & bit_of(capability)) != 0;
  }
  constexpr void add(Capability capability) noexcept { bits_ |= bit_of(capability); }
  constexpr void remove(Capability capability) noexcept { bits_ &= ~bit_of(capability); }
  constexpr bool operator==(const Capabilities&) const noexcept = default;

 private:
  static constexpr std::uint32_t bit_of(Capability capability) noexcept {
    return std::uint32_t{1} << static_cast<std::uint32_t>(capability);
  }

  std::uint32_t bits_ = 0;
};

/// Names of the members of a set, in the order of the enumeration.
[[nodiscard]] std::vector<std::string_view> names_of(const Capabilities& capabilities);

// ---- What may a caller choose? ----
//
// Five parts: how much work it may do, what driving costs, how far to stay away from obstacles, how
// the vehicle steers, and the options of one planner, which its registration names (planner.h). An
// option that the chosen planner does not honour is an error.

class HeuristicTable;
struct Vehicle;
namespace search {
class Primitives;
}

/// How much work a run may do, and what makes it repeat.
struct BudgetOptions {
  std::optional<double> time_limit = {};            ///< wall-clock time [s]; >= 0; none: no limit
  std::optional<std::int64_t> max_iterations = {};  ///< >= 0; repeats bit for bit; none: no limit
  std::uint64_t seed = 1;                           ///< seed of the random numbers
  int threads = 1;  ///< threads that share the work, with equal results; [1, 256]
  /// The run ends when its path is proven to cost at most 1 + `target_gap` times the optimum;
  /// [0, 1000]. None: it ends when the budget is spent.
  std::optional<double> target_gap = {};
  std::stop_token stop = {};  ///< the run ends soon after this is asked to stop
  /// Whether times, `time_limit` too, are processor time of the run's only thread: a busy machine
  /// then takes none of it. Ignored with several threads.
  bool processor_time = false;
  bool operator==(const BudgetOptions&) const = default;
};

/// Time of a run without a limit of time or iterations [s].
inline constexpr double default_time_limit = 1.0;

/// Gear that the vehicle drove before it came to the start.
enum class InitialGear { any, forward, reverse };

/// Name of the gears: "both", "forward" or "reverse".
[[nodiscard]] std::string_view name_of(AllowedGears gears) noexcept;
/// The gears of that name. Throws InputError naming "gears" for another name.
[[nodiscard]] AllowedGears gears_named(std::string_view name);

/// Kind of the cost of a path.
enum class CostMeasure : std::uint8_t {
  prices,  ///< metres at their prices, plus gear and curvature changes [m]
  time,    ///< time of the fastest drive, as `speed_profile` finds it [s]
};

/// Prices of driving. A price that is not set is that of the style in force (see `PlanOptions`);
/// `complete` sets all prices. Where the cost is the time, no price may be set.
struct CostOptions {
  std::optional<double> forward_weight = {};    ///< cost of a metre forward [m]; [1, 1000]
  std::optional<double> reverse_weight = {};    ///< cost of a metre in reverse [m]; [1, 1000]
  std::optional<double> gear_change_cost = {};  ///< cost of one gear change [m]; [0, 10000]
  /// Cost per change of curvature, for turning the wheels [m per 1/m]; [0, 10000].
  std::optional<double> curvature_change_cost = {};
  /// Surcharge near obstacles; [0, 1000]. A metre costs 1 + clearance_weight * max(0,
  /// 1 - clearance / clearance_distance) times as much. The clearance is the body's from obstacles,
  /// the wheels' from kerbs.
  std::optional<double> clearance_weight = {};
  std::optional<double> clearance_distance = {};  ///< distance that is near [m]; [0.01, 1000]
  InitialGear initial_gear = InitialGear::any;  ///< gear before the start; any: first gear is free
  CostMeasure measure = CostMeasure::prices;    ///< with `time` none of the prices counts
  AllowedGears gears = AllowedGears::both;      ///< gears that a path may use, whatever the measure
  bool operator==(const CostOptions&) const = default;
};

/// Prices of a driver of a truck that turns on 7 m, who avoids reversing, gear changes, turning the
/// wheels and closeness to obstacles. `prices_of` scales them for other vehicles. Reasons:
/// docs/algorithms/anytime.md.
inline constexpr CostOptions driver_style = {.forward_weight = 1.0,
                                             .reverse_weight = 2.0,
                                             .gear_change_cost = 5.0,
                                             .curvature_change_cost = 5.0,
                                             .clearance_weight = 2.0,
                                             .clearance_distance = 1.0};

/// Prices under which the cost is the length.
inline constexpr CostOptions shortest_style = {.forward_weight = 1.0,
                                               .reverse_weight = 1.0,
                                               .gear_change_cost = 0.0,
                                               .curvature_change_cost = 0.0,
                                               .clearance_weight = 0.0,
                                               .clearance_distance = 1.0};

/// The cost options, with each price that is not set taken from `others`.
[[nodiscard]] CostOptions filled(const CostOptions& cost, const CostOptions& others);
/// Whether the cost of every path is its length; false while a price is not set (see `complete`).
[[nodiscard]] bool is_length(const CostOptions& cost);

/// Places where the curvature of a path may jump.
enum class Steering : std::uint8_t {
  reeds_shepp,               ///< anywhere: a path is made of arcs and lines
  continuous_between_stops,  ///< where the vehicle stands: start, goal, gear changes
  continuous,                ///< nowhere: the wheels turn while the vehicle drives
};

/// Name of the steering: "reeds-shepp", "continuous-between-stops" or "continuous".
[[nodiscard]] std::string_view name_of(Steering steering) noexcept;
/// The steering of that name. Throws InputError naming "steering" for another name.
[[nodiscard]] Steering steering_named(std::string_view name);

/// Prices and steering that hold when none is set.
enum class Style : std::uint8_t {
  shortest,  ///< the cost is the length, the steering `reeds_shepp`
  driver,    ///< prices of a driver, steering `continuous_between_stops`
};

/// Name of the style: "shortest" or "driver".
[[nodiscard]] std::string_view name_of(Style style) noexcept;
/// The style of that name. Throws InputError naming "style" for another name.
[[nodiscard]] Style style_named(std::string_view name);

/// All prices of a style. For a vehicle that turns on r < 7 m, a driver's gear change and clearance
/// distance are those of `driver_style` times r/7; its curvature change is that times (r/7)^2.
[[nodiscard]] CostOptions prices_of(Style style, const Vehicle& vehicle);

/// Distance that the vehicle keeps from obstacles and kerbs.
struct ClearanceOptions {
  /// Least distance of the body from obstacles, moving ones too, and of the wheels from kerbs [m];
  /// [0, 1000]. A nearer start or goal counts as being in collision, unless there is a ramp. One at
  /// the margin, or up to 1 mm beyond it, may count so, too, even with a ramp.
  double margin = 0.0;
  /// Length of the ramp around a start or goal with a clearance c below the margin [m]; [0, 1000];
  /// 0: no ramp. With the rear axle d metres away, c + (margin - c) d / margin_ramp is enough, but
  /// not for moving obstacles.
  double margin_ramp = 0.0;
  bool operator==(const ClearanceOptions&) const = default;
};

/// Value of an option of one planner.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

/// Values of a planner's own options by name. An option without a value has the planner's default.
class PlannerSettings {
 public:
  void set(std::string_view name, OptionValue value);
  /// The value of that option; null if it has none.
  [[nodiscard]] const OptionValue* find(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, OptionValue, std::less<>>& values() const noexcept {
    return values_;
  }

  /// The value of an option by which a planner reads its own options. Throws InputError naming the
  /// option if it has no value or one of another type.
  [[nodiscard]] bool flag(std::string_view name) const;
  [[nodiscard]] std::int64_t integer(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] const std::string& word(std::string_view name) const;

  bool operator==(const PlannerSettings&) const = default;

 private:
  std::map<std::string, OptionValue, std::less<>> values_;
};

/// All options of a run. `complete` (planner.h) fills in what is not set, for every caller alike.
struct PlanOptions {
  BudgetOptions budget = {};
  /// Style of prices that `cost` does not set, which `complete` replaces. None: the planner's.
  std::optional<Style> style = {};
  CostOptions cost = {};
  ClearanceOptions clearance = {};
  /// Places where the curvature may jump; the judge holds the path to them. None: `reeds_shepp` if
  /// the planner steers in no other way, and with a trailer unless the cost is the time. Otherwise
  /// `PlannerProperties::steering`. Without that it is `reeds_shepp` if the style is `shortest` or
  /// the cost is the length, and `continuous_between_stops` in all other cases.
  std::optional<Steering> steering = {};
  PlannerSettings planner = {};  ///< options of the chosen planner
  /// Table of lengths for the estimate "table", for planners that an estimate guides.
  std::shared_ptr<const HeuristicTable> table = {};
  /// Primitives that join the vertices of a lattice (graphs.h). None: made for the vehicle.
  std::shared_ptr<const search::Primitives> primitives = {};
  /// Table of the site (site_table.h). The default planner begins with its way, and the estimate
  /// "site" looks up its costs. None: no planner knows the site.
  std::shared_ptr<const SiteTable> site = {};
  bool operator==(const PlanOptions&) const = default;
};

/// An option by its name, with its value as text: {"margin", "0.3"}, {"goal_bias", "0.2"}.
struct Setting {
  std::string name;
  std::string value;
  bool operator==(const Setting&) const = default;
};

/// Options of all planners that have a value, set or default, and last a planner's own. Style,
/// tables and primitives are left out. `set_honoured` (planner.h) takes them; `set_option` throws
/// for one that the planner does not honour.
[[nodiscard]] std::vector<Setting> settings_of(const PlanOptions& options);

/// An option of one planner. The type of `default_value` is the type of its values.
struct OptionInfo {
  std::string name;
  std::string summary;                  ///< meaning and unit, half a sentence
  OptionValue default_value;            ///< default value
  double least = 0.0;                   ///< smallest value of a number
  double most = 0.0;                    ///< largest value of a number
  std::vector<std::string> words = {};  ///< values that a word may have

  /// The range as text: "0 to 1", "bounds or scene", "true or false".
  [[nodiscard]] std::string range() const;
};

/// Part of the options to which an option belongs.
enum class OptionPart : std::uint8_t {
  style,      ///< `PlanOptions::style`
  measure,    ///< `CostOptions::measure`
  prices,     ///< prices of `CostOptions`
  gears,      ///< gears of `CostOptions`
  steering,   ///< `PlanOptions::steering`
  clearance,  ///< `PlanOptions::clearance`
  budget,     ///< `PlanOptions::budget`
};

/// An option that a user can set by name, whatever the planner: a row of the table of options.
/// Command line, files, Python and reports know these options from the table alone.
struct CommonOption {
  /// Largest value of a number without a limit.
  static constexpr double no_limit = std::numeric_limits<double>::max();

  std::string_view name;       ///< name by which a user sets the option
  std::string_view summary;    ///< meaning, half a sentence
  std::string_view unit = {};  ///< unit of a number; or empty
  double least = 0.0;          ///< smallest value of a number
  double most = no_limit;      ///< largest value of a number
  /// What the planner must be able to do, unless the value has no effect. None: nothing.
  std::optional<Capability> needs = {};
  OptionPart part = OptionPart::budget;          ///< part of the options
  std::span<const std::string_view> words = {};  ///< values that a word may have
  bool is_whole = false;                         ///< whether numbers are whole
  bool is_optional = false;                      ///< whether it may be unset: "null"

  std::string (*get)(const PlanOptions&) = nullptr;  ///< value as JSON: a number, string or null
  /// Sets the option from text. Throws InputError without a name for a text of another type.
  void (*set)(PlanOptions&, std::string_view text) = nullptr;
  /// Value as a number; none if it is a word or not set.
  std::optional<double> (*number)(const PlanOptions&) = nullptr;
  /// Whether both have equal values.
  bool (*equal)(const PlanOptions&, const PlanOptions&) = nullptr;
  void (*copy)(PlanOptions& to, const PlanOptions& from) = nullptr;  ///< copies the value

  /// The range as text: "0 to 1000", ">= 0 or null", "prices or time".
  [[nodiscard]] std::string range() const;
  /// Meaning, unit and range: "number of threads; 1 to 256".
  [[nodiscard]] std::string text() const;
};

/// The options that every run has: "seed", "time_limit", "reverse_weight", ...
[[nodiscard]] std::span<const CommonOption> common_options() noexcept;

/// The whole table: "style", which `complete` replaces, and the common options.
[[nodiscard]] std::span<const CommonOption> style_and_common_options() noexcept;

/// The row of that name, "style" too; null if there is none.
[[nodiscard]] const CommonOption* find_common_option(std::string_view name) noexcept;

/// Value of an option as JSON: a number, string or bool.
[[nodiscard]] std::string json_of(const OptionValue& value);
/// Value of an option from text. Throws InputError naming the option when the text has another type
/// or is out of range.
[[nodiscard]] OptionValue parsed_value(const OptionInfo& info, std::string_view text);
/// The value in the type of its option: a whole number becomes a number where one is wanted. Throws
/// InputError naming the option when the value has another type or is out of range.
[[nodiscard]] OptionValue fitting_value(const OptionInfo& info, const OptionValue& given);

/// Checks all numbers of budget, cost and clearance. Throws InputError naming the first option out
/// of range.
void validate(const PlanOptions& options);

/// Direction of travel: 1 forward, -1 reverse, 0 any.
[[nodiscard]] constexpr int direction_of(InitialGear gear) noexcept {
  return gear == InitialGear::forward ? 1 : gear == InitialGear::reverse ? -1 : 0;
}

}  // namespace vandplan
