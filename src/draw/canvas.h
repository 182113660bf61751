// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a Cairo page become the bytes of a file, and which colours and text styles does it use?

#include <cairo.h>

#include <functional>
#include <string>

#include "vandplan/draw.h"

namespace vandplan::drawing {

/// Size of a page [page units]. Pages are laid out at a fixed width and scaled to the wanted width.
struct Size {
  double width = 0.0;
  double height = 0.0;
};

/// Rectangle on the page, y down [page units].
struct Box {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

struct Colour {
  double red, green, blue;  // Components from 0 to 1.
};

/// Colours that the colour-blind can tell apart (Okabe and Ito 2008), also on grey paper.
namespace colour {
inline constexpr Colour paper{1.0, 1.0, 1.0};
inline constexpr Colour ink{0.13, 0.15, 0.18};
inline constexpr Colour faint_ink{0.42, 0.45, 0.49};
inline constexpr Colour obstacle{0.35, 0.38, 0.43};
inline constexpr Colour kerb{0.80, 0.71, 0.55};
inline constexpr Colour moving{0.58, 0.29, 0.72};
inline constexpr Colour margin{0.95, 0.80, 0.35};
inline constexpr Colour unknown{0.72, 0.74, 0.77};
inline constexpr Colour outside{0.935, 0.932, 0.915};
inline constexpr Colour tree{0.66, 0.72, 0.79};
inline constexpr Colour forward{0.0, 0.447, 0.698};
inline constexpr Colour reverse{0.835, 0.369, 0.0};
inline constexpr Colour driven{0.0, 0.0, 0.0};
inline constexpr Colour hit{0.85, 0.07, 0.07};
inline constexpr Colour start{0.0, 0.62, 0.451};
inline constexpr Colour goal{0.70, 0.30, 0.55};
}  // namespace colour

void set_colour(cairo_t* cairo, const Colour& colour, double alpha);

/// Bytes of a page that `paint` fills, `width` pixels or points wide. Throws InputError if a text
/// is not UTF-8, and std::runtime_error if Cairo fails.
[[nodiscard]] std::string render(PictureFormat format, int width, const Size& page,
                                 const std::function<void(cairo_t*)>& paint);

/// Bytes of an image as PNG. Throws as `render` does.
[[nodiscard]] std::string png_of(cairo_surface_t* image);

enum class Align { left, centre, right };

struct TextStyle {
  double size = 11.0;
  Align align = Align::left;
  Colour colour = colour::ink;
  bool bold = false;
};

/// Writes a text on a base line at (x, y).
void write_text(cairo_t* cairo, const std::string& text, double x, double y,
                const TextStyle& style);

/// Width of a text [page units].
[[nodiscard]] double text_width(cairo_t* cairo, const std::string& text, const TextStyle& style);

}  // namespace vandplan::drawing
