// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a rectangle of bits kept, and which runs of ones does a box meet?

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vandplan::geometry {

/// A rectangle of cells: columns `x_min` to `x_max` and rows `y_min` to `y_max`, ends included.
struct CellBox {
  std::int32_t x_min, x_max, y_min, y_max;
};

/// The box with `by` more cells on each side.
[[nodiscard]] inline CellBox widened(const CellBox& box, std::int32_t by) noexcept {
  return {box.x_min - by, box.x_max + by, box.y_min - by, box.y_max + by};
}

/// The cells that two boxes share.
[[nodiscard]] inline CellBox shared(const CellBox& a, const CellBox& b) noexcept {
  return {std::max(a.x_min, b.x_min), std::min(a.x_max, b.x_max), std::max(a.y_min, b.y_min),
          std::min(a.y_max, b.y_max)};
}

[[nodiscard]] inline bool is_empty(const CellBox& box) noexcept {
  return box.x_min > box.x_max || box.y_min > box.y_max;
}

/// A rectangle of bits, row by row in words of 64 bits.
class BitGrid {
 public:
  BitGrid() = default;
  /// A rectangle of zeros.
  BitGrid(std::int32_t columns, std::int32_t rows)
      : columns_(columns),
        rows_(rows),
        words_((static_cast<std::size_t>(columns) + 63) / 64),
        bits_(words_ * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t words() const noexcept { return words_; }  ///< words of a row

  /// The i-th word of a row; the lowest bit is the leftmost column.
  [[nodiscard]] std::uint64_t& word(std::size_t i, std::int32_t y) noexcept {
    return bits_[static_cast<std::size_t>(y) * words_ + i];
  }
  [[nodiscard]] std::uint64_t word(std::size_t i, std::int32_t y) const noexcept {
    return bits_[static_cast<std::size_t>(y) * words_ + i];
  }

  [[nodiscard]] bool is_set(std::int32_t x, std::int32_t y) const noexcept {
    const auto column = static_cast<std::size_t>(x);
    return (word(column / 64, y) >> (column % 64) & 1U) != 0;
  }
  void set(std::int32_t x, std::int32_t y) noexcept {
    const auto column = static_cast<std::size_t>(x);
    word(column / 64, y) |= std::uint64_t{1} << (column % 64);
  }
  void clear(std::int32_t x, std::int32_t y) noexcept {
    const auto column = static_cast<std::size_t>(x);
    word(column / 64, y) &= ~(std::uint64_t{1} << (column % 64));
  }

  /// Calls `visit(y, x_begin, x_end)` for the runs of ones that meet a box, until a call returns
  /// true. Returns whether one did. Runs are cut where words end, and do not include `x_end`.
  template <typename Visit>
  [[nodiscard]] bool any_run(CellBox box, Visit visit) const {
    box = {std::max(box.x_min, 0), std::min(box.x_max, columns_ - 1), std::max(box.y_min, 0),
           std::min(box.y_max, rows_ - 1)};
    if (box.x_min > box.x_max) return false;
    const auto first = static_cast<std::size_t>(box.x_min) / 64;
    const auto last = static_cast<std::size_t>(box.x_max) / 64;
    for (std::int32_t y = box.y_min; y <= box.y_max; ++y) {
      for (std::size_t i = first; i <= last; ++i) {
        const std::uint64_t bits = word(i, y);
        if (bits == 0) continue;
        const auto column = static_cast<std::int32_t>(i * 64);
        const auto in_box = [&](std::int32_t begin, std::int32_t end) {
          return column + end > box.x_min && column + begin <= box.x_max &&
                 visit(y, column + begin, column + end);
        };
        if (any_run_in(bits, in_box)) return true;
      }
    }
    return false;
  }

 private:
  template <typename Visit>
  [[nodiscard]] static bool any_run_in(std::uint64_t bits, Visit visit) {
    while (bits != 0) {
      const int begin = std::countr_zero(bits);
      const int end = begin + std::countr_one(bits >> begin);
      if (visit(begin, end)) return true;
      if (end == 64) break;
      bits &= ~std::uint64_t{0} << end;
    }
    return false;
  }

  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace vandplan::geometry
