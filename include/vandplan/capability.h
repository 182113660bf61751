// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What can a planner do?
//
// A planner says so in its properties (planner.h). An option that needs more is refused.

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace vandplan {

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

}  // namespace vandplan
