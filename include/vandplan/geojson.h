// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a site that somebody drew on a map become a scenario?
//
// Which features become what: docs/formats.md. Every error is an InputError "file:line: what is
// wrong, what was expected".

#include <optional>
#include <string>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/scenario_file.h"

namespace vandplan {

/// A site file, and what it does not say.
struct GeoJsonSite {
  std::string file = {};      ///< file name; "-" is standard input
  Vehicle vehicle = {};       ///< vehicle that drives there
  bool is_in_metres = false;  ///< whether coordinates are metres, whatever the file says
  /// Start that replaces the one of the file: x and y in its coordinates, heading [rad].
  std::optional<Pose> start = {};
  /// Goal that replaces the one of the file: x and y in its coordinates, heading [rad].
  std::optional<Pose> goal = {};
  /// Width of lines and points that do not state theirs [m]; 0.001 to 1000.
  double default_width = 0.2;
};

/// The scenario of a site.
struct GeoJsonScenario {
  Scenario scenario = {};
  /// Place of the scenario's origin on Earth, with x to the east and y to the north. None: the
  /// coordinates of the file are metres and were used as they are.
  std::optional<GeoPlace> origin = {};
  /// Features that were left out or changed: "left out: highway 3".
  std::vector<std::string> notes = {};
  /// Doubtful values that are not wrong: "file:line: key: what".
  std::vector<std::string> warnings = {};
};

/// Whether longitudes and latitudes can be read: the library was built with GeographicLib.
[[nodiscard]] bool reads_longitudes() noexcept;

/// Reads and checks a site (GeoJSON). Longitudes and latitudes become metres in a plane that
/// touches the Earth at the start. Throws InputError "file:line: what is wrong", or naming "width"
/// if `default_width` is out of range.
[[nodiscard]] GeoJsonScenario read_geojson(const GeoJsonSite& site);

}  // namespace vandplan
