// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a feature of a GeoJSON file mean for a scenario?

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.h"

namespace vandplan::io {

enum class FeatureKind { obstacle, kerb, bounds, zone, one_way, speed, start, goal, ground };

/// Feature of a file. Its nodes belong to the document.
struct Feature {
  const Node* node = nullptr;
  const Node* geometry = nullptr;  ///< Null if the feature has none.
  std::string type = {};  ///< Type of the geometry, "MultiPolygon"; empty without a geometry.
  FeatureKind kind = FeatureKind::ground;
  std::string ground = {};             ///< Reason why it is only ground, "highway".
  std::optional<double> width = {};    ///< Width of a line or point [m].
  std::optional<double> heading = {};  ///< Heading of a start, goal or one-way street [rad].
  const Node* heading_node = nullptr;  ///< Node of a heading in radians; null if there is none.
};

/// A property; null if it is missing, null or empty, as map editors write empty properties.
[[nodiscard]] const Node* property(const Document& file, const Node& feature,
                                   std::string_view name);

/// All features of a collection. Throws InputError if the document is no collection of features, or
/// a feature has an unknown kind or a wrong value.
[[nodiscard]] std::vector<Feature> features_from(const Document& file);

/// Whether the coordinates of a collection are longitudes and latitudes, otherwise metres. Throws
/// InputError if the file names another coordinate system.
[[nodiscard]] bool has_longitudes(const Document& file);

}  // namespace vandplan::io
