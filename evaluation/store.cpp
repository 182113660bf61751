// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "evaluation/methods.h"
#include "evaluation/options_json.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

constexpr int application_id = 0x56504c4e;  // "VPLN" in ASCII
constexpr int without_set_up = 3;           // older format, whose runs lack `time_setup`

// Tables of a store. Ids count from 1 in insertion order and nothing is deleted: index = id - 1.
constexpr const char* schema = R"(
CREATE TABLE environments(
  id INTEGER PRIMARY KEY, version TEXT NOT NULL, compiler TEXT NOT NULL, build_type TEXT NOT NULL,
  executable TEXT NOT NULL, processor TEXT NOT NULL, cores INTEGER NOT NULL, system TEXT NOT NULL)
  STRICT;
CREATE TABLE configurations(
  id INTEGER PRIMARY KEY, planner TEXT NOT NULL, options TEXT NOT NULL, UNIQUE(planner, options))
  STRICT;
CREATE TABLE runs(
  id INTEGER PRIMARY KEY,
  environment INTEGER NOT NULL REFERENCES environments(id),
  scenario INTEGER NOT NULL REFERENCES scenarios(id),
  goal INTEGER NOT NULL,
  configuration INTEGER NOT NULL REFERENCES configurations(id),
  region TEXT NOT NULL,
  seed INTEGER NOT NULL,
  jobs INTEGER NOT NULL,
  started TEXT NOT NULL,
  status TEXT NOT NULL, reason TEXT NOT NULL,
  cost REAL, start_x REAL, start_y REAL, start_heading REAL,
  iterations INTEGER NOT NULL, time_total REAL NOT NULL,
  nodes INTEGER, exact_solves INTEGER, edge_checks INTEGER,
  time_ranking REAL, time_steering REAL, time_checking REAL, time_setup REAL,
  UNIQUE(environment, scenario, goal, configuration, region, seed)) STRICT;
CREATE TABLE costs(
  run INTEGER NOT NULL REFERENCES runs(id), number INTEGER NOT NULL,
  time REAL NOT NULL, iteration INTEGER NOT NULL, cost REAL NOT NULL,
  PRIMARY KEY(run, number)) STRICT, WITHOUT ROWID;
CREATE TABLE segments(
  run INTEGER NOT NULL REFERENCES runs(id), number INTEGER NOT NULL,
  curvature REAL NOT NULL, length REAL NOT NULL, curvature_rate REAL NOT NULL,
  PRIMARY KEY(run, number)) STRICT, WITHOUT ROWID;
CREATE TABLE sessions(
  id INTEGER PRIMARY KEY,
  environment INTEGER NOT NULL REFERENCES environments(id),
  started TEXT NOT NULL, jobs INTEGER NOT NULL, runs INTEGER NOT NULL, wall_time REAL NOT NULL,
  planning_time REAL NOT NULL, judging_time REAL NOT NULL, storing_time REAL NOT NULL) STRICT;
)";

std::int64_t id_at(std::size_t index) { return static_cast<std::int64_t>(index) + 1; }
std::size_t index_of_id(std::int64_t id) { return static_cast<std::size_t>(id) - 1; }
std::int64_t signed_seed(std::uint64_t seed) { return static_cast<std::int64_t>(seed); }

PlanStatus status_named(const std::string& name) {
  for (const PlanStatus status : plan_statuses())
    if (name == name_of(status)) return status;
  throw InputError("status", "\"" + name + "\" is unknown");
}

Region region_named(const std::string& name) {
  for (const Region region : {Region::bounds, Region::scene})
    if (name == name_of(region)) return region;
  throw InputError("region", "\"" + name + "\" is unknown");
}

// Counters and phases that have columns; NULL where a planner does not count or measure them.
constexpr std::array counters = {"nodes", "exact_solves", "edge_checks"};
constexpr std::array phases = {"ranking", "steering", "checking", "setup"};

std::optional<std::int64_t> counted(const PlanResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.counters, name, &Counter::name);
  return found == result.counters.end() ? std::nullopt : std::optional(found->value);
}

std::optional<double> measured(const PlanResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.phases, name, &PhaseTime::name);
  return found == result.phases.end() ? std::nullopt : std::optional(found->seconds);
}

void check_is_store(Database& database) {
  if (database.integer("PRAGMA application_id") != application_id)
    throw InputError(database.file(), "is not a result store of vandplan");
  const std::int64_t format = database.integer("PRAGMA user_version");
  if (format != Store::format && format != without_set_up) {
    throw InputError(database.file(), fmt::format("is a result store of format {}, expected {}",
                                                  format, Store::format));
  }
  const std::string verdict = database.text("PRAGMA quick_check(1)");
  if (verdict != "ok") throw InputError(database.file(), "is damaged: " + verdict);
  const std::string orphan = database.text("PRAGMA foreign_key_check");
  if (!orphan.empty())
    throw InputError(database.file(), "is damaged: a row of " + orphan + " refers to nothing");
  if (format == without_set_up) {
    database.execute(fmt::format(
        "ALTER TABLE runs ADD COLUMN time_setup REAL; PRAGMA user_version = {}", Store::format));
  }
}

// Columns of the table of runs, in the order in which `run_of` reads them.
constexpr const char* columns_of_runs =
    "id, environment, scenario, goal, configuration, region, seed, jobs, started, status, reason,"
    " iterations, time_total, cost, start_x, start_y, start_heading, nodes, exact_solves,"
    " edge_checks, time_ranking, time_steering, time_checking, time_setup";

RunRecord run_of(const Statement& row) {
  RunRecord run;
  run.environment = index_of_id(row.integer(1));
  run.scenario = index_of_id(row.integer(2));
  run.goal = static_cast<std::size_t>(row.integer(3));
  run.region = region_named(row.text(5));
  run.jobs = static_cast<int>(row.integer(7));
  run.started = row.text(8);
  PlanResult& result = run.result;
  result.status = status_named(row.text(9));
  result.reason = row.text(10);
  result.iterations = row.integer(11);
  result.time_total = row.real(12);
  if (!row.is_null(13)) {
    result.cost = row.real(13);
    result.path = Path{{row.real(14), row.real(15), row.real(16)}, {}};
  }
  int column = 17;
  for (const char* const name : counters) {
    if (!row.is_null(column)) result.counters.push_back({name, row.integer(column)});
    ++column;
  }
  for (const char* const name : phases) {
    if (!row.is_null(column)) result.phases.push_back({name, row.real(column)});
    ++column;
  }
  return run;
}

}  // namespace

// Prepared statements for adding a run, because preparing a statement costs more than running it.
struct Store::Statements {
  explicit Statements(Database& database)
      : find_configuration(database,
                           "SELECT id FROM configurations WHERE planner = ? AND options = ?"),
        add_configuration(database, "INSERT INTO configurations VALUES (NULL, ?, ?)"),
        find_run(database,
                 "SELECT id FROM runs WHERE environment = ? AND scenario = ? AND goal = ?"
                 " AND configuration = ? AND region = ? AND seed = ?"),
        add_run(database, fmt::format("INSERT INTO runs({}) VALUES (NULL{})", columns_of_runs,
                                      repeated(", ?", 23))),
        add_cost(database, "INSERT INTO costs VALUES (?, ?, ?, ?, ?)"),
        add_segment(database, "INSERT INTO segments VALUES (?, ?, ?, ?, ?)") {}

  static std::string repeated(const char* text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  }

  // Id in the first row; 0 if there is no row.
  template <class... Values>
  static std::int64_t find(Statement& statement, const Values&... values) {
    const std::int64_t id = statement.bind(values...).step() ? statement.integer(0) : 0;
    statement.reset();
    return id;
  }

  Statement find_configuration, add_configuration, find_run, add_run, add_cost, add_segment;
};

Store::Store(const std::string& file) : database_(file, Database::Mode::write) {
  check_is_store(database_);
  // With a write-ahead log a commit never waits for the disk. Only clearing the log does, every 16
  // MB. Committed runs survive the death of the program. If the machine dies, the last runs may be
  // lost.
  database_.execute(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;"
      "PRAGMA wal_autocheckpoint = 4096; PRAGMA foreign_keys = ON");
  statements_ = std::make_unique<Statements>(database_);
}

Store::~Store() = default;

Store Store::open(const std::string& file) {
  if (!std::filesystem::exists(file)) throw InputError(file, "does not exist");
  return Store(file);
}

Store Store::create(const std::string& file) {
  if (std::filesystem::exists(file)) throw InputError(file, "exists already");
  if (std::filesystem::is_symlink(file)) throw InputError(file, "is a link to nothing");
  const std::string unfinished = file + ".new";
  std::filesystem::remove(unfinished);
  {
    Database database(unfinished, Database::Mode::create);
    Transaction transaction(database);
    database.execute(tables_of_scenarios);
    database.execute(schema);
    database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                                 application_id, format));
    transaction.commit();
  }
  std::filesystem::rename(unfinished, file);
  return Store(file);
}

std::size_t Store::index_of(const Environment& environment) {
  const std::vector<Environment> known = environments();
  const auto found = std::ranges::find(known, environment);
  if (found == known.end()) {
    Statement(database_, "INSERT INTO environments VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)")
        .run(environment.version, environment.compiler, environment.build_type,
             environment.executable, environment.processor, environment.cores, environment.system);
  }
  return static_cast<std::size_t>(found - known.begin());
}

std::size_t Store::index_of(const StoredScenario& scenario) {
  return evaluation::index_of(database_, scenario);
}

std::int64_t Store::configuration_of(const RunRecord& run) {
  return Statements::find(statements_->find_configuration, run.planner,
                          options_to_json(*run.options));
}

std::int64_t Store::id_of(const RunRecord& run, std::int64_t configuration) {
  return Statements::find(statements_->find_run, id_at(run.environment), id_at(run.scenario),
                          static_cast<std::int64_t>(run.goal), configuration, name_of(run.region),
                          signed_seed(run.seed));
}

bool Store::contains(const RunRecord& run) { return id_of(run, configuration_of(run)) != 0; }

bool Store::insert(const RunRecord& run) {
  std::int64_t configuration = configuration_of(run);
  if (id_of(run, configuration) != 0) return false;
  if (configuration == 0) {
    statements_->add_configuration.run(run.planner, options_to_json(*run.options));
    configuration = database_.last_id();
  }
  const PlanResult& result = run.result;
  std::optional<double> cost, x, y, heading;
  if (result.path) {
    cost = result.cost;
    x = result.path->start.x;
    y = result.path->start.y;
    heading = result.path->start.heading;
  }
  statements_->add_run.run(
      id_at(run.environment), id_at(run.scenario), static_cast<std::int64_t>(run.goal),
      configuration, name_of(run.region), signed_seed(run.seed), run.jobs, run.started,
      name_of(result.status), result.reason, result.iterations, result.time_total, cost, x, y,
      heading, counted(result, counters[0]), counted(result, counters[1]),
      counted(result, counters[2]), measured(result, phases[0]), measured(result, phases[1]),
      measured(result, phases[2]), measured(result, phases[3]));
  const std::int64_t id = database_.last_id();
  int number = 0;
  for (const CostSample& sample : result.anytime)
    statements_->add_cost.run(id, number++, sample.time, sample.iteration, sample.cost);
  if (!result.path) return true;
  number = 0;
  for (const Segment& segment : result.path->segments) {
    statements_->add_segment.run(id, number++, segment.curvature, segment.length,
                                 segment.curvature_rate);
  }
  return true;
}

bool Store::add(const RunRecord& run) {
  Transaction transaction(database_);
  const bool is_new = insert(run);
  transaction.commit();
  return is_new;
}

void Store::add(const Session& session) {
  Statement(database_, "INSERT INTO sessions VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run(id_at(session.environment), session.started, session.jobs, session.runs,
           session.wall_time, session.planning_time, session.judging_time, session.storing_time);
}

int Store::merge(Store& other) {
  Transaction transaction(database_);
  std::vector<std::size_t> environment_indices, scenario_indices;
  for (const Environment& environment : other.environments())
    environment_indices.push_back(index_of(environment));
  for (const StoredScenario& scenario : other.scenarios())
    scenario_indices.push_back(index_of(scenario));
  int added = 0;
  for (RunRecord& run : other.runs()) {
    run.environment = environment_indices.at(run.environment);
    run.scenario = scenario_indices.at(run.scenario);
    added += insert(run);
  }
  const std::vector<Session> known = sessions();
  for (Session session : other.sessions()) {
    session.environment = environment_indices.at(session.environment);
    if (std::ranges::find(known, session) == known.end()) add(session);
  }
  transaction.commit();
  return added;
}

std::optional<StoredShard> Store::shard() {
  if (database_.integer("SELECT count(*) FROM sqlite_schema WHERE name = 'shards'") == 0)
    return std::nullopt;
  Statement row(database_, "SELECT number, total, runs, campaign FROM shards");
  if (!row.step()) return std::nullopt;
  const Shard shard{static_cast<int>(row.integer(0)), static_cast<int>(row.integer(1))};
  return StoredShard{shard, static_cast<int>(row.integer(2)), row.text(3)};
}

void Store::set(const StoredShard& shard) {
  Transaction transaction(database_);
  database_.execute(
      "CREATE TABLE shards(number INTEGER NOT NULL, total INTEGER NOT NULL,"
      " runs INTEGER NOT NULL, campaign TEXT NOT NULL) STRICT");
  Statement(database_, "INSERT INTO shards VALUES (?, ?, ?, ?)")
      .run(shard.shard.number, shard.shard.of, shard.runs, shard.campaign);
  transaction.commit();
}

int Store::count_runs() { return static_cast<int>(database_.integer("SELECT count(*) FROM runs")); }

std::vector<Environment> Store::environments() {
  Statement rows(database_, "SELECT * FROM environments ORDER BY id");
  std::vector<Environment> found;
  while (rows.step()) {
    found.push_back({rows.text(1), rows.text(2), rows.text(3), rows.text(4), rows.text(5),
                     static_cast<int>(rows.integer(6)), rows.text(7)});
  }
  return found;
}

std::vector<StoredScenario> Store::scenarios() { return stored_scenarios(database_); }

std::vector<Session> Store::sessions() {
  Statement rows(database_, "SELECT * FROM sessions ORDER BY id");
  std::vector<Session> found;
  while (rows.step()) {
    found.push_back({index_of_id(rows.integer(1)), rows.text(2), static_cast<int>(rows.integer(3)),
                     static_cast<int>(rows.integer(4)), rows.real(5), rows.real(6), rows.real(7),
                     rows.real(8)});
  }
  return found;
}

namespace {

// Rows of costs or segments in the order of the runs, read once from front to back.
class PartRows {
 public:
  PartRows(Database& database, const std::string& sql)
      : rows_(database, sql), has_row_(rows_.step()) {}

  template <class Take>
  void take_of(std::int64_t run, Take take) {
    for (; has_row_ && rows_.integer(0) <= run; has_row_ = rows_.step())
      if (rows_.integer(0) == run) take(rows_);
  }

 private:
  Statement rows_;
  bool has_row_;
};

Segment segment_of(const Statement& row) { return {row.real(1), row.real(2), row.real(3)}; }

constexpr const char* columns_of_segments = "SELECT run, curvature, length, curvature_rate";

}  // namespace

std::vector<RunRecord> Store::runs() { return read_runs(Paths::whole); }

std::vector<RunRecord> Store::runs_without_segments() { return read_runs(Paths::start_only); }

std::vector<RunRecord> Store::read_runs(Paths paths) {
  // Others may add runs meanwhile. In one transaction all statements see the store as it is now.
  const Transaction one_state(database_);
  struct Configuration {
    std::string planner;
    SharedOptions options;
  };
  std::map<std::int64_t, Configuration> configurations;
  Statement configuration_rows(database_, "SELECT id, planner, options FROM configurations");
  while (configuration_rows.step()) {
    configurations[configuration_rows.integer(0)] = {configuration_rows.text(1),
                                                     options_from_json(configuration_rows.text(2))};
  }
  Statement rows(database_, fmt::format("SELECT {} FROM runs ORDER BY id", columns_of_runs));
  PartRows costs(database_, "SELECT run, time, iteration, cost FROM costs ORDER BY run, number");
  std::optional<PartRows> segments;
  if (paths == Paths::whole) {
    segments.emplace(database_,
                     fmt::format("{} FROM segments ORDER BY run, number", columns_of_segments));
  }
  std::vector<RunRecord> found;
  found.reserve(static_cast<std::size_t>(count_runs()));
  while (rows.step()) {
    RunRecord& run = found.emplace_back(run_of(rows));
    const Configuration& configuration = configurations.at(rows.integer(4));
    run.planner = configuration.planner;
    run.options = configuration.options;
    run.seed = static_cast<std::uint64_t>(rows.integer(6));
    costs.take_of(rows.integer(0), [&](const Statement& row) {
      run.result.anytime.push_back({row.real(1), row.integer(2), row.real(3)});
    });
    run.result.anytime.shrink_to_fit();
    if (!segments || !run.result.path) continue;
    segments->take_of(rows.integer(0), [&](const Statement& row) {
      run.result.path->segments.push_back(segment_of(row));
    });
  }
  return found;
}

void Store::read_segments(RunRecord& run) {
  if (!run.result.path) return;
  const std::int64_t id = id_of(run, configuration_of(run));
  Statement rows(database_, fmt::format("{} FROM segments WHERE run = ? ORDER BY number",
                                        columns_of_segments));
  rows.bind(id);
  run.result.path->segments.clear();
  while (rows.step()) run.result.path->segments.push_back(segment_of(rows));
}

}  // namespace vandplan::evaluation
