// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it for a tractor with a trailer, answered from a table?
//
// This table does for rigs what the thesis' heuristic look-up table does for a vehicle alone:
// docs/algorithms/trailers.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "vandplan/vehicle.h"

namespace vandplan {

/// Cells into which states around a rig are divided.
struct RigTableOptions {
  double reach = 30.0;   ///< largest |x| and |y| [m]; 1e-3 to 1e6
  int cells = 12;        ///< squares from 0 to `reach`; 1 to 100
  int headings = 24;     ///< headings of a full turn; 1 to 360
  int hitch_angles = 5;  ///< hitch angles of each state; odd, 1 to 25
  bool operator==(const RigTableOptions&) const = default;
};

/// Lengths of the paths of `RigSteering` between states of one rig on open ground. There is one for
/// each cell of relative place and heading and each pair of hitch angles. Only the left half is
/// stored: mirrored states have the mirrored path. Immutable; copies share the entries.
class RigTable {
 public:
  /// Computes all lengths on that many threads: 172 800 with the usual options, some 2 s on one
  /// core. Any number of threads gives equal lengths. Throws InputError naming an option that is
  /// out of range, or as `RigSteering` does.
  explicit RigTable(const Vehicle& vehicle, const RigTableOptions& options = {}, int threads = 1);

  /// Approximate length from one state to another [m]: the length from middle to middle of their
  /// cells, rounded to `unit()`. Beyond the table it is the length of the last cell on the way
  /// there, plus the straight line from there. It is infinite where steering found no path. The
  /// hitch angles must be within the limit.
  [[nodiscard]] double distance(const State& from, const State& to) const noexcept;

  /// A state as the table sees it. States that are looked up often are converted once.
  struct Place {
    Pose pose;
    double sin, cos;  ///< sine and cosine of the heading
    int hitch_angle;  ///< cell of the hitch angle
  };
  /// The state as the table sees it.
  [[nodiscard]] Place place_of(const State& state) const noexcept;
  /// Approximate length from one place to another, as `distance` gives it [m].
  [[nodiscard]] double look_up(const Place& from, const Place& to) const noexcept;

  /// The table of a rig of similar shape that is `factor` times as large. Throws InputError naming
  /// "factor" unless it is > 0 and finite.
  [[nodiscard]] RigTable scaled(double factor) const;

  [[nodiscard]] const RigTableOptions& options() const noexcept { return options_; }
  /// Unit of an entry [m]: 0.1, but for scaled tables.
  [[nodiscard]] double unit() const noexcept { return unit_; }
  /// All lengths [units], row-major [x][y][heading][first hitch angle][last hitch angle]. `none`
  /// stands where there is no path, or one of more than 65 534 units.
  [[nodiscard]] std::span<const std::uint16_t> entries() const noexcept { return entries_; }
  /// Entry that stands for no path.
  static constexpr std::uint16_t none = 0xFFFF;

 private:
  friend RigTable embedded_rig_table(const Vehicle& vehicle);
  // A table of constant data with the usual options.
  RigTable(double max_hitch_angle, std::span<const std::uint16_t> entries) noexcept;

  // A cell of both states, for y >= 0.
  struct Cell {
    int x, y, heading, first, last;
  };
  [[nodiscard]] std::size_t index_of(const Cell& cell) const noexcept;
  [[nodiscard]] double hitch_angle(int index) const noexcept;
  [[nodiscard]] int hitch_index(double angle) const noexcept;

  RigTableOptions options_;
  double most_hitch_angle_;
  double unit_ = 0.1;
  // Empty when the entries are constant data.
  std::shared_ptr<const std::vector<std::uint16_t>> storage_;
  std::span<const std::uint16_t> entries_;
};

/// The table of the catalogue's `tractor-semitrailer`, computed when the library was built, scaled
/// to the vehicle's turning radius. For rigs of other shapes it is a guess. Costs nothing to call.
/// Throws InputError naming "vehicle.trailers" without a trailer.
[[nodiscard]] RigTable embedded_rig_table(const Vehicle& vehicle);

/// Lower bound of the length of every path from one state to another [m], from the table of bounds.
/// It is the larger of the bounds for the tractor by itself and for the trailer. Throws InputError
/// naming "vehicle.trailers" without a trailer.
[[nodiscard]] double rig_length_bound(const Vehicle& vehicle, const State& from, const State& to);

}  // namespace vandplan
