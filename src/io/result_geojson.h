// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a path laid over a map?

#include <string>
#include <vector>

#include "vandplan/result_file.h"

namespace vandplan::io {

/// Results as GeoJSON (RFC 7946): each path as a line, with points where it begins, changes its
/// gear and ends. The file must have an origin. Throws InputError if the library was built
/// without GeographicLib.
[[nodiscard]] std::string geojson_of(const ScenarioFile& file,
                                     const std::vector<ResultRecord>& records);

}  // namespace vandplan::io
