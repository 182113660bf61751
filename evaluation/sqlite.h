// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is SQLite used with values and exceptions? A connection and a statement, nothing more.
//
// Every failure is an InputError "FILE: what SQLite says".

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace vandplan::evaluation {

/// An open database file. One thread at a time.
class Database {
 public:
  enum class Mode { read, write, create };
  Database(std::string file, Mode mode);

  /// Runs statements that return nothing.
  void execute(const std::string& sql);
  /// First column of the first row; 0 or empty if there is no row.
  [[nodiscard]] std::int64_t integer(const std::string& sql);
  [[nodiscard]] std::string text(const std::string& sql);
  [[nodiscard]] std::int64_t last_id() const noexcept;
  /// Number of rows that the last INSERT, UPDATE or DELETE changed.
  [[nodiscard]] int changed() const noexcept;

  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[noreturn]] void fail() const;

 private:
  friend class Statement;
  struct Close {
    void operator()(sqlite3* handle) const noexcept;
  };
  std::string file_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement. Parameters and columns count from 0. Must not outlive its database.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  /// Resets the statement and sets all parameters, in order.
  template <class... Values>
  Statement& bind(const Values&... values) {
    reset();
    int index = 0;
    (set(index++, values), ...);
    return *this;
  }
  /// Binds the values and runs the statement to its end.
  template <class... Values>
  void run(const Values&... values) {
    bind(values...);
    while (step()) {
    }
  }
  /// Goes to the next row; false when there is none.
  bool step();
  /// Releases the current row; an open row keeps the write-ahead log from being cleared.
  void reset() noexcept;

  [[nodiscard]] bool is_null(int column) const noexcept;
  [[nodiscard]] std::int64_t integer(int column) const noexcept;
  [[nodiscard]] double real(int column) const noexcept;
  [[nodiscard]] std::optional<double> optional_real(int column) const noexcept;
  [[nodiscard]] std::string text(int column) const;
  /// Bytes of a column; valid until the next step.
  [[nodiscard]] std::span<const std::byte> bytes(int column) const;

 private:
  void set(int index, std::int64_t value);
  void set(int index, int value) { set(index, std::int64_t{value}); }
  void set(int index, double value);
  void set(int index, std::string_view value);
  void set(int index, std::span<const std::byte> value);
  void set(int index, const std::optional<double>& value);
  void set(int index, const std::optional<std::int64_t>& value);

  struct Finalize {
    void operator()(sqlite3_stmt* handle) const noexcept;
  };
  Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// Transaction: all statements up to `commit` take effect, or none does.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database* database_;
  bool open_ = true;
};

}  // namespace vandplan::evaluation
