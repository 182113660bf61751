// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a vehicle read? (docs/formats.md)

#include "io/document.h"
#include "vandplan/vehicle.h"

namespace vandplan::io {

/// A map of lengths, or the name of a vehicle of the catalogue.
[[nodiscard]] Vehicle vehicle_from(const Document& file, const Node& node);

}  // namespace vandplan::io
