// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What stands on and beside a road of OpenDRIVE?

#include "io/road_line.h"
#include "io/roads.h"
#include "io/xml.h"

namespace vandplan::io {

/// Adds the parking spaces of a road as areas, what stands there as obstacles, and counts all other
/// objects as left out. `elevation` is the height of the road's reference line.
void add_objects(const XmlFile& file, const XmlNode& road, const RoadLine& line,
                 const CubicLine& elevation, Roads& roads);

}  // namespace vandplan::io
