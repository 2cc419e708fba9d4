#pragma once

#include <CLI/CLI.hpp>

namespace capcon::cli {

// One small file a verb: it declares its options and sets a callback that does the work. Results go to stdout
// (one JSON value with --json), messages and progress to stderr, errors leave as InputError or Failure.
void add_points_verb(CLI::App& app);
void add_measure_verb(CLI::App& app);
void add_partition_verb(CLI::App& app);
void add_tiles_verb(CLI::App& app);
void add_ensembles_verb(CLI::App& app);
void add_export_verb(CLI::App& app);
void add_render_verb(CLI::App& app);
void add_compare_verb(CLI::App& app);
void add_check_verb(CLI::App& app);
void add_bench_verb(CLI::App& app);
void add_info_verb(CLI::App& app);
void add_study_verb(CLI::App& app);
void add_serve_verb(CLI::App& app);
void add_merge_verb(CLI::App& app);
void add_report_verb(CLI::App& app);
void add_integrate_verb(CLI::App& app);
void add_stability_verb(CLI::App& app);
/// man and completion, made from the tables of all others: to be added last.
void add_documentation_verbs(CLI::App& app);

}  // namespace capcon::cli
