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

namespace vandplan {

/// A place on the ellipsoid WGS84 [degrees].
struct GeoPlace {
  double longitude = 0.0;
  double latitude = 0.0;
  bool operator==(const GeoPlace&) const = default;
};

/// A site, and what its file does not say.
struct GeoJsonSite {
  std::string file = {};      ///< "-" is standard input
  Vehicle vehicle = {};       ///< who drives
  bool is_in_metres = false;  ///< whatever the file says about its coordinates
  /// Instead of those of the file; x, y as it counts them, heading [rad].
  std::optional<Pose> start = {};
  std::optional<Pose> goal = {};
  double default_width = 0.2;  ///< of lines and points that do not say theirs [m]; > 0
};

/// What became of a site.
struct GeoJsonScenario {
  Scenario scenario = {};
  /// Where the scenario's origin lies on Earth, x to the east, y to the north; none: the
  /// coordinates of the file are metres and were taken as they are.
  std::optional<GeoPlace> origin = {};
  /// What was left out or changed, "left out: highway 3".
  std::vector<std::string> notes = {};
  /// What deserves a look though nothing is wrong, "file:line: key: what".
  std::vector<std::string> warnings = {};
};

/// Whether longitudes and latitudes can be read: the library was built with GeographicLib.
[[nodiscard]] bool reads_longitudes() noexcept;

/// Reads and checks a site (GeoJSON). Longitudes and latitudes become metres in a plane that
/// touches the Earth at the start.
[[nodiscard]] GeoJsonScenario read_geojson(const GeoJsonSite& site);

}  // namespace vandplan
