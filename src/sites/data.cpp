// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/bytes.h"
#include "base/hash.h"
#include "vandplan/input_error.h"

namespace vandplan::sites {
namespace {

using base::append, base::read_at;

constexpr std::string_view magic = "vp-site ";
constexpr std::uint32_t version = 2;
// Places in the head.
constexpr std::size_t version_at = 8;
constexpr std::size_t headings_at = 12;
constexpr std::size_t key_at = 16;
constexpr std::size_t grid_at = 40;
constexpr std::size_t shape_at = 72;
constexpr std::size_t goals_at = 80;
constexpr std::size_t checksum_at = 88;
constexpr std::size_t head_size = 96;
constexpr std::size_t goal_size = 48;
constexpr std::uint64_t most_goals = 1'000'000;

constexpr std::size_t word_size = 12;  // 64 bits and the number of bits set before them
constexpr std::size_t pair_size = 6;   // costs and steps of both gears
/// Length of a straight step [cells]; long enough to leave its cell.
constexpr double straight_cells = 1.5;
constexpr std::uint16_t unreached = 0xFFFF;
constexpr std::uint8_t step_at_goal = 255;

std::uint64_t size_of(const SiteGrid& grid, const SiteLayer& layer) {
  return words_of(grid) * word_size + layer.count * pair_size;
}

constexpr int arcs = 2 * arcs_of_site + 1;
/// A step leads so many cells more at most than `SiteLayer::reach`, which is a little less than it
/// could be: the field computes places in single precision.
constexpr int cells_more = 3;
constexpr double slack = 1e-3;  // [cells]
static_assert(cells_more * cells_more * arcs * 3 <= step_at_goal);

std::size_t reach_at(int heading, int gear, int arc) {
  return static_cast<std::size_t>((heading * 2 + (gear < 0 ? 1 : 0)) * arcs + arc + arcs_of_site);
}

std::vector<std::array<std::int32_t, 2>> reach_of(const SiteGrid& grid, const Pose& goal) {
  std::vector<std::array<std::int32_t, 2>> reach(
      static_cast<std::size_t>(grid.headings * 2 * arcs));
  for (int heading = 0; heading < grid.headings; ++heading) {
    const Pose from{0.0, 0.0, goal.heading + heading * 2 * std::numbers::pi / grid.headings};
    for (const int gear : {1, -1}) {
      for (int arc = -arcs_of_site; arc <= arcs_of_site; ++arc) {
        const Pose to = advance(from, site_step(grid, gear, arc));
        reach[reach_at(heading, gear, arc)] = {
            static_cast<std::int32_t>(std::floor(to.x / grid.cell - slack)),
            static_cast<std::int32_t>(std::floor(to.y / grid.cell - slack))};
      }
    }
  }
  return reach;
}

/// Code of the step of a record.
std::uint8_t code_of(const SiteGrid& grid, const SiteLayer& layer, const SiteRecord& record) {
  const SiteEntry& entry = record.entry;
  if (entry.is_goal) return step_at_goal;
  const auto heading = static_cast<int>(record.pair % static_cast<std::uint64_t>(grid.headings));
  const auto [columns, rows] = layer.reach[reach_at(heading, record.gear, entry.arc)];
  const int cells = (entry.rows - rows) * cells_more + entry.columns - columns;
  return static_cast<std::uint8_t>((cells * arcs + entry.arc + arcs_of_site) * 3 + entry.next_gear +
                                   1);
}

SiteEntry entry_of(std::uint8_t code, const SiteLayer& layer, const SiteState& state) {
  SiteEntry entry;
  entry.is_goal = code == step_at_goal;
  if (entry.is_goal) return entry;
  const int cells = code / (3 * arcs);
  entry.next_gear = code % 3 - 1;
  entry.arc = code / 3 % arcs - arcs_of_site;
  const auto [columns, rows] = layer.reach[reach_at(state.heading, state.gear, entry.arc)];
  entry.columns = columns + cells % cells_more;
  entry.rows = rows + cells / cells_more;
  return entry;
}

/// The least power of two in which the largest cost fits. So the unit seldom depends on it, and
/// equal costs have equal numbers.
double unit_of(double largest) {
  int exponent = 0;
  (void)std::frexp(std::max(largest, 1.0) / most_units, &exponent);
  return std::ldexp(1.0, exponent);
}

/// Appends the numbers of the pairs of a word. Returns the word: a bit for each pair.
std::uint64_t append_pairs(const SiteGrid& grid, const SiteLayer& layer,
                           const std::vector<SiteRecord>& records, std::string& pairs) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < records.size();) {
    const std::uint64_t pair = records[i].pair;
    word |= std::uint64_t{1} << pair % pairs_of_word;
    std::uint16_t costs[2] = {unreached, unreached};
    std::uint8_t steps[2] = {0, 0};
    for (; i < records.size() && records[i].pair == pair; ++i) {
      const std::size_t gear = records[i].gear > 0 ? 0 : 1;
      costs[gear] = static_cast<std::uint16_t>(std::lround(records[i].entry.cost / layer.unit));
      steps[gear] = code_of(grid, layer, records[i]);
    }
    append(pairs, std::uint32_t{costs[1]} << 16 | costs[0]);
    append(pairs, static_cast<std::uint16_t>(steps[1] << 8 | steps[0]));
  }
  return word;
}

void append_double(std::string& bytes, double number) {
  append(bytes, std::bit_cast<std::uint64_t>(number));
}

double double_at(std::string_view bytes, std::size_t at) {
  return std::bit_cast<double>(read_at<std::uint64_t>(bytes, at));
}

/// Checksum of all but the checksum. Words make it eight times as fast as bytes.
std::uint64_t checksum_of(std::string_view bytes) {
  std::uint64_t sum = base::hash_of(bytes.substr(0, checksum_at));
  std::size_t at = head_size;
  for (; at + 8 <= bytes.size(); at += 8) {
    sum = (sum ^ read_at<std::uint64_t>(bytes, at)) * base::hash_prime;
  }
  return base::hash_of(bytes.substr(at), sum);
}

SiteGrid grid_in(std::string_view bytes, const std::string& file) {
  const auto count_at = [&](std::size_t at) {
    const auto count = read_at<std::uint32_t>(bytes, at);
    return static_cast<std::int32_t>(std::min<std::uint32_t>(count, 1U << 30));
  };
  SiteGrid grid{.corner = {double_at(bytes, grid_at), double_at(bytes, grid_at + 8)},
                .cell = double_at(bytes, grid_at + 16),
                .radius = double_at(bytes, grid_at + 24),
                .columns = count_at(shape_at),
                .rows = count_at(shape_at + 4),
                .headings = count_at(headings_at)};
  const auto is_length = [](double x) { return x >= 1e-6 && x <= 1e6; };
  constexpr std::int32_t most = 100'000;
  const bool is_good = std::isfinite(grid.corner.x) && std::isfinite(grid.corner.y) &&
                       is_length(grid.cell) && is_length(grid.radius) && grid.columns >= 1 &&
                       grid.columns <= most && grid.rows >= 1 && grid.rows <= most &&
                       grid.headings >= 1 && grid.headings <= 1000;
  if (!is_good) throw InputError(file, "its grid is not one, expected a table of a site");
  return grid;
}

void check_head(std::string_view bytes, const std::string& file) {
  const auto refuse = [&file](const std::string& problem) { throw InputError(file, problem); };
  if (!bytes.starts_with(magic)) {
    refuse("not a table of a site: does not start with '" + std::string(magic) + "'");
  }
  if (bytes.size() < head_size) {
    refuse("truncated: " + std::to_string(bytes.size()) + " bytes, the head alone has " +
           std::to_string(head_size));
  }
  if (const auto found = read_at<std::uint32_t>(bytes, version_at); found != version) {
    refuse("version " + std::to_string(found) + " of the format, this program reads version " +
           std::to_string(version));
  }
}

SiteLayer layer_in(std::string_view bytes, std::size_t at) {
  return {.goal = {double_at(bytes, at), double_at(bytes, at + 8), double_at(bytes, at + 16)},
          .unit = double_at(bytes, at + 24),
          .at = read_at<std::uint64_t>(bytes, at + 32),
          .count = read_at<std::uint64_t>(bytes, at + 40)};
}

}  // namespace

std::optional<SiteEntry> SiteData::find(const SiteLayer& layer,
                                        const SiteState& state) const noexcept {
  const bool is_inside =
      state.column >= 0 && state.column < grid.columns && state.row >= 0 && state.row < grid.rows;
  if (!is_inside) return std::nullopt;
  const std::int64_t cell = std::int64_t{state.row} * grid.columns + state.column;
  const auto pair = static_cast<std::uint64_t>(cell * grid.headings + state.heading);
  const auto word_at = static_cast<std::size_t>(layer.at + pair / pairs_of_word * word_size);
  const auto word = read_at<std::uint64_t>(bytes, word_at);
  const std::uint64_t bit = std::uint64_t{1} << pair % pairs_of_word;
  if ((word & bit) == 0) return std::nullopt;
  const auto before = static_cast<std::uint64_t>(std::popcount(word & (bit - 1)));
  const std::uint64_t place = read_at<std::uint32_t>(bytes, word_at + 8) + before;
  if (place >= layer.count) return std::nullopt;
  const auto pair_at =
      static_cast<std::size_t>(layer.at + words_of(grid) * word_size + place * pair_size);
  const std::size_t gear = state.gear > 0 ? 0 : 1;
  const auto cost = read_at<std::uint16_t>(bytes, pair_at + 2 * gear);
  if (cost == unreached) return std::nullopt;
  SiteEntry entry = entry_of(read_at<std::uint8_t>(bytes, pair_at + 4 + gear), layer, state);
  entry.cost = layer.unit * cost;
  entry.place = static_cast<std::size_t>(place);
  return entry;
}

std::string_view SiteData::numbers(const SiteLayer& layer) const {
  return bytes.substr(static_cast<std::size_t>(layer.at),
                      static_cast<std::size_t>(size_of(grid, layer)));
}

SiteState SiteData::after(const SiteState& state, const SiteEntry& entry) const noexcept {
  const int headings = grid.headings;
  return {.column = state.column + entry.columns,
          .row = state.row + entry.rows,
          .heading = (state.heading + side_of_arc(entry.arc) * state.gear + headings) % headings,
          .gear = entry.next_gear == 0 ? -1 : entry.next_gear};
}

Segment site_step(const SiteGrid& grid, int gear, int arc) noexcept {
  const double sharpest = grid.radius * arcs_of_site;
  const double length = arc == 0 ? straight_cells * grid.cell
                                 : 2 * std::numbers::pi / grid.headings * sharpest / std::abs(arc);
  return {arc / sharpest, gear * length};
}

std::string layer_to_bytes(const SiteGrid& grid, const LayerSource& source, SiteLayer& layer,
                           std::string_view before) {
  const double unit = unit_of(source.largest);
  const bool is_new = before.empty() || unit != layer.unit;
  if (is_new) {
    layer.unit = unit;
    layer.reach = reach_of(grid, layer.goal);
  }
  const auto words = static_cast<std::size_t>(words_of(grid));
  std::string numbers;
  std::string pairs;
  numbers.reserve(before.size() + words * word_size);
  pairs.reserve(before.size());
  std::vector<SiteRecord> records;
  std::size_t old_pair = words * word_size;  // place of the pairs of a word in `before`
  layer.count = 0;
  for (std::size_t i = 0; i < words; ++i) {
    std::uint64_t word = is_new ? 0 : read_at<std::uint64_t>(before, i * word_size);
    const std::size_t old_size = static_cast<std::size_t>(std::popcount(word)) * pair_size;
    if (is_new || source.changed[i] != 0) {
      records.clear();
      source.records(i, records);
      word = append_pairs(grid, layer, records, pairs);
    } else {
      pairs.append(before.substr(old_pair, old_size));
    }
    old_pair += old_size;
    append(numbers, word);
    append(numbers, static_cast<std::uint32_t>(layer.count));
    layer.count += static_cast<std::uint64_t>(std::popcount(word));
  }
  return numbers + pairs;
}

std::string site_to_bytes(const SiteKey& key, const SiteGrid& grid, std::vector<SiteLayer> layers,
                          std::span<const std::string_view> numbers) {
  std::string bytes(magic);
  append(bytes, version);
  append(bytes, static_cast<std::uint32_t>(grid.headings));
  for (const std::uint64_t part : {key.world, key.vehicle, key.prices}) append(bytes, part);
  for (const double length : {grid.corner.x, grid.corner.y, grid.cell, grid.radius}) {
    append_double(bytes, length);
  }
  append(bytes, static_cast<std::uint32_t>(grid.columns));
  append(bytes, static_cast<std::uint32_t>(grid.rows));
  append(bytes, std::uint64_t{layers.size()});
  append(bytes, std::uint64_t{0});
  std::uint64_t at = head_size + layers.size() * goal_size;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const SiteLayer& layer = layers[i];
    for (const double number : {layer.goal.x, layer.goal.y, layer.goal.heading, layer.unit}) {
      append_double(bytes, number);
    }
    append(bytes, at);
    append(bytes, layer.count);
    at += numbers[i].size();
  }
  bytes.reserve(static_cast<std::size_t>(at));
  for (const std::string_view part : numbers) bytes += part;
  std::string sum;
  append(sum, checksum_of(bytes));
  return bytes.replace(checksum_at, sum.size(), sum);
}

std::string empty_numbers(const SiteGrid& grid) {
  return std::string(static_cast<std::size_t>(words_of(grid)) * word_size, '\0');
}

SiteData site_from_bytes(std::string_view all, std::shared_ptr<const void> owner,
                         const std::string& file) {
  check_head(all, file);
  SiteData data{
      .key = {read_at<std::uint64_t>(all, key_at), read_at<std::uint64_t>(all, key_at + 8),
              read_at<std::uint64_t>(all, key_at + 16)},
      .grid = grid_in(all, file),
      .layers = {},
      .bytes = all,
      .owner = std::move(owner)};
  const auto goals = read_at<std::uint64_t>(all, goals_at);
  std::uint64_t size = head_size + std::min(goals, most_goals) * goal_size;
  if (goals <= most_goals && size <= all.size()) {
    for (std::size_t at = head_size; at < head_size + goals * goal_size; at += goal_size) {
      const SiteLayer& layer = data.layers.emplace_back(layer_in(all, at));
      if (layer.count > data.grid.pairs() || layer.at != size) {
        throw InputError(file, "altered: its goals do not follow each other");
      }
      size += size_of(data.grid, layer);
    }
  }
  if (data.layers.size() != goals || all.size() != size) {
    throw InputError(file, (all.size() < size ? "truncated: " : "longer than it says: ") +
                               std::to_string(all.size()) + " bytes, expected " +
                               std::to_string(size));
  }
  if (checksum_of(all) != read_at<std::uint64_t>(all, checksum_at)) {
    throw InputError(file, "altered: the checksum does not fit the content");
  }
  for (SiteLayer& layer : data.layers) {
    const Pose& goal = layer.goal;
    if (!std::isfinite(goal.x + goal.y + goal.heading))
      throw InputError(file, "altered: a goal is not finite");
    layer.reach = reach_of(data.grid, goal);
  }
  return data;
}

}  // namespace vandplan::sites
