// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any bytes as a table file; the check sum is put right, and every table is asked.

#include <string>

#include "fuzz/fuzz.h"
#include "tables/table_bytes.h"
#include "vandplan/tables.h"

using namespace vandplan;

namespace {

void ask(const HeuristicTable& table) {
  for (const double radius : {1e-6, 0.5, 7.0, 1e6}) {
    for (const double far : {0.0, 0.3, 9.9, 12.0, 1e6}) {
      (void)table.distance({-far, far / 3, far}, {1, 2, -3}, radius);
      (void)table.distance({far, -far, 3}, {}, radius);
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes = fuzz::text_of(data, size);
  fuzz::may_refuse([&] { (void)table_file_head(bytes, "fuzz.tab"); });
  fuzz::may_refuse([&] { check_table_file(bytes, "fuzz.tab"); });
  if (bytes.size() >= tables::table_bytes::head_size) tables::table_bytes::seal(bytes);
  fuzz::may_refuse([&] {
    const HeuristicTable table = table_from_bytes(bytes, "fuzz.tab");
    fuzz::expect(table_to_bytes(table) == bytes, "what is read is written again");
    ask(table);
  });
  return 0;
}
