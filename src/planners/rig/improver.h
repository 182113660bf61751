// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a drive of a rig become the best one?

#include <cstdint>
#include <optional>

#include "planners/anytime/drive.h"
#include "planners/commands/shorten_drive.h"
#include "planners/rig/setting.h"

namespace vandplan::rig {

/// Makes one drive cheaper by trials. If time counts, tries softer wheels afterwards.
class Improver {
 public:
  /// The setting outlives the object.
  Improver(const Setting& setting, const anytime::Drive& drive, std::uint64_t seed);

  /// [4] One trial. False when nothing is left to do: trials hardly gain any more, or the drive is
  /// so much dearer than `best` that it will not become the best.
  bool step(double best);
  /// Cost of the drive with the present wheels [m or s].
  [[nodiscard]] double cost() const { return drive_->cost(); }
  [[nodiscard]] anytime::Drive drive() const;
  /// Segments checked for collisions.
  [[nodiscard]] std::int64_t checks() const { return checks_ + drive_->checks(); }

 private:
  [[nodiscard]] bool soften();

  const Setting& setting_;
  std::uint64_t seed_;
  std::size_t wheels_;
  std::optional<commands::DriveShortener> drive_;
  double before_;            // cost at the last check whether the drive is hopeless
  std::int64_t checks_ = 0;  // checks with former wheels
};

}  // namespace vandplan::rig
