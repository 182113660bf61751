// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How do the stores of all shards become one store that does not depend on the number of shards?
//
// Rows are ordered by the input: scenario, goal, region, planner, options, seed. SQLite then writes
// the tables anew in that order. SQL does everything, so no run has to fit in memory.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "evaluation/compare.h"
#include "evaluation/runner.h"
#include "evaluation/shards.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

namespace fs = std::filesystem;

struct Part {
  std::string file;
  StoredShard shard;
  std::vector<Environment> environments;
};

std::string file_of_store(const std::string& store) {
  return fs::is_directory(store) ? store_file(store) : store;
}

// Reads the head of a shard's store. Throws InputError when the store is no complete shard.
Part part_in(const std::string& named) {
  const std::string file = file_of_store(named);
  Store store = Store::open(file);
  const std::optional<StoredShard> shard = store.shard();
  if (!shard) throw InputError(file, "holds no shard of a campaign, expected what --shard made");
  const std::string name = "shard " + text_of(shard->shard);
  const int runs = store.count_runs();
  std::vector<Environment> environments = store.environments();
  if (environments.size() > 1) {
    throw InputError(file, fmt::format("{} was run by {} programs or kinds of machine, expected "
                                       "one: what they find cannot be compared",
                                       name, environments.size()));
  }
  if (runs != shard->runs) {
    throw InputError(file, fmt::format("{} holds {} of its {} runs, expected all of them: --resume "
                                       "does the rest",
                                       name, runs, shard->runs));
  }
  return {file, *shard, std::move(environments)};
}

void check_alike(const Part& first, const Part& part) {
  const std::string name = "shard " + text_of(part.shard.shard);
  if (part.shard.shard.of != first.shard.shard.of) {
    throw InputError(part.file, fmt::format("is {}, expected one of {} as {}", name,
                                            first.shard.shard.of, first.file));
  }
  const std::string differs = difference(part.shard.campaign, first.shard.campaign);
  if (!differs.empty()) {
    throw InputError(
        part.file, fmt::format("{} is of another campaign than {}: {}", name, first.file, differs));
  }
  if (part.environments != first.environments) {
    throw InputError(part.file, fmt::format("{} was run by another program or kind of machine than "
                                            "{}: what they find cannot be compared",
                                            name, first.file));
  }
}

// Parts of a campaign, in the order of their numbers. Throws InputError unless they are complete.
std::vector<Part> parts_of(const std::vector<std::string>& stores) {
  std::vector<Part> parts;
  for (const std::string& store : stores) {
    parts.push_back(part_in(store));
    check_alike(parts.front(), parts.back());
  }
  std::map<int, const Part*> by_number;
  for (const Part& part : parts) {
    const auto [twin, is_new] = by_number.try_emplace(part.shard.shard.number, &part);
    if (!is_new) {
      throw InputError(part.file, fmt::format("is shard {} as {} is, expected each once",
                                              text_of(part.shard.shard), twin->second->file));
    }
  }
  const int of = parts.front().shard.shard.of;
  std::string missing;
  for (int number = 1; number <= of; ++number) {
    if (by_number.contains(number)) continue;
    missing += fmt::format("{}{}", missing.empty() ? "" : ", ", number);
  }
  if (!missing.empty())
    throw InputError("--merge", fmt::format("of {} shards these are missing: {}", of, missing));
  std::ranges::sort(parts, {}, [](const Part& part) { return part.shard.shard.number; });
  return parts;
}

// Attaches another store's tables under the name "part".
class Attached {
 public:
  Attached(Database& database, const std::string& file) : database_(database) {
    Statement(database_, "ATTACH ? AS part").run(file);
  }
  ~Attached() {
    try {
      database_.execute("DETACH part");
    } catch (const InputError&) {  // closing the database detaches it too
    }
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;

 private:
  Database& database_;
};

void copy_head(Database& whole, const Part& part) {
  const Attached attached(whole, part.file);
  for (const char* const table : {"environments", "maps", "scenarios"})
    whole.execute(fmt::format("INSERT INTO {0} SELECT * FROM part.{0}", table));
}

// Compares the maps of a shard with ours, because the description of a campaign has no maps.
void check_scenarios(Database& whole, const Part& part) {
  constexpr const char* columns = "SELECT id, yaml, ifnull(map, '') FROM";
  const auto differing = whole.integer(
      fmt::format("SELECT count(*) FROM ({0} part.scenarios EXCEPT {0} main.scenarios)", columns));
  if (differing != 0) {
    throw InputError(part.file,
                     fmt::format("shard {} was run on other maps", text_of(part.shard.shard)));
  }
}

void copy_configurations(Database& whole, const std::vector<Part>& parts) {
  whole.execute(
      "CREATE TEMP TABLE found(planner TEXT, options TEXT, PRIMARY KEY(planner, options))"
      " WITHOUT ROWID");
  for (const Part& part : parts) {
    const Attached attached(whole, part.file);
    check_scenarios(whole, part);
    whole.execute("INSERT OR IGNORE INTO found SELECT planner, options FROM part.configurations");
  }
  whole.execute(
      "INSERT INTO configurations SELECT NULL, planner, options FROM found ORDER BY 2, 3");
}

// Assigns new ids to the runs of all shards, from 1 in the order of the input.
void rank_runs(Database& whole, const std::vector<Part>& parts) {
  whole.execute(
      "CREATE TEMP TABLE keys(part INTEGER, run INTEGER, scenario INTEGER, goal INTEGER,"
      " region TEXT, configuration INTEGER, seed INTEGER)");
  for (const Part& part : parts) {
    const Attached attached(whole, part.file);
    whole.execute(fmt::format(
        "INSERT INTO keys SELECT {}, r.id, scenario, goal, region, ours.id, seed FROM part.runs r"
        " JOIN part.configurations theirs ON theirs.id = configuration"
        " JOIN main.configurations ours USING (planner, options)",
        part.shard.shard.number));
  }
  whole.execute(
      "CREATE TEMP TABLE ranks(part INTEGER, id INTEGER, run INTEGER, configuration INTEGER,"
      " PRIMARY KEY(part, id)) WITHOUT ROWID;"
      "INSERT INTO ranks SELECT part, row_number() OVER (ORDER BY scenario, goal, region,"
      " configuration, seed), run, configuration FROM keys;"
      "DROP TABLE keys");
}

// Columns of measured values. Where every machine finds the same, times are not kept: infinite
// means unknown.
struct Measured {
  const char* columns;
  const char* time;
};
constexpr Measured all_times = {
    "jobs, started, status, reason, cost, start_x, start_y, start_heading, iterations, time_total,"
    " nodes, exact_solves, edge_checks, time_ranking, time_steering, time_checking, time_setup",
    "time"};
constexpr Measured no_times = {
    "1, '', status, reason, cost, start_x, start_y, start_heading, iterations, 9e999,"
    " nodes, exact_solves, edge_checks, NULL, NULL, NULL, NULL",
    "9e999"};

void copy_runs(Database& whole, const Part& part, bool is_repeatable) {
  const Attached attached(whole, part.file);
  const Measured& measured = is_repeatable ? no_times : all_times;
  const auto copy = [&](const char* table, const std::string& columns, const char* of_run) {
    whole.execute(
        fmt::format("INSERT INTO {0} SELECT ranks.id, {1} FROM ranks CROSS JOIN part.{0}"
                    " WHERE ranks.part = {2} AND {3} = ranks.run ORDER BY ranks.id",
                    table, columns, part.shard.shard.number, of_run));
  };
  copy("runs",
       fmt::format("environment, scenario, goal, ranks.configuration, region, seed, {}",
                   measured.columns),
       "runs.id");
  copy("costs", fmt::format("number, {}, iteration, cost", measured.time), "costs.run");
  copy("segments", "number, curvature, length, curvature_rate", "segments.run");
  if (is_repeatable) return;
  whole.execute(
      "INSERT INTO sessions SELECT NULL, environment, started, jobs, runs, wall_time,"
      " planning_time, judging_time, storing_time FROM part.sessions ORDER BY id");
}

// Whether a store names no machine, because every machine repeats its runs.
bool names_no_machine(const std::vector<Environment>& environments) {
  return environments.empty() || environments.front().cores == 0;
}

void join(const std::vector<Part>& parts, const std::string& file) {
  const std::string unordered = file + ".merging", unfinished = file + ".new";
  for (const std::string& scrap : {unordered, unfinished}) fs::remove(scrap);
  { const Store empty = Store::create(unordered); }
  {
    Database whole(unordered, Database::Mode::write);
    // Nobody else sees the file before it is written anew below, so it needs no journal.
    whole.execute(
        "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA cache_size = -200000");
    copy_head(whole, parts.front());
    copy_configurations(whole, parts);
    rank_runs(whole, parts);
    for (const Part& part : parts) copy_runs(whole, part, names_no_machine(part.environments));
    Statement(whole, "VACUUM INTO ?").run(unfinished);
  }
  fs::remove(unordered);
  fs::rename(unfinished, file);
}

}  // namespace

bool is_shard(const std::string& store) {
  return Store::open(file_of_store(store)).shard().has_value();
}

Progress run_shard(const Campaign& campaign, const std::string& folder,
                   const RunnerOptions& options) {
  const StoredShard wanted = stored_shard(campaign, static_cast<int>(runs_of(campaign).size()));
  const std::string file = store_file(folder);
  const bool is_new = !fs::exists(file);
  Store store = store_in(folder);
  const std::optional<StoredShard> found = store.shard();
  if (!found && (is_new || store.count_runs() == 0)) {
    store.set(wanted);
  } else if (!found || found->shard != wanted.shard) {
    throw InputError(file,
                     fmt::format("holds {}, expected another --output for shard {}",
                                 found ? "shard " + text_of(found->shard) : "a whole campaign",
                                 text_of(wanted.shard)));
  } else if (*found != wanted) {
    throw InputError(
        file, "holds a shard of another campaign: " + difference(found->campaign, wanted.campaign));
  }
  return run_campaign(campaign, store, options);
}

Comparison merge_shards(const std::vector<std::string>& stores, const std::string& folder) {
  const std::vector<Part> parts = parts_of(stores);
  const std::string file = store_file(folder);
  if (fs::exists(file)) throw InputError(file, "exists already, expected another --output");
  make_folder(folder);
  join(parts, file);
  Store store = Store::open(file);
  return write_report(make_report(store), folder);
}

}  // namespace vandplan::evaluation
