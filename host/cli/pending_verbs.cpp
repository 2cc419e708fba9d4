// Empty weak verbs, so that the program links while the rooms are being filled; goes when every verb is there.
#include "cli/verbs.h"
namespace capcon::cli {
__attribute__((weak)) void add_points_verb(CLI::App&) {}
__attribute__((weak)) void add_measure_verb(CLI::App&) {}
__attribute__((weak)) void add_tiles_verb(CLI::App&) {}
__attribute__((weak)) void add_render_verb(CLI::App&) {}
__attribute__((weak)) void add_compare_verb(CLI::App&) {}
__attribute__((weak)) void add_info_verb(CLI::App&) {}
__attribute__((weak)) void add_study_verb(CLI::App&) {}
}  // namespace capcon::cli
