// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which point of a plane has a longitude and latitude?

#include <functional>
#include <optional>

#include "vandplan/files.h"

namespace vandplan::io {

/// Largest distance of a place from the origin of its plane [m]. A metre there is 0.1 mm shorter in
/// the plane.
inline constexpr double largest_plane = 1e5;

/// Converts a place to a point of the plane [m]; empty beyond `largest_plane`.
using ToPlane = std::function<std::optional<Point>(const GeoPlace&)>;

/// Converts a point of the plane [m] to its place.
using FromPlane = std::function<GeoPlace(const Point&)>;

/// Plane that touches the ellipsoid at `origin`, x to the east, y to the north. Points are rounded
/// to 0.1 mm. Throws InputError if the library was built without GeographicLib.
[[nodiscard]] ToPlane plane_around(const GeoPlace& origin);

/// Places whose points `plane_around` gives, rounded to 1e-9 degrees. Throws as `plane_around`
/// does.
[[nodiscard]] FromPlane places_around(const GeoPlace& origin);

}  // namespace vandplan::io
