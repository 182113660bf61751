// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/compare.h"

#include <filesystem>

#include "evaluation/runner.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {

std::string store_file(const std::string& folder) { return folder + "/runs.sqlite"; }

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder, "cannot be made a folder: " + error.message());
}

Store store_in(const std::string& folder) {
  make_folder(folder);
  const std::string file = store_file(folder);
  return std::filesystem::exists(file) ? Store::open(file) : Store::create(file);
}

Comparison write_report(const Report& report, const std::string& folder) {
  Comparison comparison{.headline = headline_markdown(report),
                        .json = headline_json(report),
                        .store = store_file(folder),
                        .page = folder + "/index.html",
                        .text = folder + "/report.md",
                        .gallery = folder + "/gallery.png"};
  const std::string gallery = gallery_png(report);
  write_file(comparison.text, report_markdown(report));
  write_file(comparison.gallery, gallery);
  write_file(comparison.page, report_html(report, gallery));
  return comparison;
}

Comparison compare(const Campaign& campaign, const std::string& folder,
                   const RunnerOptions& options) {
  static_cast<void>(explain_runs(campaign));  // throws for a bad campaign before anything is made
  Store store = store_in(folder);
  if (const auto shard = store.shard()) {
    throw InputError(store_file(folder), "holds shard " + text_of(shard->shard) +
                                             " of a campaign, expected another --output");
  }
  const Progress progress = run_campaign(campaign, store, options);
  Comparison comparison = write_report(make_report(store, campaign), folder);
  comparison.missing = progress.total - progress.kept - progress.done;
  return comparison;
}

}  // namespace vandplan::evaluation
