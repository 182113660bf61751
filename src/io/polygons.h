// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are polygons read and written?

#include <string>

#include "io/document.h"
#include "vandplan/geometry.h"

namespace vandplan::io {

/// A list of exactly two numbers; `expected` describes them in errors.
[[nodiscard]] Point pair_from(const Document& file, const Node& node, const std::string& expected);

/// Polygon from a list [[x, y], ...].
[[nodiscard]] Polygon polygon_from(const Document& file, const Node& node);

/// Polygon as a list [[x, y], ...] on one line.
[[nodiscard]] std::string yaml_of(const Polygon& polygon);

}  // namespace vandplan::io
