// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/pgm.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "vandplan/input_error.h"

// https://netpbm.sourceforge.net/doc/pgm.html: magic number, width, height, greatest value,
// separated by blanks and comments. Then each pixel: one byte (two from 256 on, high byte first) or
// a decimal number.

namespace vandplan::io {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class Reader {
 public:
  explicit Reader(FileReader& file) : file_(file) {
    constexpr std::size_t magic_number = 2;  // bytes
    (void)bytes(magic_number);
  }

  /// Next decimal number.
  std::uint64_t number(const char* name, std::uint64_t most) {
    skip_blanks();
    const std::string_view text = file_.ahead(longest_number).substr(0, longest_number);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty()) fail(fmt::format("ends before its {}", name), "a whole PGM image");
    if (error == std::errc::invalid_argument) {
      fail(fmt::format("has no {} at byte {}", name, at_), "a decimal number");
    }
    const auto size = static_cast<std::size_t>(end - text.data());
    if (error != std::errc() || value > most || size == longest_number) {
      fail(fmt::format("has a {} of {}", name, text.substr(0, size)),
           fmt::format("at most {}", most));
    }
    skip(size);
    return value;
  }

  /// Reads the single blank after the header.
  void blank() {
    const std::string_view next = file_.ahead(1);
    if (next.empty() || !is_blank(next.front())) {
      fail("has no pixels behind its header", "a blank and then the pixels");
    }
    skip(1);
  }

  /// Next `count` bytes; fewer at the end of the file.
  std::string_view bytes(std::size_t count) {
    const std::string_view next = file_.ahead(count).substr(0, count);
    skip(next.size());
    return next;
  }

  /// Number of bytes left.
  [[nodiscard]] std::size_t left() { return file_.size(largest_image) - at_; }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const {
    throw InputError(file_.name(), problem + ", expected " + expected);
  }

 private:
  // Longest number, with leading zeros [bytes].
  static constexpr std::size_t longest_number = 1024;

  void skip(std::size_t count) {
    file_.skip(count);
    at_ += count;
  }

  void skip_blanks() {
    bool is_comment = false;  // Whether the position is in a comment, which ends with its line.
    for (std::string_view next = file_.ahead(1); !next.empty(); next = file_.ahead(1)) {
      const char c = next.front();
      is_comment = is_comment ? c != '\n' : c == '#';
      if (!is_comment && !is_blank(c)) return;
      skip(1);
    }
  }

  FileReader& file_;
  std::size_t at_ = 0;  // Bytes read.
};

void read_binary(Reader& reader, const ImageShape& shape, const TakeRow& take_row) {
  reader.blank();
  const auto columns = static_cast<std::size_t>(shape.columns);
  const std::size_t width = shape.white < 256 ? 1 : 2;
  const std::size_t needed = columns * static_cast<std::size_t>(shape.rows) * width;
  const auto expect_whole = [&](std::size_t found) {
    if (found >= needed) return;
    reader.fail(fmt::format("ends after {} of {} bytes of pixels", found, needed),
                "a whole PGM image");
  };
  expect_whole(reader.left());
  std::vector<std::uint32_t> row(columns);
  for (std::size_t at = 0; at < needed; at += columns * width) {
    const std::string_view raster = reader.bytes(columns * width);
    if (raster.size() < columns * width) expect_whole(at + raster.size());
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(raster[i]); };
    for (std::size_t i = 0; i < columns; ++i) {
      row[i] = width == 1 ? byte(i) : byte(2 * i) * 256U + byte(2 * i + 1);
    }
    const std::uint32_t brightest = *std::max_element(row.begin(), row.end());
    if (brightest > shape.white) {
      reader.fail(fmt::format("has a pixel of {}", brightest),
                  fmt::format("at most {}", shape.white));
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

void read_pgm(FileReader& file, const TakeRow& take_row) {
  const bool is_binary = file.ahead(2).substr(0, 2) == "P5";
  Reader reader(file);
  constexpr std::uint64_t largest_side = INT64_MAX;
  const std::uint64_t columns = reader.number("width", largest_side);
  const std::uint64_t rows = reader.number("height", largest_side);
  check_image_size(columns, rows, file.name());
  const std::uint64_t greatest = reader.number("greatest value", 65535);
  if (greatest == 0) reader.fail("has a greatest value of 0", "1 to 65535");
  const ImageShape shape{static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
                         static_cast<std::uint32_t>(greatest)};
  // A pixel takes at least one byte.
  check_image_bytes(shape, file.size(largest_image), static_cast<double>(columns * rows), "PGM",
                    file.name());
  if (is_binary) {
    read_binary(reader, shape, take_row);
  } else {
    read_decimal(reader, shape, take_row);
  }
}

}  // namespace vandplan::io
