// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is an occupancy map painted? As one image, rotated and scaled to the page.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "draw/paint.h"

namespace vandplan::drawing {
namespace {

/// Visible cells of a grid: columns and rows from `begin` to `end` - 1.
struct MapPart {
  std::int32_t x_begin, x_end, y_begin, y_end;
};

MapPart seen_of(const OccupancyGrid& grid, const Bounds& visible) {
  Point corners[] = {{visible.x_min, visible.y_min},
                     {visible.x_max, visible.y_min},
                     {visible.x_max, visible.y_max},
                     {visible.x_min, visible.y_max}};
  for (Point& corner : corners) {
    const Pose place = relative(grid.origin, {corner.x, corner.y, 0.0});
    corner = {place.x / grid.resolution, place.y / grid.resolution};
  }
  const Bounds box = bounding_box(corners);
  const auto index = [](double cells, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(cells, 0.0, static_cast<double>(count)));
  };
  return {index(std::floor(box.x_min), grid.columns), index(std::ceil(box.x_max), grid.columns),
          index(std::floor(box.y_min), grid.rows), index(std::ceil(box.y_max), grid.rows)};
}

std::uint32_t pixel_of(const Colour& colour) {
  const auto byte = [](double part) { return static_cast<std::uint32_t>(std::lround(255 * part)); };
  return 0xFF000000U | byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

/// Fills the pixels of an image. Each pixel shows the worst of block * block cells.
void fill(cairo_surface_t* image, const OccupancyGrid& grid, const MapPart& part,
          std::int32_t block) {
  const std::uint32_t occupied = pixel_of(colour::obstacle);
  const std::uint32_t unknown = pixel_of(colour::unknown);
  cairo_surface_flush(image);
  auto* const pixels = reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(image));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image)) / 4;
  for (std::int32_t y = part.y_begin; y < part.y_end; ++y) {
    const Cell* const row =
        grid.cells->data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns);
    std::uint32_t* const line =
        pixels + static_cast<std::size_t>((y - part.y_begin) / block) * stride;
    for (std::int32_t x = part.x_begin; x < part.x_end; ++x) {
      std::uint32_t& pixel = line[(x - part.x_begin) / block];
      if (row[x] == Cell::occupied || (row[x] == Cell::unknown && pixel == 0)) {
        pixel = row[x] == Cell::occupied ? occupied : unknown;
      }
    }
  }
  cairo_surface_mark_dirty(image);
}

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

/// Image of a part of a grid; in an error state if there is no memory.
SurfacePtr image_of(const OccupancyGrid& grid, const MapPart& part, std::int32_t block) {
  const auto pixels = [&](std::int32_t begin, std::int32_t end) {
    return (end - begin + block - 1) / block;
  };
  SurfacePtr image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels(part.x_begin, part.x_end),
                                              pixels(part.y_begin, part.y_end)),
                   cairo_surface_destroy);
  if (cairo_surface_status(image.get()) == CAIRO_STATUS_SUCCESS)
    fill(image.get(), grid, part, block);
  return image;
}

}  // namespace

void paint_map(cairo_t* cairo, const OccupancyGrid& grid, const View& view) {
  const MapPart part = seen_of(grid, view.visible);
  if (part.x_begin >= part.x_end || part.y_begin >= part.y_end) return;
  constexpr double finest = 0.3;  // Least side of a pixel [page units].
  const double cell = grid.resolution * view.scale;
  const auto block = static_cast<std::int32_t>(std::clamp(finest / cell, 1.0, 1e6));
  const SurfacePtr image = image_of(grid, part, block);
  const Point origin = view.on_page({grid.origin.x, grid.origin.y});
  cairo_save(cairo);
  cairo_translate(cairo, origin.x, origin.y);
  cairo_rotate(cairo, -grid.origin.heading);
  cairo_scale(cairo, cell, -cell);  // Rows count upwards.
  cairo_translate(cairo, part.x_begin, part.y_begin);
  cairo_scale(cairo, block, block);
  // Cairo reports a broken image at the end.
  cairo_set_source_surface(cairo, image.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

}  // namespace vandplan::drawing

namespace vandplan {

MapImage map_image(const OccupancyGrid& map, int most) {
  const std::int32_t block = (std::max(map.columns, map.rows) + most - 1) / most;
  const drawing::SurfacePtr image = drawing::image_of(map, {0, map.columns, 0, map.rows}, block);
  const double pixel = block * map.resolution;
  return {drawing::png_of(image.get()), cairo_image_surface_get_width(image.get()) * pixel,
          cairo_image_surface_get_height(image.get()) * pixel};
}

}  // namespace vandplan
