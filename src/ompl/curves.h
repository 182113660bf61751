// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which curves does a space of OMPL join its states by?

#include <ompl/base/StateSpace.h>

#include "vandplan/path.h"

namespace vandplan::ompl {

/// Shortest paths as a Reeds-Shepp or Dubins space has them, ours or OMPL's.
class Curves {
 public:
  /// Throws ompl::Exception for another space.
  explicit Curves(const ::ompl::base::StateSpace& space);

  /// Of turning [m]; of OMPL's spaces, which do not tell, it is measured: right but for rounding.
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

/// The shorter one of the paths there and back, which is driven in reverse; there, if they tie.
[[nodiscard]] Piece symmetric_dubins(const Pose& from, const Pose& to, double radius) noexcept;

}  // namespace vandplan::ompl
