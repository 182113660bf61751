// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do programs that plan with OMPL use this library? docs/ompl.md

#include "vandplan/ompl_geometric.h"  // OMPL's planners with exact nearest nodes
#include "vandplan/ompl_nearest.h"    // nearest nodes by exact length
#include "vandplan/ompl_planner.h"    // our planners as OMPL's planners
#include "vandplan/ompl_spaces.h"     // Reeds-Shepp and Dubins spaces
#include "vandplan/ompl_world.h"      // exact checks of poses and edges
