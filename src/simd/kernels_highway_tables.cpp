// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The look-ups of table_kernels_scalar.cpp and bound_kernels_scalar.cpp in vectors: the same
// operations in the same order, so the same bits.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "simd/bound_kernels.h"
#include "simd/table_kernels.h"
#include "simd/target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/kernels_highway_tables.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "simd/kernels_highway-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {
namespace {

Ints whole(Floats value) { return hn::ConvertTo(I(), value); }
Floats real(Ints value) { return hn::ConvertTo(F(), value); }

/// Calls `step(i)` so that lanes from i on cover all of 0 ... count - 1; some of them twice.
/// `count` is at least the number of lanes.
template <typename Step>
void for_all_lanes(std::size_t count, Step step) {
  const std::size_t lanes = hn::Lanes(F());
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) step(i);
  if (i < count) step(count - lanes);
}

Floats mirrored_in_y(Floats heading) {
  const Floats mirrored = hn::Sub(set(pi), heading);
  return hn::IfThenElse(hn::Gt(mirrored, set(pi)), hn::Sub(mirrored, set(2 * pi)), mirrored);
}

/// Whole numbers clamped to [least, most], those that NaN became, too.
Ints between(Ints value, int least, int most) {
  return hn::Min(hn::Max(value, set(least)), set(most));
}

Ints nearest_heading(const TableView& table, Floats heading) {
  const Floats cell = hn::Mul(hn::Add(heading, set(pi)), set(table.cells_per_radian));
  return between(whole(hn::Add(cell, set(0.5F))), 0, table.headings - 1);
}

Floats table_distance(const TableView& table, Floats dx, Floats dy, Floats node, Floats sample) {
  const Floats zero = hn::Zero(F());
  const Floats x = hn::Mul(hn::Abs(dx), set(table.to_table));
  const Floats y = hn::Mul(hn::Abs(dy), set(table.to_table));
  const auto inside = hn::And(hn::Lt(x, set(table.extent)), hn::Lt(y, set(table.extent)));
  const Floats euclid = hn::Sqrt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)));
  const auto below = hn::Lt(dy, zero);
  const auto behind = hn::Lt(dx, zero);
  node = hn::IfThenElse(below, hn::Neg(node), node);
  sample = hn::IfThenElse(below, hn::Neg(sample), sample);
  node = hn::IfThenElse(behind, mirrored_in_y(node), node);
  sample = hn::IfThenElse(behind, mirrored_in_y(sample), sample);
  const Ints ix = whole(hn::Mul(x, set(table.cells_per_metre)));
  const Ints iy = whole(hn::Mul(y, set(table.cells_per_metre)));
  const Ints headings = set(table.headings);  // table_index in lanes
  Ints cell = hn::Add(hn::Mul(ix, set(table.positions)), iy);
  cell = hn::Add(hn::Mul(cell, headings), nearest_heading(table, node));
  cell = hn::Add(hn::Mul(cell, headings), nearest_heading(table, sample));
  cell = hn::IfThenElseZero(hn::RebindMask(I(), inside), cell);
  const Floats entry = hn::GatherIndex(F(), table.entries, cell);
  return hn::IfThenElse(inside, hn::Mul(entry, set(table.from_table)), euclid);
}

void many_table_distances(const TableView& table, const float* x, const float* y,
                          const float* heading, const TableSample& sample, float* out,
                          std::size_t count) {
  const F d;
  for_all_lanes(count, [&](std::size_t i) {
    const Floats dx = hn::Sub(hn::LoadU(d, x + i), set(sample.x));
    const Floats dy = hn::Sub(hn::LoadU(d, y + i), set(sample.y));
    hn::StoreU(table_distance(table, dx, dy, hn::LoadU(d, heading + i), set(sample.heading)), d,
               out + i);
  });
}

struct Direction {
  Floats sin, cos;
};

Direction direction_up_to_sign(Floats angle) {
  const Floats turns = hn::Round(hn::Mul(angle, set(1 / pi)));
  const Floats x =
      hn::Sub(hn::Sub(angle, hn::Mul(turns, set(pi))), hn::Mul(turns, set(rest_of_pi)));
  const Floats x2 = hn::Mul(x, x);
  return {hn::Mul(x, horner(sine_series, x2)), horner(cosine_series, x2)};
}

struct Place {
  Ints cell;
  Floats across;
};

/// The cell of a coordinate in [0, 1] among `cells` cells, and the place across this cell.
Place place(Floats coordinate, int cells) {
  const Floats scaled = hn::Mul(coordinate, set(static_cast<float>(cells)));
  const Ints cell = between(whole(scaled), 0, cells - 1);
  return {cell, hn::Sub(scaled, real(cell))};
}

constexpr std::size_t block = 128;  ///< nodes that are looked up together
/// Nodes that are looked up together, before and after the table is read.
struct Block {
  HWY_ALIGN float radial[block], side[block], turn[block];  // place across the cell, in [0, 1]
  HWY_ALIGN float distance[block], least[block];            // [turning radii]
  HWY_ALIGN std::int32_t cell[block];
  HWY_ALIGN BoundEntry entry[block];
};

void find_cells(const float* x, const float* y, const float* heading, const BoundSample& sample,
                float radius, std::size_t count, Block& nodes) {
  const F d;
  for_all_lanes(count, [&](std::size_t i) {
    const Floats dx = hn::Sub(hn::LoadU(d, x + i), set(sample.x));
    const Floats dy = hn::Sub(hn::LoadU(d, y + i), set(sample.y));
    const Floats node = hn::LoadU(d, heading + i);
    const Floats mean = hn::Mul(set(0.5F), hn::Add(node, set(sample.heading)));
    const auto [sin, cos] = direction_up_to_sign(mean);
    const Floats along = hn::Abs(hn::Add(hn::Mul(dx, cos), hn::Mul(dy, sin)));
    const Floats across = hn::Abs(hn::Sub(hn::Mul(dy, cos), hn::Mul(dx, sin)));
    const Floats difference = hn::Abs(hn::Sub(node, set(sample.heading)));
    const Floats other_way = hn::Sub(set(2 * pi), difference);
    const Floats turn = hn::Max(hn::Min(difference, other_way), hn::Zero(F()));
    const Floats square = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    const Floats distance = hn::Mul(hn::Sqrt(square), set(1.0F / radius));

    const Floats shifted = hn::Add(distance, set(static_cast<float>(radial_reach)));
    const Floats sum = hn::Max(hn::Add(along, across), set(1e-30F));
    const Place u = place(hn::Div(distance, shifted), radial_cells);
    const Place v = place(hn::Div(across, sum), side_cells);
    const Place w = place(hn::Mul(turn, set(1 / pi)), turn_cells);
    const Ints row = hn::Add(hn::Mul(u.cell, set(side_cells)), v.cell);
    hn::StoreU(hn::Add(hn::Mul(row, set(turn_cells)), w.cell), I(), nodes.cell + i);
    hn::StoreU(u.across, d, nodes.radial + i);
    hn::StoreU(v.across, d, nodes.side + i);
    hn::StoreU(w.across, d, nodes.turn + i);
    hn::StoreU(distance, d, nodes.distance + i);
    hn::StoreU(hn::Sub(turn, set(4 * noise)), d, nodes.least + i);
  });
}

template <int skip, int count>
Floats signed_bits(Ints word) {
  return real(hn::ShiftRight<32 - count>(hn::ShiftLeft<skip>(word)));
}

void find_bounds(const Block& nodes, float radius, std::size_t count, float* low, float* high) {
  const F d;
  for_all_lanes(count, [&](std::size_t i) {
    Ints base_width, slopes;
    hn::LoadInterleaved2(I(), reinterpret_cast<const std::int32_t*>(nodes.entry + i), base_width,
                         slopes);
    const Floats base = signed_bits<0, 16>(base_width);
    const Floats width = real(hn::And(base_width, set(0xFFFF)));
    const Floats flat = hn::Add(hn::Mul(signed_bits<0, 11>(slopes), hn::LoadU(d, nodes.radial + i)),
                                hn::Mul(signed_bits<11, 11>(slopes), hn::LoadU(d, nodes.side + i)));
    const Floats turned =
        hn::Add(base, hn::Mul(signed_bits<22, 10>(slopes), hn::LoadU(d, nodes.turn + i)));
    const Floats excess = hn::Add(turned, hn::Mul(set(1.0F * slope_step), flat));
    const Floats unit = set(static_cast<float>(bound_unit));
    const Floats distance = hn::LoadU(d, nodes.distance + i);
    const Floats above = hn::Mul(hn::Max(excess, hn::Zero(F())), unit);
    const Floats least = hn::LoadU(d, nodes.least + i);
    const Floats lowest = hn::Max(hn::Add(hn::Mul(distance, set(1 - noise)), above), least);
    const Floats highest =
        hn::Add(hn::Mul(distance, set(1 + noise)), hn::Mul(hn::Add(excess, width), unit));
    hn::StoreU(hn::Mul(lowest, set(radius)), d, low + i);
    hn::StoreU(hn::Mul(highest, set(radius)), d, high + i);
  });
}

/// Three loops instead of one keep more nodes in flight, and plain loads of entries are faster than
/// gathering them: 3.3 instead of 5.2 ns per node (bench bound_table, AVX2).
void many_length_bounds(const BoundEntry* entries, const float* x, const float* y,
                        const float* heading, const BoundSample& sample, float radius, float* low,
                        float* high, std::size_t count) {
  const std::size_t lanes = hn::Lanes(F());
  Block nodes;
  for (std::size_t i = 0; i < count; i += block) {
    const std::size_t rest = std::min(count - i, block);
    const std::size_t size = std::max(rest, lanes);  // a short rest repeats nodes before it
    const std::size_t at = i + rest - size;
    find_cells(x + at, y + at, heading + at, sample, radius, size, nodes);
    for (std::size_t k = 0; k < size; ++k) nodes.entry[k] = entries[nodes.cell[k]];
    find_bounds(nodes, radius, size, low + at, high + at);
  }
}

std::size_t lanes() { return hn::Lanes(F()); }

const char* target() { return hwy::TargetName(HWY_TARGET); }

}  // namespace
}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vandplan::simd {
namespace {

HWY_EXPORT(many_table_distances);
HWY_EXPORT(many_length_bounds);
HWY_EXPORT(lanes);
HWY_EXPORT(target);

}  // namespace

std::string_view simd_target() noexcept { return HWY_DYNAMIC_DISPATCH(target)(); }

void table_distances(const TableView& table, std::span<const float> x, std::span<const float> y,
                     std::span<const float> heading, const TableSample& sample,
                     std::span<float> out) noexcept {
  if (out.size() < HWY_DYNAMIC_DISPATCH(lanes)()) {
    return scalar::table_distances(table, x, y, heading, sample, out);
  }
  HWY_DYNAMIC_DISPATCH(many_table_distances)
  (table, x.data(), y.data(), heading.data(), sample, out.data(), out.size());
}

void length_bounds(const BoundEntry* entries, std::span<const float> x, std::span<const float> y,
                   std::span<const float> heading, const BoundSample& sample, float radius,
                   std::span<float> low, std::span<float> high) noexcept {
  if (low.size() < HWY_DYNAMIC_DISPATCH(lanes)()) {
    return scalar::length_bounds(entries, x, y, heading, sample, radius, low, high);
  }
  HWY_DYNAMIC_DISPATCH(many_length_bounds)
  (entries, x.data(), y.data(), heading.data(), sample, radius, low.data(), high.data(),
   low.size());
}

}  // namespace vandplan::simd
#endif  // HWY_ONCE
