// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a vehicle read and written? (docs/formats.md)

#include <string>

#include "io/document.h"
#include "vandplan/vehicle.h"

namespace vandplan::io {

/// Vehicle from a map of lengths and limits, a name of the catalogue, or a file, whose name is
/// relative to the file `where`. Limits that the map lacks are those of the catalogue's vehicle
/// with these lengths. If there is none, they are the defaults.
[[nodiscard]] Vehicle vehicle_from(const Document& file, const Node& node,
                                   const std::string& where);

/// Map of lengths that `vehicle_from` reads back exactly. It names only limits that differ from
/// those that `vehicle_from` would assume.
[[nodiscard]] std::string yaml_of(const Vehicle& vehicle);

}  // namespace vandplan::io
