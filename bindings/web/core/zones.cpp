// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "bindings/web/core/zones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "vandplan/input_error.h"
#include "vandplan/plan_options.h"

namespace vandplan::web {
namespace {

/// A whole number from 1 to `most`.
std::int32_t count_at(const val& object, const char* key, const std::string& where, double most) {
  const double count = number_at(object, key, where);
  if (!(count >= 1 && count <= most && count == std::floor(count))) {
    throw InputError(where + "." + key, "expected a whole number from 1");
  }
  return static_cast<std::int32_t>(count);
}

Zone zone_from(const val& given, const std::string& where) {
  allow_only(given, {"name", "area", "closed", "gears", "direction", "cost", "max_speed", "body"},
             where);
  const auto flag = [&](const char* key) {
    if (!has(given, key)) return false;
    if (!given[key].isTrue() && !given[key].isFalse()) {
      throw InputError(key_of(where, key), "expected true or false");
    }
    return given[key].isTrue();
  };
  Zone zone{.area = polygon_from(given["area"], key_of(where, "area")),
            .closed = flag("closed"),
            .cost = number_at(given, "cost", where, 1.0),
            .body = flag("body")};
  if (has(given, "name")) zone.name = given["name"].as<std::string>();
  if (has(given, "max_speed")) zone.max_speed = number_at(given, "max_speed", where);
  if (has(given, "gears")) zone.gears = gears_named(given["gears"].as<std::string>());
  if (has(given, "direction")) {
    const Point ends = point_from(given["direction"], key_of(where, "direction"));
    zone.direction = HeadingRange{ends.x, ends.y};
  }
  return zone;
}

std::string word_at(const val& object, const char* key, const std::string& where) {
  if (!has(object, key) || !object[key].isString()) {
    throw InputError(key_of(where, key), "expected a word");
  }
  return object[key].as<std::string>();
}

/// A mask with the keys `as` and `of` of scenario files.
Mask mask_named(const val& given, const std::string& where) {
  allow_only(given, {"map", "percents", "as", "of"}, where);
  const std::string use = word_at(given, "as", where);
  if (use == name_of(MaskUse::obstacles)) return {};
  if (use == name_of(MaskUse::max_speed)) return speed_mask({}, number_at(given, "of", where));
  if (use == name_of(MaskUse::cost)) return cost_mask({}, number_at(given, "of", where));
  throw InputError(key_of(where, "as"), "expected obstacles, max_speed or cost");
}

/// A mask with the keys of Nav2's costmap filters: 0 is keepout, 1 a speed in percent of `fastest`,
/// 2 one in m/s.
Mask mask_of_nav2(const val& given, const std::string& where, double fastest) {
  allow_only(given, {"map", "percents", "type", "base", "multiplier"}, where);
  const double kind = number_at(given, "type", where);
  if (kind != 0 && kind != 1 && kind != 2) {
    throw InputError(key_of(where, "type"), "expected 0 (keepout), 1 (speed in %) or 2 (in m/s)");
  }
  const double base = number_at(given, "base", where, 0.0);
  const double multiplier = number_at(given, "multiplier", where, 1.0);
  if (kind == 0) return {};
  const double unit = kind == 1 ? fastest / 100 : 1.0;
  return {.use = MaskUse::max_speed, .base = unit * base, .multiplier = unit * multiplier};
}

}  // namespace

OccupancyGrid map_from(const val& given, const std::string& where) {
  allow_only(given, {"origin", "resolution", "columns", "rows", "cells", "unknown"}, where);
  OccupancyGrid map{
      .origin = pose_from(given["origin"], key_of(where, "origin")),
      .resolution = number_at(given, "resolution", where),
      .columns = count_at(given, "columns", where, 1e6),
      .rows = count_at(given, "rows", where, 1e6),
      .unknown_is_free = has(given, "unknown") && given["unknown"].as<std::string>() == "free"};
  const std::int64_t size = std::int64_t{map.columns} * map.rows;
  // Fits into 32 bits of memory, together with its world.
  constexpr std::int64_t most = 100'000'000;
  if (size > most) throw InputError(key_of(where, "cells"), "are more than 100 million");
  const auto numbers = emscripten::convertJSArrayToNumberVector<std::uint8_t>(given["cells"]);
  if (static_cast<std::int64_t>(numbers.size()) != size) {
    throw InputError(key_of(where, "cells"), "expected columns * rows of them");
  }
  std::vector<Cell> cells(numbers.size());
  std::ranges::transform(numbers, cells.begin(), [](std::uint8_t number) {
    return number == 0 ? Cell::free : number == 1 ? Cell::occupied : Cell::unknown;
  });
  map.cells = std::move(cells);
  try {
    check_map(map);
  } catch (const InputError& error) {  // Keys of the error begin with "map".
    throw InputError(where + error.where().substr(3), error.problem());
  }
  return map;
}

std::vector<Zone> zones_at(const val& object) {
  std::vector<Zone> zones;
  if (!has(object, "zones")) return zones;
  const val list = object["zones"];
  const std::size_t count = size_of(list, "zones");
  for (std::size_t i = 0; i < count; ++i) {
    zones.push_back(zone_from(list[i], "zones[" + std::to_string(i) + "]"));
  }
  return zones;
}

std::vector<Mask> masks_at(const val& object, double fastest) {
  std::vector<Mask> masks;
  if (!has(object, "masks")) return masks;
  const val list = object["masks"];
  const std::size_t count = size_of(list, "masks");
  masks.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string where = "masks[" + std::to_string(i) + "]";
    const val given = list[i];
    const bool is_of_nav2 = has(given, "type");
    Mask mask = is_of_nav2 ? mask_of_nav2(given, where, fastest) : mask_named(given, where);
    mask.map = map_from(given["map"], key_of(where, "map"));
    if (has(given, "percents")) {
      mask.percents = std::make_shared<const std::vector<std::uint8_t>>(
          emscripten::convertJSArrayToNumberVector<std::uint8_t>(given["percents"]));
    }
    masks.push_back(std::move(mask));
  }
  return masks;
}

}  // namespace vandplan::web
