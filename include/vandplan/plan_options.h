// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which knobs does a run have?
//
// Five parts: how much work it may do, what driving costs, how far to stay away from things, how
// the vehicle steers, and the options of one planner, which its registration names (planner.h). An
// option that the chosen planner does not honour is an error, never silence.

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vandplan {

class HeuristicTable;
struct Vehicle;
namespace search {
class Primitives;
}

/// How much work a run may do, and what makes it repeat.
struct BudgetOptions {
  std::optional<double> time_limit = {};            ///< wall clock [s]; >= 0; none: no limit
  std::optional<std::int64_t> max_iterations = {};  ///< >= 0; repeats bit for bit; none: no limit
  std::uint64_t seed = 1;                           ///< of the random numbers
  int threads = 1;                                  ///< that share the work; [1, 256]; same answer
  /// The run ends as soon as its path is proven to cost at most 1 + `target_gap` times what any
  /// path does; [0, 1000]; none: it goes on for as long as it may.
  std::optional<double> target_gap = {};
  const std::atomic<bool>* stop = nullptr;  ///< the run ends soon after this becomes true
  /// With one thread: times, `time_limit` too, are processor time of that thread, so that a busy
  /// machine takes none of it.
  bool processor_time = false;
  bool operator==(const BudgetOptions&) const = default;
};

/// A run without limit of time or iterations takes this long [s].
inline constexpr double default_time_limit = 1.0;

/// What the vehicle drove last before it stands at the start.
enum class InitialGear { any, forward, reverse };

/// Which gears may be driven at all.
enum class AllowedGears : std::uint8_t {
  both,
  forward,  ///< no metre in reverse: the car of Dubins
  reverse,  ///< no metre forward
};

/// "both", "forward" or "reverse".
[[nodiscard]] std::string_view name_of(AllowedGears gears) noexcept;

/// The gears of that name. Throws InputError for another one.
[[nodiscard]] AllowedGears gears_named(std::string_view name);

/// What the cost of a path is.
enum class CostMeasure : std::uint8_t {
  prices,  ///< metres, each at its price, and what changes of gear and curvature cost [m]
  time,    ///< how long the fastest drive along it takes, as `speed_profile` finds it [s]
};

/// What driving costs. A price that is not set is that of the style in force (see `PlanOptions`).
/// `complete` sets all prices. Where the cost is the time, no price may be set.
struct CostOptions {
  std::optional<double> forward_weight = {};    ///< cost of a metre forward [m]; [1, 1000]
  std::optional<double> reverse_weight = {};    ///< cost of a metre in reverse [m]; [1, 1000]
  std::optional<double> gear_change_cost = {};  ///< cost of one gear change [m]; [0, 10000]
  /// Cost of turning the wheels [m per 1/m]; [0, 10000].
  std::optional<double> curvature_change_cost = {};
  /// A metre costs 1 + clearance_weight * max(0, 1 - clearance / clearance_distance) times as much,
  /// where the clearance is that of the body from obstacles, of the wheels from kerbs.
  std::optional<double> clearance_weight = {};    ///< [0, 1000]
  std::optional<double> clearance_distance = {};  ///< [m]; [0.01, 1000]
  InitialGear initial_gear = InitialGear::any;    ///< driven before the start; any: free choice
  CostMeasure measure = CostMeasure::prices;      ///< `time`: nothing of the above matters
  /// A metre in another gear costs infinitely much, whatever the measure is: no path has one.
  AllowedGears gears = AllowedGears::both;
  bool operator==(const CostOptions&) const = default;
};

/// What a driver minds in a truck that turns on 7 m: reversing, changing gear, turning the wheels,
/// driving close to things. `prices_of` fits it to others. Reasons: docs/algorithms/anytime.md.
inline constexpr CostOptions driver_style = {.forward_weight = 1.0,
                                             .reverse_weight = 2.0,
                                             .gear_change_cost = 5.0,
                                             .curvature_change_cost = 5.0,
                                             .clearance_weight = 2.0,
                                             .clearance_distance = 1.0};

/// The cost is the length and nothing else.
inline constexpr CostOptions shortest_style = {.forward_weight = 1.0,
                                               .reverse_weight = 1.0,
                                               .gear_change_cost = 0.0,
                                               .curvature_change_cost = 0.0,
                                               .clearance_weight = 0.0,
                                               .clearance_distance = 1.0};

/// The cost with each price that is not set taken from `others`.
[[nodiscard]] CostOptions filled(const CostOptions& cost, const CostOptions& others);

/// Whether the cost of every path is its length. False when a price is not set: `complete` says
/// what it is.
[[nodiscard]] bool is_length(const CostOptions& cost);

/// Where the curvature of a path may jump.
enum class Steering : std::uint8_t {
  reeds_shepp,               ///< anywhere: a path is made of arcs and lines
  continuous_between_stops,  ///< where the vehicle stands: at the start, the goal, gear changes
  continuous,                ///< nowhere: the wheels turn while the vehicle drives
};

/// "reeds-shepp", "continuous-between-stops" or "continuous".
[[nodiscard]] std::string_view name_of(Steering steering) noexcept;

/// The steering of that name. Throws InputError for another one.
[[nodiscard]] Steering steering_named(std::string_view name);

/// What is minimised and how the vehicle steers when no price and no steering is set.
enum class Style : std::uint8_t {
  shortest,  ///< the length; steering is `reeds_shepp`
  driver,    ///< the prices of a driver; steering is `continuous_between_stops`
};

/// "shortest" or "driver".
[[nodiscard]] std::string_view name_of(Style style) noexcept;

/// The style of that name. Throws InputError for another one.
[[nodiscard]] Style style_named(std::string_view name);

/// All prices of a style. A driver's lengths shrink with a vehicle that turns on less than 7 m.
[[nodiscard]] CostOptions prices_of(Style style, const Vehicle& vehicle);

/// How far the vehicle stays away from things.
struct ClearanceOptions {
  /// The body keeps at least this far from every obstacle, the wheels from every kerb [m]; 0 to
  /// 1000. A start or goal that is nearer counts as being in collision, unless there is a ramp.
  double margin = 0.0;
  /// Around a start or goal with a clearance c below the margin, less will do: with the rear axle d
  /// metres from it, c + (margin - c) d / margin_ramp [m]; 0 to 1000, 0: nowhere.
  double margin_ramp = 0.0;
  bool operator==(const ClearanceOptions&) const = default;
};

/// The value of an option of one planner.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;

/// Values of a planner's own options by name; what is not named has the planner's default.
class PlannerSettings {
 public:
  void set(std::string_view name, OptionValue value);
  /// The value, or null.
  [[nodiscard]] const OptionValue* find(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, OptionValue, std::less<>>& values() const noexcept {
    return values_;
  }

  /// The value of an option that is there and of this type: a planner reads its own options so.
  [[nodiscard]] bool flag(std::string_view name) const;
  [[nodiscard]] std::int64_t integer(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] const std::string& word(std::string_view name) const;

  bool operator==(const PlannerSettings&) const = default;

 private:
  std::map<std::string, OptionValue, std::less<>> values_;
};

/// Every knob of a run. What is not set is filled in by `complete` (planner.h), for every caller
/// alike.
struct PlanOptions {
  BudgetOptions budget = {};
  /// Where prices come from that `cost` does not set; none: `PlannerProperties::style`. `complete`
  /// puts prices and steering in its place.
  std::optional<Style> style = {};
  CostOptions cost = {};
  ClearanceOptions clearance = {};
  /// Where the curvature may jump; the judge holds the path to it. None: anywhere if the style is
  /// `shortest`, the cost is the length or the planner steers in no other way; else between stops.
  std::optional<Steering> steering = {};
  PlannerSettings planner = {};  ///< of the chosen planner alone
  /// What the estimate "table" looks lengths up in; for planners that an estimate guides.
  std::shared_ptr<const HeuristicTable> table = {};
  /// What joins the vertices of a lattice (primitives.h); none: what the library makes for the
  /// vehicle.
  std::shared_ptr<const search::Primitives> primitives = {};
  bool operator==(const PlanOptions&) const = default;
};

/// An option by its name, with its value as text: {"margin", "0.3"}, {"goal_bias", "0.2"}.
struct Setting {
  std::string name;
  std::string value;
  bool operator==(const Setting&) const = default;
};

/// Every option that is set, as `set_option` (planner.h) takes it; those of one planner come last.
[[nodiscard]] std::vector<Setting> settings_of(const PlanOptions& options);

/// An option of a planner: the type of its default is its type.
struct OptionInfo {
  std::string name;
  std::string summary;                  ///< meaning and unit, half a sentence
  OptionValue standard;                 ///< what it is when nobody sets it
  double least = 0.0;                   ///< of a number
  double most = 0.0;                    ///< of a number
  std::vector<std::string> words = {};  ///< that a word may be

  /// "0 to 1", "bounds or scene", "true or false".
  [[nodiscard]] std::string range() const;
};

/// An option of all planners that a user can set by name.
struct CommonOption {
  std::string_view name;                              ///< the field's name
  std::string_view summary;                           ///< meaning, unit and range
  std::string (*get)(const PlanOptions&);             ///< as JSON: a number, string or null
  void (*set)(PlanOptions&, std::string_view value);  ///< from text; throws InputError
  bool is_of_budget = false;                          ///< a field of `PlanOptions::budget`
};

/// All of them: "seed", "time_limit", "reverse_weight", ...
[[nodiscard]] std::span<const CommonOption> common_options() noexcept;

/// An option's value as JSON: a number, string or bool.
[[nodiscard]] std::string json_of(const OptionValue& value);

/// The value of an option that a text states. Throws InputError naming the option when it is of
/// another type or out of range.
[[nodiscard]] OptionValue parsed_value(const OptionInfo& info, std::string_view text);

/// A value in the type of its option: a whole number is a number, too. Throws InputError naming the
/// option when it is of another type or out of range.
[[nodiscard]] OptionValue fitting_value(const OptionInfo& info, const OptionValue& given);

/// Throws InputError naming the first option of budget, cost or clearance out of range.
void validate(const PlanOptions& options);

/// 1 forward, -1 reverse, 0 any.
[[nodiscard]] constexpr int direction_of(InitialGear gear) noexcept {
  return gear == InitialGear::forward ? 1 : gear == InitialGear::reverse ? -1 : 0;
}

}  // namespace vandplan
