// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do random poses come from?

#include "base/random.h"
#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// A random pose: its position uniform in the box, its heading uniform in [-pi, pi).
Pose uniform_pose(const Bounds& box, base::Rng& rng);

}  // namespace vandplan::geometry
