// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a feature of a GeoJSON file stand for?

#include <optional>
#include <string>
#include <vector>

#include "io/document.h"

namespace vandplan::io {

enum class FeatureKind { obstacle, kerb, bounds, start, goal, ground };

/// A feature of a file. The nodes are those of its document.
struct Feature {
  const Node* node = nullptr;
  const Node* geometry = nullptr;  ///< null: it has none
  std::string type = {};           ///< of the geometry, "MultiPolygon"; empty: it has none
  FeatureKind kind = FeatureKind::ground;
  std::string ground = {};             ///< why it is nothing but ground, "highway"
  std::optional<double> width = {};    ///< of a line or point [m]
  std::optional<double> heading = {};  ///< of a start or goal [rad]
  const Node* heading_node = nullptr;  ///< that is in radians; null: it is none
};

/// All features of a collection. Throws InputError for what is no collection of features, or says
/// of itself what is not known.
[[nodiscard]] std::vector<Feature> features_from(const Document& file);

/// Whether the coordinates of a collection are longitudes and latitudes, and not metres. Throws
/// InputError if the file names another system of coordinates.
[[nodiscard]] bool has_longitudes(const Document& file);

}  // namespace vandplan::io
