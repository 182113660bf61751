// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does it cost to make a table, and to make a file of it? The argument is the number of the
// thesis' table.
#include <benchmark/benchmark.h>

#include "vandplan/tables.h"

namespace vandplan {
namespace {

void count_entries(benchmark::State& state, const HeuristicTable& table) {
  const auto entries = static_cast<std::int64_t>(table.entries().size());
  state.SetItemsProcessed(state.iterations() * entries);
}

void BM_build(benchmark::State& state) {
  const int number = static_cast<int>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(HeuristicTable(thesis_table_options(number)));
  }
  count_entries(state, thesis_table(number));
}
BENCHMARK(BM_build)->Name("build")->DenseRange(1, 4)->Unit(benchmark::kMillisecond);

void BM_write(benchmark::State& state) {
  const HeuristicTable table = thesis_table(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(table_to_bytes(table));
  count_entries(state, table);
}
BENCHMARK(BM_write)->Name("table_to_bytes")->Arg(4)->Unit(benchmark::kMillisecond);

void BM_read(benchmark::State& state) {
  const HeuristicTable table = thesis_table(static_cast<int>(state.range(0)));
  const std::string bytes = table_to_bytes(table);
  for (auto _ : state) benchmark::DoNotOptimize(table_from_bytes(bytes, "t.table"));
  count_entries(state, table);
}
BENCHMARK(BM_read)->Name("table_from_bytes")->Arg(4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vandplan
