// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/plan_options.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/nearest_word.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

/// Name of a capability; empty for a number that is none. A compiler warns of a missing name.
constexpr std::string_view capability_name(Capability capability) noexcept {
  switch (capability) {
    case Capability::prices:
      return "prices";
    case Capability::time:
      return "time";
    case Capability::gears:
      return "gears";
    case Capability::steering:
      return "steering";
    case Capability::steering_of_rigs:
      return "steering_of_rigs";
    case Capability::threads:
      return "threads";
    case Capability::target_gap:
      return "target_gap";
    case Capability::primitives:
      return "primitives";
    case Capability::moving:
      return "moving";
    case Capability::trailers:
      return "trailers";
    case Capability::goal_sets:
      return "goal_sets";
    case Capability::via:
      return "via";
    case Capability::site:
      return "site";
  }
  return "";
}

constexpr std::size_t capability_count = [] {
  std::size_t count = 0;
  while (!capability_name(static_cast<Capability>(count)).empty()) ++count;
  return count;
}();

constexpr std::array<Capability, capability_count> every_capability = [] {
  std::array<Capability, capability_count> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Capability>(i);
  return all;
}();

}  // namespace

std::string_view name_of(Capability capability) noexcept { return capability_name(capability); }

std::span<const Capability> all_capabilities() noexcept { return every_capability; }

Capability capability_named(std::string_view name) {
  const auto* const found =
      std::find_if(every_capability.begin(), every_capability.end(),
                   [&](Capability capability) { return name_of(capability) == name; });
  if (found != every_capability.end()) return *found;
  const auto named = [](Capability capability) { return name_of(capability); };
  throw InputError("capabilities", "\"" + std::string(name) + "\" is unknown, " +
                                       base::expected_one_of(name, every_capability, named));
}

std::vector<std::string_view> names_of(const Capabilities& capabilities) {
  std::vector<std::string_view> names;
  for (const Capability capability : all_capabilities()) {
    if (capabilities.has(capability)) names.push_back(name_of(capability));
  }
  return names;
}

}  // namespace vandplan
