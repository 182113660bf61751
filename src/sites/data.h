// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the numbers of a site table laid out?
//
// A table is the bytes of its file, which are looked into where they lie. All numbers are
// little-endian.
//
//    0  "vp-site "
//    8  u32 version: 2
//   12  u32 headings of a full turn
//   16  u64 hashes of world, vehicle, prices
//   40  doubles: least x and y of the cells, side of a cell, turning radius [m]
//   72  u32 columns, u32 rows
//   80  u64 number of goals
//   88  u64 checksum of everything else: FNV-1a (64 bits), but by words of 8 bytes
//   96  each goal: doubles x, y, heading, unit of its costs [m]; u64 place of its numbers, u64
//       number of pairs that were reached
//
// The numbers of a goal begin with a word of 64 bits and a u32 for each 64 pairs of cell and
// heading: which of them were reached, and how many before. A pair is number (row * columns +
// column) * headings + heading. Six bytes follow for each reached pair, first those for driving
// forward: two u16 costs (65535: none), two u8 steps. A step is ((3 dy + dx) * 5 + arc + 2) * 3 +
// next gear + 1, and 255 at the goal. The arcs left and right have the curvatures 1/2 and 1 of the
// turning radius; 0 is a line. It leads dx and dy cells beyond `SiteLayer::reach`.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sites/key.h"
#include "vandplan/geometry.h"
#include "vandplan/path.h"

namespace vandplan::sites {

/// Arcs of the steps on each side; their curvatures are equal parts of the sharpest.
inline constexpr int arcs_of_site = 2;

/// Largest cost of a state [units of its layer].
inline constexpr double most_units = 0xFFFE;
/// Pairs of cell and heading that a word has bits for.
inline constexpr std::uint64_t pairs_of_word = 64;

/// Cells of a table.
struct SiteGrid {
  Point corner = {};    ///< corner with the least x and y, in the scenario's frame [m]
  double cell = 1.0;    ///< side of a cell [m]
  double radius = 1.0;  ///< turning radius of the arcs [m]
  std::int32_t columns = 0, rows = 0, headings = 0;

  /// Number of pairs of a cell of places and a heading.
  [[nodiscard]] constexpr std::uint64_t pairs() const noexcept {
    return static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows) *
           static_cast<std::uint64_t>(headings);
  }
};

/// Number of words that tell which pairs were reached.
[[nodiscard]] constexpr std::uint64_t words_of(const SiteGrid& grid) noexcept {
  return (grid.pairs() + pairs_of_word - 1) / pairs_of_word;
}

/// Place of a pose in a table. The heading is counted in steps from the goal's heading.
struct SiteState {
  std::int32_t column = 0, row = 0, heading = 0;
  int gear = 1;  ///< gear in which the vehicle leaves for the goal: 1 or -1
  bool operator==(const SiteState&) const = default;
};

/// What a table knows of a state: the cost of its way to the goal, and the first step of that way.
struct SiteEntry {
  std::size_t place = 0;               ///< number of the pair among those that were reached
  double cost = 0.0;                   ///< [m]
  bool is_goal = false;                ///< whether the way is empty
  int arc = 0;                         ///< step: number of the arc, left above 0; 0 straight
  std::int32_t columns = 0, rows = 0;  ///< cells by which the step leads on
  /// Gear of the step after this one; 0 if this one ends at the goal.
  int next_gear = 0;
};

/// Costs to one goal.
struct SiteLayer {
  Pose goal = {};           ///< in the scenario's frame
  double unit = 1.0;        ///< unit of the costs [m]
  std::uint64_t at = 0;     ///< place of the numbers in the bytes
  std::uint64_t count = 0;  ///< pairs of cell and heading that were reached
  /// Least cells by which the steps lead on: of each heading, gear and arc.
  std::vector<std::array<std::int32_t, 2>> reach = {};

  /// Cost of the farthest state [m].
  [[nodiscard]] double largest_cost() const noexcept { return most_units * unit; }
};

/// Side to which an arc turns: 1 left, -1 right, 0 straight.
[[nodiscard]] constexpr int side_of_arc(int arc) noexcept { return arc > 0 ? 1 : arc < 0 ? -1 : 0; }

/// The step by an arc in a gear, as the vehicle drives it.
[[nodiscard]] Segment site_step(const SiteGrid& grid, int gear, int arc) noexcept;

/// A table: its head, and the bytes of the whole file, where they lie.
struct SiteData {
  SiteKey key;
  SiteGrid grid;
  std::vector<SiteLayer> layers;
  std::string_view bytes;
  std::shared_ptr<const void> owner;  ///< keeps the bytes
  /// Costs from poses to a goal, in place of the cells'; usually none (`with_costs`).
  std::function<double(const Pose&, std::size_t goal)> costs = {};

  /// The entry of a state; none if it was not reached, or lies outside.
  [[nodiscard]] std::optional<SiteEntry> find(const SiteLayer& layer,
                                              const SiteState& state) const noexcept;
  /// The numbers of a layer.
  [[nodiscard]] std::string_view numbers(const SiteLayer& layer) const;
  /// The state after the step of an entry.
  [[nodiscard]] SiteState after(const SiteState& state, const SiteEntry& entry) const noexcept;
};

/// A state with its entry, while a table is made.
struct SiteRecord {
  std::uint64_t pair = 0;  ///< (row * columns + column) * headings + heading
  int gear = 1;
  SiteEntry entry = {};
};

/// Where the numbers of a layer come from.
struct LayerSource {
  double largest = 0.0;                        ///< largest cost [m]
  std::span<const std::uint8_t> changed = {};  ///< of each word: 0 if it is as it was
  /// Adds all records of the pairs of a word, in the order of the pairs.
  std::function<void(std::uint64_t word, std::vector<SiteRecord>& records)> records = {};
};

/// Numbers of one layer as bytes. `layer` has its goal, and gets the rest but for its place.
/// `before` are the numbers that the layer had, or empty: what has not changed is copied.
[[nodiscard]] std::string layer_to_bytes(const SiteGrid& grid, const LayerSource& source,
                                         SiteLayer& layer, std::string_view before);

/// The file of a table. The layers' places are computed here.
[[nodiscard]] std::string site_to_bytes(const SiteKey& key, const SiteGrid& grid,
                                        std::vector<SiteLayer> layers,
                                        std::span<const std::string_view> numbers);

/// Numbers of a layer that no pair reaches.
[[nodiscard]] std::string empty_numbers(const SiteGrid& grid);

/// The table in a file. Throws InputError naming `file` if it is foreign, truncated, altered, or of
/// another version.
[[nodiscard]] SiteData site_from_bytes(std::string_view bytes, std::shared_ptr<const void> owner,
                                       const std::string& file);

}  // namespace vandplan::sites
