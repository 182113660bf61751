// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a longitude and latitude lie in a plane?

#include <functional>
#include <optional>

#include "vandplan/geojson.h"

namespace vandplan::io {

/// The furthest that a place may be from the origin of its plane [m]: a metre there is 0.1 mm
/// shorter in the plane.
inline constexpr double largest_plane = 1e5;

/// Gives the point of a place [m]; none beyond `largest_plane`.
using ToPlane = std::function<std::optional<Point>(const GeoPlace&)>;

/// The plane that touches the ellipsoid at `origin`, x to the east, y to the north; points are
/// rounded to 0.1 mm. Throws InputError if the library was built without GeographicLib.
[[nodiscard]] ToPlane plane_around(const GeoPlace& origin);

}  // namespace vandplan::io
