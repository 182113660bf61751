// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/draw.h"

#include "draw/canvas.h"
#include "draw/film.h"
#include "draw/footprints.h"
#include "draw/frame.h"
#include "draw/paint.h"
#include "draw/scene.h"
#include "draw/strip.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace drawing;

void require_width(int width) {
  if (width < 50 || width > 10000) {
    throw InputError("width", std::to_string(width) + " must be from 50 to 10000");
  }
}

struct Caption {
  const std::string& text;
  double size;
};

// Writes a caption, smaller if it is too long for the width.
void paint_caption(cairo_t* cairo, const Caption& caption, const Point& at, double width) {
  TextStyle style{.size = caption.size, .bold = true};
  const double needed = text_width(cairo, caption.text, style);
  if (needed > width) style.size *= width / needed;
  write_text(cairo, caption.text, at.x, at.y, style);
}

void paint_clipped(cairo_t* cairo, const Scene& scene, const View& view) {
  const Box& plot = view.plot;
  cairo_save(cairo);
  cairo_rectangle(cairo, plot.x, plot.y, plot.width, plot.height);
  cairo_clip(cairo);
  paint_scene(cairo, scene, view);
  cairo_restore(cairo);
}

}  // namespace

PictureFormat picture_format(const std::string& file) {
  const auto ends_with = [&](const char* ending) { return file.ends_with(ending); };
  if (ends_with(".png")) return PictureFormat::png;
  if (ends_with(".svg")) return PictureFormat::svg;
  if (ends_with(".pdf")) return PictureFormat::pdf;
  throw InputError(file, "a picture must end in .png, .svg or .pdf");
}

std::string draw(const Drawing& drawing, PictureFormat format, int width) {
  require_width(width);
  const Scene scene = scene_of(drawing);
  const Layout layout = layout_of(scene, !drawing.caption.empty());
  const Box& plot = layout.view.plot;
  LegendContent legend;
  legend.add(scene, layout.view);
  std::string picture = render(format, width, layout.page, [&](cairo_t* cairo) {
    paint_caption(cairo, {drawing.caption, 14.0}, {plot.x, plot.y - 14.0}, plot.width);
    paint_clipped(cairo, scene, layout.view);
    paint_grid(cairo, layout.view);
    paint_axes(cairo, layout.view);
    paint_axis_titles(cairo, scene, layout.view);
    if (layout.is_cropped) paint_cropped(cairo, layout.view);
    if (layout.strip) paint_curvature_strip(cairo, scene, *layout.strip);
    paint_legend(cairo, legend, layout.legend);
  });
  if (format != PictureFormat::svg) return picture;
  const Overlay overlay{drawing, scene, layout.view, width / layout.page.width};
  if (drawing.speeds && drawing.path) picture = played(picture, overlay);
  return drawing.footprints ? with_footprints(picture, overlay) : picture;
}

std::string draw(const ContactSheet& sheet, PictureFormat format, int width) {
  require_width(width);
  if (sheet.columns < 1) throw InputError("columns", "must be at least 1");
  constexpr Size cell{240.0, 208.0};
  constexpr Box plot{6.0, 24.0, 228.0, 178.0};  // Plot within its cell.
  constexpr double below = 34.0;                // Height of the legend.
  const double top = sheet.caption.empty() ? 2.0 : 40.0;
  const auto columns = static_cast<std::size_t>(sheet.columns);
  const std::size_t rows = (sheet.drawings.size() + columns - 1) / columns;
  const Size page{cell.width * sheet.columns,
                  top + cell.height * static_cast<double>(rows) + below};
  return render(format, width, page, [&](cairo_t* cairo) {
    paint_caption(cairo, {sheet.caption, 15.0}, {plot.x, 26.0}, page.width - 2 * plot.x);
    LegendContent legend;
    for (std::size_t i = 0; i < sheet.drawings.size(); ++i) {
      const Drawing& drawing = sheet.drawings[i];
      const Scene scene = scene_of(drawing);
      const double x = cell.width * static_cast<double>(i % columns) + plot.x;
      const auto row = i / columns;
      const double y = top + cell.height * static_cast<double>(row) + plot.y;
      const auto [seen, is_cropped] = framed(scene);
      const View view = view_of(seen, {x, y, plot.width, plot.height});
      paint_caption(cairo, {drawing.caption, 11.5}, {x, y - 6.0}, plot.width);
      paint_clipped(cairo, scene, view);
      paint_small_frame(cairo, view, is_cropped);
      legend.add(scene, view);
    }
    paint_legend(cairo, legend, {0.0, page.height - below, page.width, below});
  });
}

}  // namespace vandplan
