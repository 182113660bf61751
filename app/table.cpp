// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan table: how are heuristic tables made, looked into, checked and handed on?
#include <fmt/format.h>

#include <cctype>
#include <chrono>
#include <memory>
#include <optional>

#include "commands.h"
#include "option_flags.h"
#include "studies/table_check.h"
#include "table_site.h"
#include "table_source.h"
#include "tables/table_export.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/tables.h"
#include "wording.h"

namespace vandplan::app {

using namespace studies;

namespace {

using Json = nlohmann::ordered_json;
using Content = TableFileHead::Content;

// ---- build ----

struct BuildArguments {
  std::string name;
  std::optional<double> extent, step, radius;
  std::optional<int> headings;
  std::string output;
  bool json = false;
};

HeuristicTableOptions options_of(const BuildArguments& arguments) {
  const auto number = thesis_number(arguments.name);
  if (!number && !arguments.name.empty()) {
    throw InputError("table", fmt::format("\"{}\" is unknown, expected hlut-1 to hlut-4 or bounds",
                                          arguments.name));
  }
  HeuristicTableOptions options = number ? thesis_table_options(*number) : HeuristicTableOptions{};
  options.extent = arguments.extent.value_or(options.extent);
  options.step = arguments.step.value_or(options.step);
  options.turning_radius = arguments.radius.value_or(options.turning_radius);
  options.heading_cells = arguments.headings.value_or(options.heading_cells);
  return options;
}

/// Computes a table. Throws InputError naming the flag that was typed.
HeuristicTable filled(const HeuristicTableOptions& options) {
  try {
    return HeuristicTable(options);
  } catch (const InputError& error) {
    std::string flag = error.where();
    if (flag == "heading_cells") flag = "headings";
    if (flag == "turning_radius") flag = "radius";
    throw InputError("--" + flag, error.problem());
  }
}

std::string bounds_built(const BuildArguments& arguments) {
  if (arguments.extent || arguments.step || arguments.radius || arguments.headings) {
    throw InputError(bounds_name, "has no options: one table serves every radius and distance");
  }
  return bound_table_to_bytes();
}

void build(const BuildArguments& arguments) {
  expect_writable(arguments.output);
  const auto begin = std::chrono::steady_clock::now();
  const std::string bytes = arguments.name == bounds_name
                                ? bounds_built(arguments)
                                : table_to_bytes(filled(options_of(arguments)));
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  write_file(arguments.output, bytes);
  if (arguments.output == "-") return;
  const TableFileHead head = table_file_head(bytes, arguments.output);
  if (arguments.json) {
    Json json = {{"output", arguments.output}, {"time", time.count()}};
    json.update(json_of(head));
    print(json);
  } else {
    fmt::print("{}: {}  built in        {:.3f} s\n", printable(arguments.output), text_of(head),
               time.count());
  }
}

// ---- check ----

struct TableCheckArguments {
  std::string table;
  EntryCheckOptions options;
  bool json = false;
};

constexpr std::int64_t default_pairs = 1'000'000;

int check_of_lengths(const TableSource& source, const TableCheckArguments& arguments) {
  const HeuristicTable table = table_from_bytes(source.bytes, source.name);
  const EntryCheck check = check_entries(table, arguments.options);
  const Pose node = table.node_of(check.worst);
  const Pose sample = table.sample_of(check.worst);
  const bool good = check.wrong == 0;
  if (arguments.json) {
    Json json = {{"table", source.name},
                 {"checksum", checksum_text(source.head)},
                 {"entries", source.head.entries},
                 {"compared", check.compared},
                 {"wrong", check.wrong},
                 {"worst_difference", check.worst_difference},
                 {"good", good}};
    print(json);
  } else {
    fmt::print("{}: checksum is correct; {} of {} entries compared with exact lengths\n",
               printable(source.name), check.compared, source.head.entries);
    fmt::print(
        "worst difference {:.2g} m, from x {} m, y {} m, heading {:.4f} rad to heading {:.4f} "
        "rad\n",
        check.worst_difference, node.x, node.y, node.heading, sample.heading);
    fmt::print("{}\n",
               good ? "good: every difference is a rounding error"
                    : fmt::format("WRONG: {} entries are not the exact length", check.wrong));
  }
  return good ? exit_status::done : exit_status::failed;
}

int check_of_bounds(const TableSource& source, const TableCheckArguments& arguments) {
  const bool same = source.bytes == bound_table_to_bytes();
  const BoundCheck check =
      check_bounds(arguments.options.sample.value_or(default_pairs), arguments.options.seed);
  const bool good = same && check.outside == 0;
  if (arguments.json) {
    print({{"table", source.name},
           {"checksum", checksum_text(source.head)},
           {"same_as_library", same},
           {"pairs", check.pairs},
           {"outside", check.outside},
           {"median_gap", check.median_gap},
           {"gap_95", check.gap_95},
           {"good", good}});
  } else {
    fmt::print("{}: checksum is correct; {} the table of this library\n", printable(source.name),
               same ? "is" : "IS NOT");
    fmt::print(
        "{} random pairs: {} exact lengths outside of the library's bounds\n"
        "high - low: median {:.2g}, 95 % below {:.2g} turning radii\n",
        check.pairs, check.outside, check.median_gap, check.gap_95);
    fmt::print("{}\n", good ? "good" : "WRONG");
  }
  return good ? exit_status::done : exit_status::failed;
}

int check(const TableCheckArguments& arguments) {
  const TableSource source = table_source(arguments.table);
  return source.head.content == Content::bounds ? check_of_bounds(source, arguments)
                                                : check_of_lengths(source, arguments);
}

// ---- export ----

struct ExportArguments {
  std::string table;
  std::string output;
  std::string format;
  std::string name;
  bool json = false;
};

/// Format of an export, "header" or "csv": by --format, or else by the ending of the file.
std::string format_of(const ExportArguments& arguments) {
  if (!arguments.format.empty()) return arguments.format;
  if (arguments.output.ends_with(".csv")) return "csv";
  if (arguments.output.ends_with(".h") || arguments.output.ends_with(".hpp")) return "header";
  throw InputError(arguments.output, "must end in .h, .hpp or .csv, or --format must be given");
}

/// The name of the table as an identifier: "out/hlut-4.table" gives "hlut_4".
std::string identifier_of(const std::string& table) {
  std::string name = table.substr(table.rfind('/') + 1);
  name = name.substr(0, name.find('.'));
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) name = "table_" + name;
  return name;
}

std::string exported(const TableSource& source, bool is_csv, const std::string& name) {
  if (source.head.content == Content::bounds) {
    if (source.bytes != bound_table_to_bytes()) {
      throw InputError(source.name, "is not this library's table of bounds, expected that one");
    }
    return is_csv ? tables::bound_table_to_csv() : tables::bound_table_to_header(name);
  }
  const HeuristicTable table = table_from_bytes(source.bytes, source.name);
  return is_csv ? tables::table_to_csv(table) : tables::table_to_header(table, name);
}

void export_table(const ExportArguments& arguments) {
  const std::string format = format_of(arguments);
  expect_writable(arguments.output);
  const TableSource source = table_source(arguments.table);
  const std::string name = arguments.name.empty() ? identifier_of(source.name) : arguments.name;
  write_file(arguments.output, exported(source, format == "csv", name));
  if (arguments.output == "-") return;
  if (arguments.json) {
    Json json = {{"table", source.name}, {"output", arguments.output}, {"format", format}};
    if (format == "header") json["namespace"] = name;
    json["entries"] = source.head.entries;
    print(json);
  } else {
    fmt::print("{}: {} entries written to {}{}\n", printable(source.name), source.head.entries,
               printable(arguments.output),
               format == "header" ? fmt::format(", namespace {}, array entries", name) : "");
  }
}

// ---- the command line ----

constexpr const char* table_help = "hlut-1 to hlut-4, bounds, or a file; - is standard input";

void add_json(CLI::App& command, bool& json) { command.add_flag("--json", json, "Print JSON"); }

void add_table_build(CLI::App& table) {
  CLI::App* const command = table.add_subcommand("build", "Compute a table and write it.");
  const auto arguments = std::make_shared<BuildArguments>();
  const auto add = [&](const char* flag, auto& value, const char* type, const char* help) {
    command->add_option(flag, value, help)->type_name(type)->take_last();
  };
  command
      ->add_option("NAME", arguments->name,
                   "hlut-1 (default) to hlut-4: thesis tables, changed by the options;\n"
                   "bounds: certified bounds of the library")
      ->type_name("");
  add("--extent", arguments->extent, "M",
      "Largest |dx| and |dy| [m], a multiple of the step;\n10 (hlut-2: 20, hlut-4: 30)");
  add("--step", arguments->step, "M", "Step of positions [m]; 1");
  add("--headings", arguments->headings, "N", "Headings per turn; 8 (hlut-3, hlut-4: 24)");
  add("--radius", arguments->radius, "M", "Turning radius [m]; 7");
  command->add_option("-o,--output", arguments->output, "Table file")
      ->type_name("FILE")
      ->required();
  add_json(*command, arguments->json);
  command->callback([arguments] { build(*arguments); });
}

void add_table_info(CLI::App& table) {
  CLI::App* const command =
      table.add_subcommand("info", "Describe a table, after a test of size and checksum.");
  const auto name = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  command->add_option("TABLE", *name, std::string(table_help) + "; FILE.vst: of a site")
      ->required()
      ->type_name("");
  add_json(*command, *json);
  command->callback([name, json] {
    if (name->ends_with(".vst")) return print_site_table(*name, *json);
    const TableSource source = table_source(*name);
    if (*json) {
      Json object = {{"table", source.name}};
      object.update(json_of(source.head));
      print(object);
    } else {
      fmt::print("{}: {}", printable(source.name), text_of(source.head));
    }
  });
}

void add_table_check(CLI::App& table, int& status) {
  CLI::App* const command = table.add_subcommand(
      "check", "Compare a table with exact lengths and report the worst entry.");
  const auto arguments = std::make_shared<TableCheckArguments>();
  command->add_option("TABLE", arguments->table, table_help)->required()->type_name("");
  command
      ->add_option("--sample", arguments->options.sample,
                   fmt::format("Random entries, 1 to 100000000; default: all (bounds: {} pairs)",
                               default_pairs))
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{100'000'000}).description(""))
      ->take_last();
  add_seed(*command, arguments->options.seed, "Random seed")->take_last();
  add_json(*command, arguments->json);
  command->footer("Exit status: 0 good, 1 wrong, 2 bad input.");
  command->callback([arguments, &status] { status = check(*arguments); });
}

void add_table_export(CLI::App& table) {
  CLI::App* const command = table.add_subcommand("export", "Write a table as a C++ header or CSV.");
  const auto arguments = std::make_shared<ExportArguments>();
  command->add_option("TABLE", arguments->table, table_help)->required()->type_name("");
  command->add_option("-o,--output", arguments->output, "File (.h, .hpp or .csv)")
      ->type_name("FILE")
      ->required();
  command->add_option("--format", arguments->format, "Format, whatever the ending")
      ->check(CLI::IsMember({"header", "csv"}).description(""))
      ->type_name("header|csv")
      ->take_last();
  command
      ->add_option("--name", arguments->name, "Namespace of the header; default: name of the table")
      ->type_name("NAME")
      ->take_last();
  add_json(*command, arguments->json);
  command->callback([arguments] { export_table(*arguments); });
}

}  // namespace

void add_table(CLI::App& vandplan, int& status) {
  CLI::App* const table = vandplan.add_subcommand(
      "table", "Build, describe, check and export look-up tables; make one of a site.");
  table->require_subcommand(0, 1);
  table->callback([table] {
    if (!table->get_subcommands().empty()) return;
    throw InputError("table", "a command is missing, expected build, info, check, export or site");
  });
  add_table_build(*table);
  add_table_info(*table);
  add_table_check(*table, status);
  add_table_export(*table);
  add_table_site(*table, status);
}

}  // namespace vandplan::app
