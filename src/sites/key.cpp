// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/key.h"

#include <bit>
#include <cmath>
#include <memory>
#include <string>
#include <typeinfo>

#include "base/bytes.h"
#include "base/hash.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan::sites {
namespace {

/// Sum of numbers, one after the other.
class Fingerprint {
 public:
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::uint64_t number) {
    bytes_.clear();
    base::append(bytes_, number);
    hash_ = base::hash_of(bytes_, hash_);
  }
  void add(std::size_t number, const Polygon& polygon, const Point& origin) {
    add(std::uint64_t{number});
    for (const Point& corner : polygon) {
      add_length(corner.x + origin.x);
      add_length(corner.y + origin.y);
    }
  }
  void add(const std::vector<Polygon>& polygons, const Point& origin) {
    add(std::uint64_t{polygons.size()});
    for (const Polygon& polygon : polygons) add(polygon.size(), polygon, origin);
  }
  void add(const OccupancyGrid& map, const Point& origin) {
    add_length(map.origin.x + origin.x);
    add_length(map.origin.y + origin.y);
    add(map.origin.heading);
    add(map.resolution);
    add(static_cast<std::uint64_t>(map.columns));
    add(std::uint64_t{map.unknown_is_free});
    std::string cells;
    cells.reserve(map.cells->size());
    for (const Cell cell : *map.cells) cells.push_back(static_cast<char>(cell));
    add(base::hash_of(cells));
  }
  /// Adds what a path must keep to in a zone, and what it costs there.
  void add(const Zone& zone, const Point& origin) {
    add(zone.area.size(), zone.area, origin);
    add(std::uint64_t{zone.closed});
    add(static_cast<std::uint64_t>(zone.gears));
    const HeadingRange direction = zone.direction.value_or(HeadingRange{0.0, -1.0});
    add(direction.from);
    add(direction.to);
    add(zone.cost);
    add(std::uint64_t{zone.body});
  }
  void add(const Mask& mask, const Point& origin) {
    add(mask.map, origin);
    add(static_cast<std::uint64_t>(mask.use));
    add(mask.base);
    add(mask.multiplier);
    if (!mask.percents) return;
    add(base::hash_of(std::string(mask.percents->begin(), mask.percents->end())));
  }
  /// Adds a coordinate: rounded, because worlds with other origins round it otherwise.
  void add_length(double metres) {
    constexpr double per_metre = 1e6;
    add(static_cast<std::uint64_t>(std::llround(per_metre * metres)));
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return hash_; }

 private:
  std::string bytes_;
  std::uint64_t hash_ = base::empty_hash;
};

std::uint64_t fingerprint_of(const World& world) {
  const Surroundings ground = world.without_fences();
  const Point& origin = world.origin();
  Fingerprint sum;
  sum.add_length(ground.bounds.x_min + origin.x);
  sum.add_length(ground.bounds.x_max + origin.x);
  sum.add_length(ground.bounds.y_min + origin.y);
  sum.add_length(ground.bounds.y_max + origin.y);
  sum.add(ground.obstacles, origin);
  sum.add(ground.kerbs, origin);
  sum.add(ground.inside, origin);
  sum.add(std::uint64_t{ground.map.has_value()});
  if (ground.map) sum.add(*ground.map, origin);
  for (const Zone& zone : ground.zones) sum.add(zone, origin);
  for (const Mask& mask : ground.masks) {
    if (mask.use != MaskUse::max_speed) sum.add(mask, origin);
  }
  return sum.value();
}

std::uint64_t fingerprint_of(const Vehicle& vehicle) {
  Fingerprint sum;
  for (const double number :
       {vehicle.wheelbase, vehicle.front_overhang, vehicle.rear_overhang, vehicle.width,
        vehicle.min_turning_radius, vehicle.track_width.value_or(vehicle.width)}) {
    sum.add(number);
  }
  sum.add(vehicle.outline.size(), vehicle.outline, {});
  sum.add(std::uint64_t{0});  // a trailer does not count
  return sum.value();
}

std::uint64_t fingerprint_of(const PlanOptions& options) {
  const search::CostRule rule = search::cost_rule(options.cost);
  Fingerprint sum;
  for (const double number :
       {rule.forward_weight, rule.reverse_weight, rule.gear_change_cost, rule.curvature_change_cost,
        rule.clearance_weight, rule.clearance_distance, options.clearance.margin,
        options.clearance.margin_ramp}) {
    sum.add(number);
  }
  sum.add(std::uint64_t{options.cost.measure != CostMeasure::prices});
  return sum.value();
}

}  // namespace

SiteKey site_key(const World& world, const Vehicle& vehicle, const PlanOptions& options) {
  // The world keeps its own: a map has millions of cells.
  struct Kept {
    std::uint64_t value;
  };
  const auto kept = world.kept(typeid(Kept), [&world]() -> std::shared_ptr<const void> {
    return std::make_shared<const Kept>(Kept{fingerprint_of(world)});
  });
  return {static_cast<const Kept*>(kept.get())->value, fingerprint_of(vehicle),
          fingerprint_of(options)};
}

void expect_equal(const SiteKey& made_for, const SiteKey& wanted) {
  const auto refuse = [](const char* what) {
    throw InputError("site", std::string("the table was made for ") + what);
  };
  if (made_for.world != wanted.world)
    refuse("another world: bounds, obstacles, maps or zones differ");
  if (made_for.vehicle != wanted.vehicle) refuse("another vehicle: its body or radius differs");
  if (made_for.prices != wanted.prices)
    refuse("other options: prices (style), gears or margin differ");
}

}  // namespace vandplan::sites
