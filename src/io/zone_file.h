// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are zones and masks read and written? (docs/formats.md)

#include <string>
#include <vector>

#include "io/document.h"
#include "vandplan/problem.h"

namespace vandplan::io {

/// Zones of the list under `zones:`. Throws InputError naming the wrong node.
[[nodiscard]] std::vector<Zone> zones_from(const Document& file, const Node& node);

/// The key `zones:` with its list, as lines of a scenario; empty if there are no zones.
[[nodiscard]] std::string zones_to_yaml(const std::vector<Zone>& zones);

/// Further maps of the list under `masks:`; their names are relative to the scenario's file
/// `where`. Nav2 gives speeds in percent of `fastest` [m/s].
[[nodiscard]] std::vector<Mask> masks_from(const Document& file, const Node& node,
                                           const std::string& where, double fastest,
                                           std::vector<std::string>& warnings);

/// The key `masks:` with its list, as lines of a scenario; empty if there are no masks.
[[nodiscard]] std::string masks_to_yaml(const std::vector<Mask>& masks);

}  // namespace vandplan::io
