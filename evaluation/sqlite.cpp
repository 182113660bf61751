// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/sqlite.h"

#include <sqlite3.h>

#include <utility>

#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

int open_flags(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::read:
      return SQLITE_OPEN_READONLY;
    case Database::Mode::write:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::create:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return SQLITE_OPEN_READONLY;
}

}  // namespace

void Database::Close::operator()(sqlite3* handle) const noexcept { sqlite3_close_v2(handle); }

Database::Database(std::string file, Mode mode) : file_(std::move(file)) {
  sqlite3* handle = nullptr;
  const int status = sqlite3_open_v2(file_.c_str(), &handle, open_flags(mode), nullptr);
  handle_.reset(handle);
  if (status != SQLITE_OK) fail();
  sqlite3_busy_timeout(handle, 5000);
}

void Database::fail() const {
  throw InputError(file_, handle_ ? sqlite3_errmsg(handle_.get()) : "out of memory");
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

std::int64_t Database::integer(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

std::string Database::text(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.text(0) : std::string();
}

std::int64_t Database::last_id() const noexcept { return sqlite3_last_insert_rowid(handle_.get()); }

int Database::changed() const noexcept { return sqlite3_changes(handle_.get()); }

void Statement::Finalize::operator()(sqlite3_stmt* handle) const noexcept {
  sqlite3_finalize(handle);
}

Statement::Statement(Database& database, std::string_view sql) : database_(&database) {
  sqlite3_stmt* handle = nullptr;
  const int status = sqlite3_prepare_v2(database.handle_.get(), sql.data(),
                                        static_cast<int>(sql.size()), &handle, nullptr);
  handle_.reset(handle);
  if (status != SQLITE_OK) database.fail();
}

bool Statement::step() {
  const int status = sqlite3_step(handle_.get());
  if (status == SQLITE_ROW) return true;
  if (status != SQLITE_DONE) database_->fail();
  return false;
}

bool Statement::is_null(int column) const noexcept {
  return sqlite3_column_type(handle_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const noexcept {
  return sqlite3_column_int64(handle_.get(), column);
}

double Statement::real(int column) const noexcept {
  return sqlite3_column_double(handle_.get(), column);
}

std::optional<double> Statement::optional_real(int column) const noexcept {
  if (is_null(column)) return std::nullopt;
  return real(column);
}

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  return bytes == nullptr ? std::string() : std::string(bytes);
}

std::span<const std::byte> Statement::bytes(int column) const {
  const auto* const bytes =
      static_cast<const std::byte*>(sqlite3_column_blob(handle_.get(), column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

void Statement::reset() noexcept { sqlite3_reset(handle_.get()); }

void Statement::set(int index, std::int64_t value) {
  if (sqlite3_bind_int64(handle_.get(), index + 1, value) != SQLITE_OK) database_->fail();
}

void Statement::set(int index, double value) {
  if (sqlite3_bind_double(handle_.get(), index + 1, value) != SQLITE_OK) database_->fail();
}

void Statement::set(int index, std::string_view value) {
  if (sqlite3_bind_text(handle_.get(), index + 1, value.data(), static_cast<int>(value.size()),
                        SQLITE_TRANSIENT) != SQLITE_OK)
    database_->fail();
}

void Statement::set(int index, std::span<const std::byte> value) {
  if (sqlite3_bind_blob64(handle_.get(), index + 1, value.data(), value.size(), SQLITE_TRANSIENT) !=
      SQLITE_OK)
    database_->fail();
}

void Statement::set(int index, const std::optional<double>& value) {
  if (value) return set(index, *value);
  if (sqlite3_bind_null(handle_.get(), index + 1) != SQLITE_OK) database_->fail();
}

void Statement::set(int index, const std::optional<std::int64_t>& value) {
  if (value) return set(index, *value);
  if (sqlite3_bind_null(handle_.get(), index + 1) != SQLITE_OK) database_->fail();
}

Transaction::Transaction(Database& database) : database_(&database) { database.execute("BEGIN"); }

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_->execute("ROLLBACK");
  } catch (const InputError&) {  // SQLite has already rolled back
  }
}

void Transaction::commit() {
  database_->execute("COMMIT");
  open_ = false;
}

}  // namespace vandplan::evaluation
