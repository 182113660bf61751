// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which curves join the states of an OMPL space?

#include <ompl/base/StateSpace.h>

#include "vandplan/path.h"

namespace vandplan::ompl {

/// Shortest paths of a Reeds-Shepp or Dubins space, of vandplan or OMPL.
class Curves {
 public:
  /// Throws ompl::Exception for other spaces.
  explicit Curves(const ::ompl::base::StateSpace& space);

  /// Turning radius [m]. OMPL's spaces do not state it, so it is measured, up to rounding.
  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] bool is_reeds_shepp() const noexcept { return kind_ == Kind::reeds_shepp; }

  [[nodiscard]] Piece piece(const Pose& from, const Pose& to) const noexcept;

 private:
  enum class Kind { reeds_shepp, dubins, symmetric_dubins };

  Kind kind_;
  double radius_;
};

/// Whether the Dubins path from `to` to `from` is shorter than that from `from` to `to`.
[[nodiscard]] bool is_shorter_back(const Pose& from, const Pose& to, double radius) noexcept;

/// Shorter one of the path from `from` to `to` and the path back, driven in reverse. Ties go to the
/// former.
[[nodiscard]] Piece symmetric_dubins(const Pose& from, const Pose& to, double radius) noexcept;

}  // namespace vandplan::ompl
