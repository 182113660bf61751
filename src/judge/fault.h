// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is wrong with a path?

#include <optional>
#include <string>

#include "judge/track.h"
#include "vandplan/judge.h"

namespace vandplan::judge {

/// A fault in one line, where it is, and what is hit.
struct Fault {
  std::string reason;
  std::optional<Place> place = {};
  std::optional<Hit> hit = {};
};

}  // namespace vandplan::judge
