// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it for a tractor with a trailer, answered from a table?
//
// What the thesis' heuristic look-up table is for a vehicle alone: docs/algorithms/trailers.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "vandplan/rig.h"

namespace vandplan {

/// How states around a rig are cut into cells.
struct RigTableOptions {
  double reach = 30.0;   ///< of |x| and |y| [m]; 1e-3 to 1e6
  int cells = 12;        ///< squares from 0 to `reach`; 1 to 100
  int headings = 24;     ///< of one full turn; 1 to 360
  int hitch_angles = 5;  ///< of each state; odd, 1 to 25
  bool operator==(const RigTableOptions&) const = default;
};

/// Lengths of the paths of `RigSteering` between states of one rig on open ground, one for each
/// cell of relative place and heading and each pair of hitch angles. Only the left half is stored:
/// the mirrored states have the mirrored path. Immutable; copies share the entries.
class RigTable {
 public:
  /// Works all lengths out, on so many threads: of the usual options 172 800, some 2 s on one core.
  /// The same lengths on any number of threads. Throws InputError if an option is out of range, or
  /// as `RigSteering` does.
  explicit RigTable(const Vehicle& vehicle, const RigTableOptions& options = {}, int threads = 1);

  /// About how far it is from one state to another [m]: the length of the cell, from its middle to
  /// its middle, to `unit()`; beyond the table that of the last cell on the way there, and the
  /// straight line from there on. Infinite where steering found no path. The hitch angles are
  /// within the limit.
  [[nodiscard]] double distance(const RigState& from, const RigState& to) const noexcept;

  /// A state as the table sees it: what is looked up often is worked out once.
  struct Place {
    Pose pose;
    double sin, cos;  ///< of the heading
    int hitch_angle;  ///< its cell
  };
  [[nodiscard]] Place place_of(const RigState& state) const noexcept;
  [[nodiscard]] double look_up(const Place& from, const Place& to) const noexcept;

  /// The table of a rig of the same shape that is `factor` times as large; > 0, finite.
  [[nodiscard]] RigTable scaled(double factor) const;

  [[nodiscard]] const RigTableOptions& options() const noexcept { return options_; }
  /// What an entry counts [m]: a decimetre, but for scaled tables.
  [[nodiscard]] double unit() const noexcept { return unit_; }
  /// All lengths, row-major [x][y][heading][first hitch angle][last hitch angle]; `none` where
  /// there is no path, or one of more than 65 534 units.
  [[nodiscard]] std::span<const std::uint16_t> entries() const noexcept { return entries_; }
  static constexpr std::uint16_t none = 0xFFFF;

 private:
  friend RigTable embedded_rig_table(const Vehicle& vehicle);
  /// Of constant data with the usual options.
  RigTable(double max_hitch_angle, std::span<const std::uint16_t> entries) noexcept;

  /// A cell of both states, whose y is not negative.
  struct Cell {
    int x, y, heading, first, last;
  };
  [[nodiscard]] std::size_t index_of(const Cell& cell) const noexcept;
  [[nodiscard]] double hitch_angle(int index) const noexcept;
  [[nodiscard]] int hitch_index(double angle) const noexcept;

  RigTableOptions options_;
  double most_hitch_angle_;
  double unit_ = 0.1;
  std::shared_ptr<const std::vector<std::uint16_t>> storage_;  // empty: constant data
  std::span<const std::uint16_t> entries_;
};

/// The table of the catalogue's `tractor-semitrailer`, computed when the library was built, as
/// large as the vehicle's turning radius asks for: a guess for rigs of other shapes. Costs nothing
/// to call.
[[nodiscard]] RigTable embedded_rig_table(const Vehicle& vehicle);

/// What no path from one state to another is shorter than [m], from the table of bounds: the least
/// way of the tractor by itself, or that of the trailer. The vehicle has a trailer.
[[nodiscard]] double rig_length_bound(const Vehicle& vehicle, const RigState& from,
                                      const RigState& to);

}  // namespace vandplan
