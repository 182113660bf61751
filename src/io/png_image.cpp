// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/png_image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <exception>
#include <vector>

#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

/// File that libpng reads, and its error text. On an error libpng jumps (longjmp) out of its
/// functions to the caller here; no object with a destructor is skipped.
class PngFile {
 public:
  explicit PngFile(FileReader& file) : file_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, give_up, ignore);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  /// Reads the header. False if it is broken.
  bool read_header() {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, take);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(png_, info_);
    columns = png_get_image_width(png_, info_);
    rows = png_get_image_height(png_, info_);
    pixel_bits = png_get_bit_depth(png_, info_) * png_get_channels(png_, info_);
    return true;
  }

  /// Prepares the reading of rows. Requires a good header.
  bool begin() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand(png_);  // Expands palettes, transparent colours and small depths.
    passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    channels = png_get_channels(png_, info_);
    depth = png_get_bit_depth(png_, info_);
    row_size = png_get_rowbytes(png_, info_);
    return true;
  }

  bool read_row(png_bytep row) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_row(png_, row, nullptr);
    return true;
  }

  bool end() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_end(png_, nullptr);
    return true;
  }

  [[nodiscard]] const char* problem() const { return problem_; }

  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  int pixel_bits = 0;  // Bits of a pixel in the file.
  int passes = 0;      // Passes over all rows; several if interlaced.
  int channels = 0;
  int depth = 0;  // Bits of a channel.
  std::size_t row_size = 0;

 private:
  static void take(png_structp png, png_bytep to, std::size_t size) {
    auto* const file = static_cast<PngFile*>(png_get_io_ptr(png));
    if (const char* const problem = file->copy(to, size)) png_error(png, problem);
  }

  /// Copies bytes; returns the problem, or null. Must not throw through the C library.
  const char* copy(png_bytep to, std::size_t size) noexcept {
    try {
      const std::string_view bytes = file_.ahead(size);
      if (bytes.size() < size) return "it ends too early";
      std::memcpy(to, bytes.data(), size);
      file_.skip(size);
      return nullptr;
    } catch (const std::exception&) {
      return "it cannot be read";
    }
  }

  [[noreturn]] static void give_up(png_structp png, png_const_charp problem) {
    auto* const file = static_cast<PngFile*>(png_get_error_ptr(png));
    std::strncpy(file->problem_, problem, sizeof file->problem_ - 1);
    png_longjmp(png, 1);
  }

  static void ignore(png_structp, png_const_charp) {}

  FileReader& file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char problem_[120] = {};
};

[[noreturn]] void fail(const PngFile& file, const std::string& where) {
  throw InputError(
      where, std::string("is a broken PNG image (") + file.problem() + "), expected a whole one");
}

/// Throws InputError for a large interlaced image. Its rows are complete only after the last pass,
/// so all must be kept.
void check_interlaced(const PngFile& file, const std::string& where) {
  constexpr double most = 1e8;  // Largest number of pixels.
  if (file.passes == 1 || static_cast<double>(file.columns) * file.rows <= most) return;
  throw InputError(where,
                   fmt::format("is {} x {} pixels and interlaced, expected at most {:.0f}, or "
                               "one row after the other",
                               file.columns, file.rows, most));
}

/// Brightness of a pixel whose channels begin at `bytes`.
std::uint32_t brightness(const PngFile& file, const png_byte* bytes, Alpha alpha) {
  const auto channel = [&](int i) -> std::uint32_t {
    return file.depth == 16 ? bytes[2 * i] * 256U + bytes[2 * i + 1] : bytes[i];
  };
  const bool is_grey = file.channels < 3;
  const std::uint32_t sum = is_grey ? 3 * channel(0) : channel(0) + channel(1) + channel(2);
  const bool has_opacity = file.channels % 2 == 0;
  if (!has_opacity || alpha == Alpha::ignored) return sum;
  const std::uint32_t opacity = channel(file.channels - 1);
  return opacity == (1U << file.depth) - 1 ? sum : transparent_pixel;
}

/// Throws InputError if the file is too small. Deflate expands a byte to at most 1032.
void check_bytes(const PngFile& file, const ImageShape& shape, std::size_t bytes,
                 const std::string& where) {
  const double pixels = static_cast<double>(file.columns) * static_cast<double>(file.rows);
  check_image_bytes(shape, bytes, pixels * file.pixel_bits / 8 / 1032, "PNG", where);
}

}  // namespace

void read_png(FileReader& reader, Alpha alpha, const TakeRow& take_row) {
  const std::string& where = reader.name();
  PngFile file(reader);
  if (!file.read_header()) fail(file, where);
  check_image_size(file.columns, file.rows, where);
  ImageShape shape{static_cast<std::int32_t>(file.columns), static_cast<std::int32_t>(file.rows)};
  check_bytes(file, shape, reader.size(largest_image), where);
  if (!file.begin()) fail(file, where);
  check_interlaced(file, where);
  shape.white = 3 * ((1U << file.depth) - 1);
  const auto step =
      static_cast<std::size_t>(file.channels) * static_cast<std::size_t>(file.depth / 8);
  std::vector<std::uint32_t> row(file.columns);
  const auto hand_out = [&](const png_byte* pixels) {
    for (std::size_t x = 0; x < row.size(); ++x)
      row[x] = brightness(file, pixels + x * step, alpha);
    take_row(shape, row);
  };
  const bool at_once = file.passes > 1;
  std::vector<png_byte> raster(file.row_size * (at_once ? file.rows : 1));
  for (int pass = 0; pass < file.passes; ++pass) {
    for (std::size_t i = 0; i < file.rows; ++i) {
      png_byte* const place = raster.data() + (at_once ? i * file.row_size : 0);
      if (!file.read_row(place)) fail(file, where);
      if (pass + 1 == file.passes) hand_out(place);
    }
  }
  if (!file.end()) fail(file, where);
}

}  // namespace vandplan::io
