// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does the command line do?
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <stdexcept>
#include <system_error>

#include "commands.h"
#include "standard_streams.h"
#include "usage.h"
#include "vandplan/input_error.h"
#include "version_text.h"
#include "wording.h"

namespace vandplan::app {
namespace {

constexpr AddCommand commands[] = {add_plan,  add_check,   add_draw,     add_speed,
                                   add_drive, add_smooth,  add_evaluate, add_table,
                                   add_study, add_convert, add_planners, add_matrix};

/// Prints a problem on one line of standard error; returns `status`.
int complain(std::string problem, int status) {
  std::replace(problem.begin(), problem.end(), '\n', ' ');
  say(fmt::format("vandplan: {}\n", printable(problem)));
  return status;
}

/// Prints that memory ran out, without allocating any; returns the exit status.
int complain_of_memory() noexcept {
  say("vandplan: out of memory\n");
  return exit_status::bad_input;
}

int run(int argc, char** argv) {
  int status = exit_status::done;
  CLI::App app("Plans paths for trucks and buses.", "vandplan");
  app.set_help_flag("-h,--help", "Print help");
  app.set_version_flag("--version", version_text(), "Print the version");
  app.require_subcommand(0, 1);
  for (const AddCommand add : commands) add(app, status);
  app.footer("Exit status: 0 done, 1 failed, 2 bad input.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(usage_problem(app, error, {argv + 1, argv + argc}), exit_status::bad_input);
  }
  if (!app.get_subcommands().empty()) return status;
  return complain("a command is missing, see vandplan --help", exit_status::bad_input);
}

}  // namespace

constexpr auto replace_bad_text = nlohmann::ordered_json::error_handler_t::replace;

void add_scenario(CLI::App& command, std::string& scenario) {
  command.add_option("SCENARIO", scenario, "Scenario (YAML); - is standard input")->required();
}

void add_scenario_and_result(CLI::App& command, std::string& scenario, std::string& result) {
  add_scenario(command, scenario);
  command.add_option("RESULT", result, "Result (JSON, JSON Lines or binary)")->required();
}

void print(const nlohmann::ordered_json& object) {
  fmt::print("{}\n", base::json_text(object.dump(2, ' ', false, replace_bad_text)));
}

void print_line(const nlohmann::ordered_json& object) {
  fmt::print("{}\n", base::json_text(object.dump(-1, ' ', false, replace_bad_text)));
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    say(fmt::format("vandplan: warning: {}\n", printable(warning)));
  }
}

namespace {

/// Runs the program and prints its errors; returns the exit status. Throws std::bad_alloc if memory
/// runs out.
int answer(int argc, char** argv) {
  try {
    const int status = run(argc, argv);
    if (std::fflush(stdout) == 0) return status;
    return complain(fmt::format("standard output: cannot write: {}", std::strerror(errno)),
                    exit_status::bad_input);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::length_error&) {  // larger than a container can be
    throw std::bad_alloc();
  } catch (const InputError& error) {
    return complain(error.what(), exit_status::bad_input);
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) {
      return complain("standard output: cannot write: " + error.code().message(),
                      exit_status::bad_input);
    }
    const bool lacks_room = error.code() == std::errc::not_enough_memory ||
                            error.code() == std::errc::resource_unavailable_try_again;  // no thread
    if (lacks_room) throw std::bad_alloc();
    return complain(error.what(), exit_status::failed);
  } catch (const std::exception& error) {
    return complain(error.what(), exit_status::failed);
  }
}

}  // namespace
}  // namespace vandplan::app

int main(int argc, char** argv) {
  vandplan::app::open_standard_streams();
  try {
    return vandplan::app::answer(argc, argv);
  } catch (const std::bad_alloc&) {  // thrown by the run, or by printing an error
    return vandplan::app::complain_of_memory();
  }
}
