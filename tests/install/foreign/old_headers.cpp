// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Does a program of version 0.2 compile, whose headers had other names?
#include <vandplan/bound_table.h>
#include <vandplan/capability.h>
#include <vandplan/continuous_steering.h>
#include <vandplan/drive_check.h>
#include <vandplan/driving_limits.h>
#include <vandplan/dubins.h>
#include <vandplan/geojson.h>
#include <vandplan/goal_estimate.h>
#include <vandplan/goal_set.h>
#include <vandplan/heading_doubt.h>
#include <vandplan/heuristic_table.h>
#include <vandplan/live_drive.h>
#include <vandplan/moving.h>
#include <vandplan/nearest.h>
#include <vandplan/occupancy_grid.h>
#include <vandplan/outcome.h>
#include <vandplan/path_check.h>
#include <vandplan/path_source.h>
#include <vandplan/primitives.h>
#include <vandplan/primitives_file.h>
#include <vandplan/reeds_shepp.h>
#include <vandplan/rig.h>
#include <vandplan/rig_steering.h>
#include <vandplan/roadmap.h>
#include <vandplan/scenario_file.h>
#include <vandplan/smooth.h>
#include <vandplan/speed.h>
#include <vandplan/table_file.h>

int main() { return vandplan::dubins_length({0, 0, 0}, {20, 0, 0}, 7.0) > 19.0 ? 0 : 1; }
