// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/image_file.h"

#include <array>
#include <string_view>

#include "io/pgm.h"
#include "io/png_image.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

/// Kind of a file that is not read, judged by its first bytes.
std::string kind_of(std::string_view bytes) {
  struct Kind {
    std::string_view begin, name;
  };
  constexpr std::array<Kind, 11> kinds = {{{"BM", "a BMP image"},
                                           {"\xFF\xD8\xFF", "a JPEG image"},
                                           {"GIF8", "a GIF image"},
                                           {"II*", "a TIFF image"},
                                           {"MM", "a TIFF image"},
                                           {"RIFF", "a WebP image"},
                                           {"P1", "a PBM image"},
                                           {"P4", "a PBM image"},
                                           {"P3", "a PPM image"},
                                           {"P6", "a PPM image"},
                                           {"P7", "a PAM image"}}};
  for (const Kind& kind : kinds) {
    if (bytes.starts_with(kind.begin)) return std::string(kind.name);
  }
  return bytes.empty() ? "empty" : "no image that can be read";
}

}  // namespace

void read_image(FileReader& file, Alpha alpha, const TakeRow& take_row) {
  const std::string_view begin = file.ahead(4);
  if (begin.starts_with("P2") || begin.starts_with("P5")) return read_pgm(file, take_row);
  if (begin.starts_with("\x89PNG")) return read_png(file, alpha, take_row);
  throw InputError(file.name(),
                   "is " + kind_of(begin) + ", expected a PGM (P2 or P5) or PNG image");
}

}  // namespace vandplan::io
