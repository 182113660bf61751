// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/contacts.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>

#include "judge/along.h"
#include "judge/ground.h"
#include "judge/text.h"

namespace vandplan::judge {
namespace {

constexpr double margin_slack = 1e-6;  // tolerance of the margin [m]
// Tolerance of ramps [m]. A vehicle parallel to a kerb moves away with the square of its driven
// distance, but a ramp grows linearly. Without slack, not even a long ramp would let the vehicle
// leave.
constexpr double ramp_slack = 1e-3;

/// Whether the name of a part is plural: "the wheels", but "the footprint".
bool is_of_many(std::string_view part) { return part.ends_with('s'); }

/// First place along the path where a body is nearer than allowed.
struct Touch {
  const Body* body = nullptr;
  Place place = {};
};

/// First touch of any body. Lowers `least` to the least clearance of all bodies [m].
std::optional<Touch> first_touch(const Bodies& bodies, const Keeping& keeping, double& least) {
  std::optional<Touch> first;
  for (const Body& body : bodies) {
    const Nearest nearest = nearest_along(body, keeping);
    least = std::min(least, nearest.clearance);
    if (!nearest.touch) continue;
    const auto [stretch, t] = *nearest.touch;
    if (first && std::tie(first->place.stretch, first->place.t) <= std::tie(stretch, t)) continue;
    first = {&body, *nearest.touch};
  }
  return first;
}

/// Least clearance of all bodies at a place [m], cut off at `most`.
double clearance_at(const Bodies& bodies, const Place& place, double most) {
  Effort effort;
  double least = most;
  for (const Body& body : bodies) least = clearance_of(body, place, least, effort);
  return least;
}

/// Distances to be kept; with ramps they are less around ends that are nearer than the margin.
Keeping keeping_of(const Track& track, const Bodies& bodies, const ClearanceOptions& stated) {
  Keeping keeping{stated.margin - margin_slack, {}};
  if (!(stated.margin_ramp > 0)) return keeping;
  for (const Place& end : {Place{0, 0}, end_of(track)}) {
    const double clearance = clearance_at(bodies, end, stated.margin);
    if (clearance >= stated.margin) continue;
    keeping.ramps.push_back(
        {after(track.stretches[end.stretch], end.t), clearance - ramp_slack, stated.margin_ramp});
  }
  return keeping;
}

}  // namespace

std::optional<Fault> first_collision(const Bodies& bodies, double& least) {
  const std::optional<Touch> touch = first_touch(bodies, {}, least);
  if (!touch) return std::nullopt;
  const auto [name, part, hit] = first_within(*touch->body, 0, touch->place);
  return Fault{text("%s %s %s", part.c_str(), is_of_many(part) ? "hit" : "hits", name.c_str()),
               touch->place, hit};
}

std::optional<Fault> too_near(const Track& track, const Bodies& bodies,
                              const ClearanceOptions& stated) {
  const Keeping keeping = keeping_of(track, bodies, stated);
  double least = std::numeric_limits<double>::infinity();
  const std::optional<Touch> touch = first_touch(bodies, keeping, least);
  if (!touch) return std::nullopt;
  const auto& [body, place] = *touch;
  Effort effort;
  const double clearance = clearance_of(*body, place, stated.margin, effort);
  const auto [name, part, hit] = first_within(*body, clearance, place);
  const char* const verb = is_of_many(part) ? "are" : "is";
  const double kept = keeping.most_within(after(track.stretches[place.stretch], place.t), 0);
  if (kept == keeping.margin) {
    return Fault{text("%s %s only %.3f m from %s, the margin is %g m", part.c_str(), verb,
                      clearance, name.c_str(), stated.margin),
                 place, hit};
  }
  return Fault{text("%s %s only %.3f m from %s, the ramp of the margin asks for %.3f m",
                    part.c_str(), verb, clearance, name.c_str(), kept),
               place, hit};
}

}  // namespace vandplan::judge
