// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/pgm.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "vandplan/input_error.h"

// https://netpbm.sourceforge.net/doc/pgm.html: magic number, width, height, greatest value, all
// separated by blanks and comments; then one byte (two from 256 on, the higher one first) or one
// decimal number for each pixel.

namespace vandplan::io {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class Reader {
 public:
  Reader(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  /// The next decimal number.
  std::uint64_t number(const char* name, std::uint64_t most) {
    skip_blanks();
    std::uint64_t value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (at_ == text_.size()) fail(fmt::format("ends before its {}", name), "a whole PGM image");
    if (error == std::errc::invalid_argument) {
      fail(fmt::format("has no {} at byte {}", name, at_), "a decimal number");
    }
    if (error != std::errc() || value > most) {
      fail(fmt::format("has a {} of {}", name, std::string(begin, end)),
           fmt::format("at most {}", most));
    }
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  /// What follows the single blank behind the header.
  std::string_view raster() {
    if (at_ == text_.size() || !is_blank(text_[at_])) {
      fail("has no pixels behind its header", "a blank and then the pixels");
    }
    return text_.substr(at_ + 1);
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const {
    throw InputError(where_, problem + ", expected " + expected);
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_ < text_.size()) ++at_;
    }
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 2;  // behind the magic number
};

void read_binary(Reader& reader, const ImageShape& shape, const TakeRow& take_row) {
  const std::string_view raster = reader.raster();
  const auto columns = static_cast<std::size_t>(shape.columns);
  const std::size_t width = shape.white < 256 ? 1 : 2;
  const std::size_t needed = columns * static_cast<std::size_t>(shape.rows) * width;
  if (raster.size() < needed) {
    reader.fail(fmt::format("ends after {} of {} bytes of pixels", raster.size(), needed),
                "a whole PGM image");
  }
  std::vector<std::uint32_t> row(columns);
  for (std::size_t at = 0; at < needed; at += columns * width) {
    for (std::size_t i = 0; i < columns; ++i) {
      const auto byte = [&](std::size_t k) {
        return static_cast<unsigned char>(raster[at + width * i + k]);
      };
      row[i] = width == 1 ? byte(0) : byte(0) * 256U + byte(1);
      if (row[i] > shape.white) {
        reader.fail(fmt::format("has a pixel of {}", row[i]),
                    fmt::format("at most {}", shape.white));
      }
    }
    take_row(shape, row);
  }
}

void read_decimal(Reader& reader, const ImageShape& shape, const TakeRow& take_row) {
  std::vector<std::uint32_t> row(static_cast<std::size_t>(shape.columns));
  for (std::int32_t i = 0; i < shape.rows; ++i) {
    for (std::uint32_t& pixel : row) {
      pixel = static_cast<std::uint32_t>(reader.number("pixel", shape.white));
    }
    take_row(shape, row);
  }
}

}  // namespace

void read_pgm(const std::string& bytes, const std::string& where, const TakeRow& take_row) {
  Reader reader(bytes, where);
  constexpr std::uint64_t largest_side = INT64_MAX;
  const std::uint64_t columns = reader.number("width", largest_side);
  const std::uint64_t rows = reader.number("height", largest_side);
  check_image_size(columns, rows, where);
  const std::uint64_t greatest = reader.number("greatest value", 65535);
  if (greatest == 0) reader.fail("has a greatest value of 0", "1 to 65535");
  const ImageShape shape{static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
                         static_cast<std::uint32_t>(greatest)};
  // A pixel takes a byte at least.
  check_image_bytes(shape, bytes.size(), static_cast<double>(columns * rows), "PGM", where);
  if (bytes[1] == '5') {
    read_binary(reader, shape, take_row);
  } else {
    read_decimal(reader, shape, take_row);
  }
}

}  // namespace vandplan::io
