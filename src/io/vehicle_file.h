// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a vehicle read and written? (docs/formats.md)

#include <string>

#include "io/document.h"
#include "vandplan/vehicle.h"

namespace vandplan::io {

/// A map of lengths and limits, or the name of a vehicle of the catalogue. Limits that the map
/// lacks are those of the vehicle of the catalogue with these lengths; if there is none, the
/// defaults.
/// The vehicle of a map of lengths, of a name, or of a file, whose name is relative to the file
/// `where`.
[[nodiscard]] Vehicle vehicle_from(const Document& file, const Node& node,
                                   const std::string& where);

/// The map of lengths that `vehicle_from` reads back exactly, with the limits that it would not
/// find out itself.
[[nodiscard]] std::string yaml_of(const Vehicle& vehicle);

}  // namespace vandplan::io
