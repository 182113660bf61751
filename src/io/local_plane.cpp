// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/local_plane.h"

#include <cmath>

#include "vandplan/input_error.h"

#ifdef VANDPLAN_GEOGRAPHICLIB
#include <GeographicLib/LocalCartesian.hpp>

namespace vandplan::io {
namespace {

double rounded(double metres) { return std::round(metres * 1e4) / 1e4; }

}  // namespace

ToPlane plane_around(const GeoPlace& origin) {
  const GeographicLib::LocalCartesian plane(origin.latitude, origin.longitude);
  return [plane](const GeoPlace& place) -> std::optional<Point> {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    plane.Forward(place.latitude, place.longitude, 0.0, x, y, z);
    if (!(std::sqrt(x * x + y * y + z * z) <= largest_plane)) return {};
    return Point{rounded(x), rounded(y)};
  };
}

FromPlane places_around(const GeoPlace& origin) {
  const GeographicLib::LocalCartesian plane(origin.latitude, origin.longitude);
  return [plane](const Point& point) {
    const auto rounded_angle = [](double degrees) { return std::round(degrees * 1e9) / 1e9; };
    double longitude = 0.0;
    double latitude = 0.0;
    double height = 0.0;
    double z = 0.0;
    // The place lies on the ellipsoid below the plane: `z` goes down by the height above it.
    for (int i = 0; i < 4; ++i) {
      plane.Reverse(point.x, point.y, z, latitude, longitude, height);
      z -= height;
    }
    return GeoPlace{rounded_angle(longitude), rounded_angle(latitude)};
  };
}

}  // namespace vandplan::io

bool vandplan::reads_longitudes() noexcept { return true; }

#else

namespace vandplan::io {
namespace {

[[noreturn]] void fail_without_library() {
  throw InputError(
      "GeographicLib",
      "is missing in this build, which longitudes and latitudes need, expected metres");
}

}  // namespace

ToPlane plane_around(const GeoPlace&) { fail_without_library(); }

FromPlane places_around(const GeoPlace&) { fail_without_library(); }

}  // namespace vandplan::io

bool vandplan::reads_longitudes() noexcept { return false; }

#endif
